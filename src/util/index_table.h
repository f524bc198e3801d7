// SPDX-License-Identifier: Apache-2.0
//
// A hash table of indices into an array that the caller owns: finds the element equal to a given one, or
// admits it. It joins equal vertices; std::unordered_map would take a node on the heap for each of them.
// Open addressing with linear probing (Knuth, volume 3, section 6.4, algorithm L). The mixing function is
// MurmurHash3's finaliser (Appleby 2011).
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

namespace snell {

inline std::uint64_t MixBits(std::uint64_t h) {
  h = (h ^ (h >> 33)) * 0xff51afd7ed558ccdull;
  h = (h ^ (h >> 33)) * 0xc4ceb9fe1a85ec53ull;
  return h ^ (h >> 33);
}

inline std::uint64_t HashOf(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  return MixBits(MixBits(std::uint64_t(a) | std::uint64_t(b) << 32) + c);
}

class IndexTable {
 public:
  // For about `expected` different elements; it grows if there are more.
  explicit IndexTable(std::size_t expected)
      : slots_(std::bit_ceil(std::max<std::size_t>(16, expected + expected / 2))) {}

  // The index of the element that equals the given one; or `next`, which becomes its index. `equals(i)`
  // tells whether element i does.
  template <class Equals>
  std::uint32_t FindOrAdd(std::uint64_t hash, std::uint32_t next, const Equals& equals) {
    const std::uint32_t tag = std::uint32_t(hash >> 32);
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = tag & mask;
    for (; slots_[at].index != Empty; at = (at + 1) & mask)
      if (slots_[at].tag == tag && equals(slots_[at].index)) return slots_[at].index;

    slots_[at] = {tag, next};
    if (++count_ > slots_.size() / 4 * 3) Grow();
    return next;
  }

 private:
  static constexpr std::uint32_t Empty = 0xffffffffu;
  struct Slot {
    std::uint32_t tag = 0;
    std::uint32_t index = Empty;
  };

  void Grow() {
    std::vector<Slot> old(slots_.size() * 2);
    std::swap(old, slots_);
    const std::size_t mask = slots_.size() - 1;
    for (const Slot& slot : old) {
      if (slot.index == Empty) continue;
      std::size_t at = slot.tag & mask;
      while (slots_[at].index != Empty) at = (at + 1) & mask;
      slots_[at] = slot;
    }
  }

  std::vector<Slot> slots_;  // a power of two, never full
  std::size_t count_ = 0;
};

}  // namespace snell
