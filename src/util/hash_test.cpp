// SPDX-License-Identifier: Apache-2.0
//
// The checksum: the same however the bytes arrive, another one after any change.
#include "util/hash.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace snell {
namespace {

std::uint64_t HashOf(const std::string& bytes) {
  Hasher hasher;
  hasher.Add(bytes.data(), bytes.size());
  return hasher.Value();
}

std::string Bytes(std::size_t count) {
  std::string bytes;
  for (std::size_t i = 0; i < count; ++i) bytes += char(i * i * 31 + i);
  return bytes;
}

TEST(Hasher, TakesBytesInAnyPieces) {
  const std::string bytes = Bytes(200);
  for (const std::size_t piece : {1u, 3u, 8u, 31u, 32u, 33u, 100u}) {
    Hasher hasher;
    for (std::size_t i = 0; i < bytes.size(); i += piece)
      hasher.Add(bytes.data() + i, std::min(piece, bytes.size() - i));
    EXPECT_EQ(hasher.Value(), HashOf(bytes)) << piece;
    EXPECT_EQ(hasher.Value(), hasher.Value()) << "asking changes nothing";
  }
}

TEST(Hasher, SeesEveryBitAndTheLength) {
  std::set<std::uint64_t> seen;
  std::size_t count = 0;
  for (std::size_t size = 0; size <= 70; ++size, ++count) seen.insert(HashOf(Bytes(size)));
  for (std::size_t zeros = 1; zeros <= 70; ++zeros, ++count)
    seen.insert(HashOf(std::string(zeros, '\0')));
  for (std::size_t bit = 0; bit < 70 * 8; ++bit, ++count) {
    std::string bytes = Bytes(70);
    bytes[bit / 8] = char(bytes[bit / 8] ^ (1 << bit % 8));
    seen.insert(HashOf(bytes));
  }
  // One zero byte alone is also Bytes(1)
  EXPECT_EQ(seen.size(), count - 1);
}

TEST(Hasher, PrintsSixteenDigits) {
  EXPECT_EQ(Hasher().Text().size(), 16u);
  EXPECT_EQ(Hasher().Text().find_first_not_of("0123456789abcdef"), std::string::npos);
}

}  // namespace
}  // namespace snell
