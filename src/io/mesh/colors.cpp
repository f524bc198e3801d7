// SPDX-License-Identifier: Apache-2.0
#include "io/mesh/colors.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <glm/common.hpp>

#include "image/color.h"

namespace snell::io {

using scene::vec3;
using scene::vec4;

void DecodeColors(FaceSet& faces, ColorCode code, const MeshFile& file) {
  const bool wide = std::any_of(faces.colors.begin(), faces.colors.end(),
                                [](const vec4& c) { return c.x > 1 || c.y > 1 || c.z > 1; });
  if (wide)
    file.Warn("the vertices' colors exceed 1: taken for sRGB from 0 to 255", file.AtLine(0));
  const vec4 unit(vec3(wide ? 255.0f : 1.0f), 1.0f);
  tbb::parallel_for(std::size_t(0), faces.colors.size(), [&](std::size_t i) {
    vec4& color = faces.colors[i];
    color = glm::clamp(color / unit, 0.0f, 1.0f);
    if (code == ColorCode::Srgb || wide) color = vec4(image::DecodeSrgb(vec3(color)), color.w);
  });
}

}  // namespace snell::io
