// SPDX-License-Identifier: Apache-2.0
//
// Reads the Neutral File Format of Haines 1987 ("A proposal for standard graphics environments", IEEE
// CG&A 7(11)), the language of the Standard Procedural Databases: view, background, point lights, fills,
// spheres, open cones and cylinders, polygons and patches with normals. Its units of length are taken as
// metres. What the entities become is told in nff_scene.cpp; opaque surfaces, too, have two sides here.
#pragma once

#include <filesystem>
#include <string_view>

#include "io/read_limits.h"
#include "scene/scene.h"
#include "util/error.h"

namespace snell::io {

// Read a file of at most 2 GB. Throws Error with the place of each mistake, up to 20 of them; `warn` may be
// empty. The settings ask for what the format's authors do: 1 sample a pixel, depth 5, no cut-off.
scene::Scene ReadNff(const std::filesystem::path& path, const WarningSink& warn,
                     const ReadLimits& limits = {});

// The same for a text in memory; `file` names it in messages.
scene::Scene ParseNff(std::string_view text, const std::filesystem::path& file,
                      const WarningSink& warn);

}  // namespace snell::io
