// SPDX-License-Identifier: Apache-2.0
//
// Whether the contestants answer alike, and who is right where they do not.
#pragma once

#include <cstdint>
#include <string>

#include "rays/brute_force.h"
#include "rays/measure.h"

namespace snell::bench {

// Numbers of rays whose answers differ.
struct Difference {
  std::uint64_t hits = 0;       // one hits, the other does not
  std::uint64_t distances = 0;  // both hit, at another t: by more than 1e-4 of it
};

struct Disagreements {
  // Snell with itself, to the bit: its builds, closest and any, single rays and batches, with and without
  // denormals
  std::uint64_t itself = 0;
  Difference embree,
      robust;  // Snell's fast build and Embree's medium one, also with its robust flag
  // Of so many rays, those whose answer is beyond what rounding explains
  std::uint64_t judged = 0;
  std::uint64_t wrongSnell = 0;
  std::uint64_t wrongEmbree = 0;
  // Of the judged rays on which Snell and Embree differ, those on which the one is nearer to the truth
  std::uint64_t nearerSnell = 0;
  std::uint64_t nearerEmbree = 0;
};

struct Judges {
  const Contestant& fast;
  const Contestant& high;
  const Contestant& batches;
  const Contestant& embree;
  const Contestant& robust;
  const BruteForce& bruteForce;
};

// All rays by the contestants; by brute force about `count` > 0 of them, evenly spread, and as many of those on
// which Snell and Embree differ. The first rays that Snell gets wrong are described on the standard error output.
Disagreements Check(const Judges& judges, const Workload& workload, std::size_t count);

}  // namespace snell::bench
