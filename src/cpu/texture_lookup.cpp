// SPDX-License-Identifier: Apache-2.0
#include "cpu/texture_lookup.h"

#include "kernel/values.h"

namespace snell::cpu {

using namespace kernel;

namespace {

// The part of the kernel that reads textures (cpu/kernel.h binds all of it).
struct TextureKernel {
  const Object* objects;
  const Shape* shapes;
  const Instance* instances;
  const vec3* positions;
  const MotionKey* motions;
  const Texture* textures;
  const Image* images;
  const uint* texels;

#include "kernel/scene_image.h"
#include "kernel/scene_motion.h"
#include "kernel/scene_texture.h"
};

}  // namespace

tessellate::TextureLookup LookupIn(const FlatScene& flat) {
  return [&flat](scene::TextureIndex index, int channel, const tessellate::TexturePoint& point) {
    // The point is where the texture wants it already
    static const Object here = {0, 0, None, None, 0, ToTransform(scene::Affine(1.0)), 0};
    TextureKernel kernel = {&here,
                            flat.shapes.data(),
                            flat.instances.data(),
                            flat.positions.data(),
                            flat.motions.data(),
                            flat.textures.data(),
                            flat.images.data(),
                            flat.texels.data()};
    const Texture& texture = flat.textures[std::size_t(index)];
    SurfaceInteraction it = {};
    it.p = texture.space == SPACE_WORLD ? point.world : point.local;
    it.footprint = point.width;
    it.uvDensity = 1;
    return kernel.EvalTextureAt(texture, it, point.uv)[channel];
  };
}

}  // namespace snell::cpu
