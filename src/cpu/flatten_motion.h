// SPDX-License-Identifier: Apache-2.0
//
// Motion as the kernel reads it: keys that follow each other evenly while the shutter is open.
#pragma once

#include "cpu/flatten.h"
#include "scene/scene.h"

namespace snell::cpu {

// The time that the shutter is open for, in seconds of the scene's time.
struct Shutter {
  double open;
  double close;
};

// Append the keys of something that moves, made by `keyOf(place)`; sets the first one and the steps between them, or
// None and 0 if it stands still in this time.
void FlattenMotion(const scene::Motion& motion, const Shutter& shutter,
                   kernel::MotionKey (*keyOf)(const scene::Affine& place), FlatScene& flat,
                   kernel::uint& firstKey, kernel::uint& steps);

// An object's place as a key.
kernel::MotionKey KeyOfPlace(const scene::Affine& place);

}  // namespace snell::cpu
