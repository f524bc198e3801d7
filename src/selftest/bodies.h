// SPDX-License-Identifier: Apache-2.0
//
// Bodies of all sorts of physical materials, and the scattering at a point of one.
#pragma once

#include <memory>

#include "cpu/kernel.h"
#include "selftest/scenes.h"

namespace snell::selftest {

struct Body {
  const char* name;
  double tolerance;  // of the light in a furnace
  double asymmetry;  // of light that goes there and back (reciprocity.cpp), at most
  void (*shape)(scene::Material&, float roughness);
  const char* approximation = "";  // that its light in a furnace owes its tolerance to
};

// Bodies that absorb nothing.
const std::vector<Body>& Bodies();

// A scene as devices see it.
class Prepared {
 public:
  explicit Prepared(const scene::Scene& scene);
  cpu::Kernel& kernel() { return kernel_; }

 private:
  std::unique_ptr<cpu::FlatScene> flat_;
  std::unique_ptr<bvh::Bvh> bvh_;
  cpu::Kernel kernel_;
};

// The surface of a body of one material, in empty space.
class Surface {
 public:
  explicit Surface(const scene::Material& material);
  // Its scattering as seen from wo, in its own frame, from outside or inside.
  kernel::Bsdf At(kernel::vec3 wo, bool inside = false);
  bool IsClosed();  // has an inside that light reaches

 private:
  Prepared prepared_;
};

// A direction by its cosine with z and its azimuth.
kernel::vec3 DirectionAt(float cosine, float azimuth);

}  // namespace snell::selftest
