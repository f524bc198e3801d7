// SPDX-License-Identifier: Apache-2.0
//
// The traversals, one per instruction set, and the choice between them at run time.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "bvh/view.h"
#include "kernel/types.h"

namespace snell::bvh {

enum class InstructionSet { Portable, Sse42, Avx2, Avx512 };

// The two queries of Bvh for one instruction set.
struct Traversal {
  void (*closest)(const View&, const kernel::Ray&, float tMax, std::uint32_t mask,
                  Intersection& found);
  bool (*any)(const View&, const kernel::Ray&, float tMax, std::uint32_t mask);
  void (*closestMany)(const View&, const Query*, std::size_t count, std::uint32_t mask,
                      Intersection* found);
  void (*anyMany)(const View&, const Query*, std::size_t count, std::uint32_t mask, bool* hit);
};

// "AVX-512", for messages.
std::string_view NameOf(InstructionSet set);

// Those that this build has and this processor runs, slowest first. There is at least one.
const std::vector<InstructionSet>& SupportedInstructionSets();

// The best of them, or the one that the environment variable SNELL_ISA names (portable, sse4.2, avx2,
// avx512) if it is supported.
InstructionSet BestInstructionSet();

// The traversal of a supported set.
const Traversal& TraversalFor(InstructionSet set);

}  // namespace snell::bvh
