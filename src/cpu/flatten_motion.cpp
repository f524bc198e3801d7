// SPDX-License-Identifier: Apache-2.0
#include "cpu/flatten_motion.h"

#include "scene/motion.h"

namespace snell::cpu {

using namespace kernel;

MotionKey KeyOfPlace(const scene::Affine& place) {
  const auto column = [&](int i) { return vec3(glm::dvec3(place[i])); };
  return {column(0), column(1), column(2), column(3)};
}

void FlattenMotion(const scene::Motion& motion, const Shutter& shutter,
                   MotionKey (*keyOf)(const scene::Affine& place), FlatScene& flat, uint& firstKey,
                   uint& steps) {
  firstKey = None;
  steps = 0;
  if (!scene::IsMoving(motion, shutter.open, shutter.close)) return;
  firstKey = uint(flat.motions.size());
  steps = uint(scene::StepsOf(motion, shutter.open, shutter.close));
  for (uint i = 0; i <= steps; ++i) {
    const double share = double(i) / steps;
    flat.motions.push_back(keyOf(scene::PlaceAt(
        motion,
        i == steps ? shutter.close : shutter.open + share * (shutter.close - shutter.open))));
  }
  flat.params.moving = 1;
}

}  // namespace snell::cpu
