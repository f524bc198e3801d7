// SPDX-License-Identifier: Apache-2.0
//
// What readers promise of their results, checked cheaply and besides scene/validate.h. A promise that is not
// kept fails a CHECK.
#pragma once

#include <string_view>

#include "image/image.h"
#include "scene/scene.h"

namespace snell::fuzz {

// Numbers of meshes, pictures and grids are finite, and so is the room that the objects take.
void CheckScene(const scene::Scene& scene);

void CheckGrid(const scene::DensityGrid& grid);

void CheckProfile(const scene::LightProfile& profile);

void CheckPicture(const image::Image& picture, const image::Metadata& metadata);

// A message for a person: not empty and no novel.
void CheckText(std::string_view message);

}  // namespace snell::fuzz
