// SPDX-License-Identifier: Apache-2.0
#include "util/utf8.h"

namespace snell {

std::size_t Utf8Length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char head = byte(0);
  if (head < 0x80) return 1;
  std::size_t length = 0;
  if (head >= 0xC2 && head < 0xE0) length = 2;
  if (head >= 0xE0 && head < 0xF0) length = 3;
  if (head >= 0xF0 && head < 0xF5) length = 4;
  if (length == 0 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  const bool overlong = (head == 0xE0 && byte(1) < 0xA0) || (head == 0xF0 && byte(1) < 0x90);
  const bool surrogate = head == 0xED && byte(1) >= 0xA0;
  const bool beyond = head == 0xF4 && byte(1) >= 0x90;
  return overlong || surrogate || beyond ? 0 : length;
}

}  // namespace snell
