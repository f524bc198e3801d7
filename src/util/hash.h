// SPDX-License-Identifier: Apache-2.0
//
// A checksum of 64 bits over a stream of bytes, for telling inputs apart and noticing damage; not against those who
// mean harm. Four lanes of multiplications take the words in turns, several GB/s. Every step can be undone, so a
// change within one word always changes the sum.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace snell {

class Hasher {
 public:
  void Add(const void* bytes, std::size_t size);
  // Of all that was added so far.
  std::uint64_t Value() const;
  // As 16 hexadecimal digits.
  std::string Text() const;

 private:
  void AddBlock(const unsigned char* block);

  std::array<std::uint64_t, 4> lanes_ = {1, 2, 3, 4};
  std::array<unsigned char, 32> rest_{};  // bytes that wait for a block to be full
  std::size_t restSize_ = 0;
  std::uint64_t size_ = 0;
};

}  // namespace snell
