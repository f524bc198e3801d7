// SPDX-License-Identifier: Apache-2.0
#include "cpu/emission_average.h"

#include <algorithm>
#include <cmath>

#include "cpu/scene_view.h"
#include "kernel/values.h"

namespace snell::cpu {

using namespace kernel;

namespace {

// Points of a texture that are looked up for one emitter, at least and at most, and for all of them together. Of a
// picture with levels of detail a few points see the whole.
constexpr uint LeastPoints = 4;
constexpr uint MostPoints = 1024;
constexpr uint MostMipmapPoints = 64;
constexpr std::size_t AllPoints = 1 << 23;

// The parts of the kernel that find points on emitters and what textures show there (cpu/kernel.h binds all of it).
struct EmissionKernel : SceneView {
#include "kernel/scene_emitter.h"
#include "kernel/scene_image.h"
#include "kernel/scene_motion.h"
#include "kernel/scene_surface.h"
#include "kernel/scene_texture.h"
};

// About how many texels the emitter shows.
double TexelsOn(const Texture& texture, const SurfaceInteraction& it, double area) {
  const double side = double(texture.texelDensity) * double(it.uvDensity);
  return side * side * area;
}

}  // namespace

Spectrum AverageEmission(const FlatScene& flat, const Emitter& emitter, const Material& material,
                         vec3 center, vec3 normal) {
  const uint index = material.textures[ROLE_EMISSION];
  if (index == None) return material.emission;
  EmissionKernel kernel = {ViewOf(flat)};
  const Texture& texture = flat.textures[index];
  const bool isSphere =
      emitter.instance == INSTANCE_SHAPE && flat.shapes[emitter.primitive].kind == SHAPE_SPHERE;
  // From the middle of a sphere directions are uniform over its area, which is four times its silhouette's
  const vec3 from = isSphere ? center : center + normal * std::sqrt(emitter.area);
  const double area = double(emitter.area) * (isSphere ? 4 : 1);

  const bool isSmooth = texture.kind == TEXTURE_IMAGE && texture.lookup == LOOKUP_MIPMAP;
  const std::size_t most = std::clamp(AllPoints / flat.emitters.size(), std::size_t(LeastPoints),
                                      std::size_t(isSmooth ? MostMipmapPoints : MostPoints));
  uint count = LeastPoints;
  Spectrum sum(0.0f);
  for (uint i = 0; i < count; ++i) {
    Ray ray;
    float reach;
    SurfaceInteraction it = kernel.SampleEmitter(emitter, from, Sobol2D(i, 0x6c1u), ray, reach);
    if (i == 0)
      count = uint(std::clamp(4 * TexelsOn(texture, it, area), double(LeastPoints), double(most)));
    it.footprint = float(std::sqrt(area / count));
    const vec4 texel = kernel.EvalTexture(index, it);
    sum += Spectrum(texel.x, texel.y, texel.z);
  }
  return material.emission * sum / float(count);
}

}  // namespace snell::cpu
