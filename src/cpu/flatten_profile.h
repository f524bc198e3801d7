// SPDX-License-Identifier: Apache-2.0
//
// Tables of how lights shine by direction, as the kernel reads them (kernel/scene_profile.h).
#pragma once

#include <vector>

#include "cpu/flatten.h"

namespace snell::cpu {

// Append the tables of all profiles to the texels. Returns where each begins.
std::vector<kernel::uint> FlattenProfiles(const scene::Scene& scene, FlatScene& flat);

// Give a light the frame of its profile.
void SetProfileFrame(const scene::Light& from, kernel::Light& light);

// Where a profile shines: within this angle from the light's direction, and its mean share there.
struct ProfileBounds {
  double angle;
  double mean;
};
ProfileBounds BoundsOfProfile(const FlatScene& flat, kernel::uint profile);

}  // namespace snell::cpu
