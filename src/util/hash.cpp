// SPDX-License-Identifier: Apache-2.0
#include "util/hash.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>

namespace snell {

namespace {

// Odd, with bits all over: the golden ratio's fraction.
constexpr std::uint64_t Multiplier = 0x9e3779b97f4a7c15u;

std::uint64_t Mix(std::uint64_t lane, std::uint64_t word) {
  const std::uint64_t product = (std::rotl(lane, 29) ^ word) * Multiplier;
  // Without this, changes of the highest bits stay where they are and can meet others
  return product ^ (product >> 32);
}

}  // namespace

void Hasher::AddBlock(const unsigned char* block) {
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    std::uint64_t word;
    std::memcpy(&word, block + 8 * i, sizeof word);
    lanes_[i] = Mix(lanes_[i], word);
  }
}

void Hasher::Add(const void* bytes, std::size_t size) {
  const unsigned char* from = static_cast<const unsigned char*>(bytes);
  size_ += size;
  if (restSize_ > 0) {
    const std::size_t taken = std::min(size, rest_.size() - restSize_);
    std::copy_n(from, taken, rest_.begin() + std::ptrdiff_t(restSize_));
    restSize_ += taken;
    from += taken;
    size -= taken;
    if (restSize_ < rest_.size()) return;
    AddBlock(rest_.data());
    restSize_ = 0;
  }
  for (; size >= rest_.size(); from += rest_.size(), size -= rest_.size()) AddBlock(from);
  std::copy_n(from, size, rest_.begin());
  restSize_ = size;
}

std::uint64_t Hasher::Value() const {
  Hasher last = *this;
  std::fill(last.rest_.begin() + std::ptrdiff_t(last.restSize_), last.rest_.end(), 0);
  last.AddBlock(last.rest_.data());
  std::uint64_t value = size_;
  for (const std::uint64_t lane : last.lanes_) value = Mix(value, lane);
  return value;
}

std::string Hasher::Text() const { return fmt::format("{:016x}", Value()); }

}  // namespace snell
