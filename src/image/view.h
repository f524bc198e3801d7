// SPDX-License-Identifier: Apache-2.0
//
// From scene-linear colours to what a display shows: named view transforms, as renderers and glTF viewers know them.
// docs/views.md shows them and says which to choose.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "image/image.h"

namespace snell::image {

enum class View { Srgb, Agx, Neutral, Aces, FalseColor, Raw };

// "srgb", "agx" and so on.
const std::vector<std::pair<std::string, View>>& ViewNames();

// An exposed linear Rec.709 colour as sRGB code values. All but Srgb and Raw stay within 0 to 1; those are clipped when
// they are stored.
vec3 ViewColor(View view, const vec3& linear);

// The views themselves, to linear colours for the display.

// AgX (Sobotka 2022): the curve of the original configuration between matrices as Blender 4, Filament and three.js have
// them. Desaturates towards white as film does.
vec3 AgxTone(const vec3& linear);

// Khronos PBR Neutral (2024): keeps colours up to 0.8 as they are and compresses only what is brighter.
vec3 NeutralTone(const vec3& linear);

// ACES 1.x RRT and sRGB ODT, Stephen Hill's fit (2016).
vec3 AcesTone(const vec3& linear);

// Bands of colour by stops from middle grey; sRGB code values, not linear.
vec3 FalseColor(const vec3& linear);

}  // namespace snell::image
