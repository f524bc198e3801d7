// SPDX-License-Identifier: Apache-2.0
//
// Arrays for what rays read at random: large ones lie on huge pages where the system has them, so that a step
// of a ray seldom waits for an address to be translated. New elements are left uninitialised.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace snell::bvh {

inline constexpr std::size_t HugePageSize = std::size_t(2) << 20;

template <class T>
struct HugePageAllocator {
  using value_type = T;

  HugePageAllocator() = default;
  template <class U>
  HugePageAllocator(const HugePageAllocator<U>&) {}

  // Throws std::bad_alloc.
  T* allocate(std::size_t count) {
    const bool large = count * sizeof(T) >= HugePageSize;
    const std::size_t alignment = large ? HugePageSize : 64;
    const std::size_t bytes = (count * sizeof(T) + alignment - 1) / alignment * alignment;
    void* memory = std::aligned_alloc(alignment, bytes);
    if (memory == nullptr) throw std::bad_alloc();
#ifdef __linux__
    if (large) madvise(memory, bytes, MADV_HUGEPAGE);
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }

  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    // A box's own initialisation would have one thread write, and the system provide, every page
    static_assert(std::is_trivially_copyable_v<U> && std::is_trivially_destructible_v<U>);
    if constexpr (sizeof...(Arguments) > 0)
      ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }

  bool operator==(const HugePageAllocator&) const { return true; }
};

template <class T>
using HugeVector = std::vector<T, HugePageAllocator<T>>;

}  // namespace snell::bvh
