// SPDX-License-Identifier: Apache-2.0
//
// What a render did: rays by kind, seconds by phase, bytes by owner.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kernel/types.h"
#include "render/schedule.h"

namespace snell::render {

struct RayTotals {
  std::uint64_t camera = 0;
  std::uint64_t reflected = 0;
  std::uint64_t refracted = 0;
  std::uint64_t shadow = 0;

  void Add(const kernel::RayCounts& counts) {
    camera += counts.camera;
    reflected += counts.reflected;
    refracted += counts.refracted;
    shadow += counts.shadow;
  }
  void Add(const RayTotals& other) {
    camera += other.camera;
    reflected += other.reflected;
    refracted += other.refracted;
    shadow += other.shadow;
  }
  std::uint64_t Sum() const { return camera + reflected + refracted + shadow; }
};

// A sample whose radiance was not finite; it counted as black.
struct NonFiniteSample {
  int x = 0;
  int y = 0;
  std::uint32_t sample = 0;
};

struct Statistics {
  End end = End::Samples;
  std::string fault;  // of the device, that ended the render
  RayTotals rays;
  std::uint64_t samples = 0;
  std::uint64_t nonFiniteSamples = 0;
  std::vector<NonFiniteSample> nonFinite;  // the first few of them
  double heldBack = 0;                     // of all light: the share that clampIndirect has removed
  std::uint64_t droppedBranches = 0;       // of ray trees too wide for the integrator's stack
  std::uint64_t droppedPrimitives = 0;     // with coordinates that are not finite

  std::vector<std::string> warnings;  // of the scene's preparation

  int threads = 0;
  std::string device;  // "CPU, AVX-512"
  double flattenSeconds = 0;
  double buildSeconds = 0;
  double renderSeconds = 0;
  std::uint64_t sceneBytes = 0;  // the flattened scene
  std::uint64_t bvhBytes = 0;
  std::uint64_t filmBytes = 0;
};

}  // namespace snell::render
