// SPDX-License-Identifier: Apache-2.0
#include "fuzz/png_checksums.h"

#include <cstddef>
#include <cstdint>

namespace snell::fuzz {

namespace {

// CRC-32 as the PNG specification has it, section "CRC algorithm"; bit by bit.
std::uint32_t Checksum(std::string_view bytes) {
  std::uint32_t sum = 0xffffffffu;
  for (const char byte : bytes) {
    sum ^= std::uint8_t(byte);
    for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (sum & 1 ? 0xedb88320u : 0u);
  }
  return ~sum;
}

std::uint32_t NumberAt(std::string_view bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) number = number << 8 | std::uint8_t(bytes[at + i]);
  return number;
}

}  // namespace

std::string WithPngChecksums(std::string_view file) {
  constexpr std::size_t Signature = 8, Head = 8, Sum = 4;  // a chunk's head: length and type
  std::string repaired(file);
  for (std::size_t at = Signature; at + Head + Sum <= file.size();) {
    const std::size_t length = NumberAt(file, at);
    if (length > file.size() - at - Head - Sum) break;
    const std::uint32_t sum = Checksum(file.substr(at + 4, 4 + length));
    at += Head + length;
    for (int shift = 24; shift >= 0; shift -= 8) repaired[at++] = char(sum >> shift & 0xff);
  }
  return repaired;
}

}  // namespace snell::fuzz
