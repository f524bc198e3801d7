// SPDX-License-Identifier: Apache-2.0
#include "explain/names.h"

#include <fmt/format.h>

#include "cpu/aov_names.h"

namespace snell::explain {

namespace {

const char* KindOf(const kernel::Shape& shape) {
  switch (shape.kind) {
    case kernel::SHAPE_SPHERE: return "sphere";
    case kernel::SHAPE_ELLIPSOID: return "ellipsoid";
    case kernel::SHAPE_PLANE: return "plane";
    case kernel::SHAPE_DISK: return "disk";
    case kernel::SHAPE_RECTANGLE: return "rectangle";
    case kernel::SHAPE_BOX: return "box";
    case kernel::SHAPE_TORUS: return "torus";
  }
  return "cylinder or cone";
}

}  // namespace

Names::Names(const scene::Scene& scene, const cpu::FlatScene& flat) : flat_(flat) {
  const render::AovNames names = cpu::AovNamesOf(scene, flat);
  objects_ = names.objects;
  for (const std::uint32_t material : names.materialsOf)
    materials_.push_back(names.materials[material]);
  places_.resize(flat.surfaceLights.size());
  for (const scene::Object& object : scene.objects) places_.push_back(ToString(object.place));

  // The kernel has no ambient lights
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const scene::Light& light = scene.lights[i];
    if (light.kind == scene::LightKind::Ambient) continue;
    lights_.push_back(light.name.empty() ? fmt::format("light_{}", i) : light.name);
  }
  for (const scene::Texture& texture : scene.textures) textures_.push_back(texture.name);
}

const std::string& Names::ObjectOf(const kernel::Hit& hit) const {
  if (hit.instance == kernel::INSTANCE_SHAPE) return Object(flat_.shapes[hit.primitive].object);
  if (hit.instance != kernel::None) return Object(flat_.instances[hit.instance].object);
  return Object(flat_.meshes[flat_.triangles[hit.primitive].mesh].object);
}

std::string Names::Part(const kernel::Hit& hit) const {
  if (hit.instance == kernel::INSTANCE_SHAPE) return KindOf(flat_.shapes[hit.primitive]);
  return fmt::format("triangle {}", hit.primitive);
}

std::string Names::Texture(std::uint32_t texture) const {
  const bool isNamed = texture < textures_.size() && !textures_[texture].empty();
  return isNamed ? textures_[texture] : fmt::format("texture_{}", texture);
}

std::string Names::Light(std::uint32_t source) const {
  if (source < lights_.size()) return fmt::format("the light '{}'", lights_[source]);
  const kernel::Emitter& emitter = flat_.emitters[source - flat_.params.lightCount];
  return fmt::format("the glow of '{}'", ObjectOf({emitter.primitive, emitter.instance}));
}

}  // namespace snell::explain
