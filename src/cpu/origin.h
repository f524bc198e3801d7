// SPDX-License-Identifier: Apache-2.0
//
// What the samples of a film depend on: the flattened scene, the camera and the settings, as properties that film
// files keep and compare (render/film_file.h).
#pragma once

#include "cpu/flatten.h"
#include "render/film.h"

namespace snell::cpu {

// `program` names this program and its version. Values that stand for much are checksums, "#0123…".
render::Properties SamplesDependOn(const FlatScene& flat, const scene::RenderSettings& settings,
                                   const std::string& program);

}  // namespace snell::cpu
