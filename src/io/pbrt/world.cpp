// SPDX-License-Identifier: Apache-2.0
//
// The statements about the world: materials, lights, shapes and their instances.
#include <fmt/format.h>

#include <utility>

#include "io/mesh/text.h"
#include "io/pbrt/reader.h"
#include "scene/motion.h"
#include "util/text.h"

namespace snell::io {

static constexpr std::size_t MaxObjects = 10'000'000;

void PbrtReader::Material() {
  RequireWorld(true);
  const std::string type = String("a type");
  PbrtParameters parameters = Parameters(type);
  parameters.AddDefaults(state_.materials);
  state_.material = materials_.Make(type, parameters);
}

void PbrtReader::MakeNamedMaterial() {
  RequireWorld(true);
  const std::string name = String("a name");
  PbrtParameters parameters = Parameters(name);
  parameters.AddDefaults(state_.materials);
  const std::string type = parameters.String("type", "");
  if (type.empty()) throw Error(fmt::format("material {} has no type", Quoted(name)), place_);
  parameters.set_statement(fmt::format("Material '{}'", type.substr(0, 40)));
  materials_.SetName(name, materials_.Make(type, parameters));
}

void PbrtReader::NamedMaterial() {
  RequireWorld(true);
  const Place place = place_;
  state_.material = materials_.Named(String("a name"), place);
}

void PbrtReader::Texture() {
  RequireWorld(true);
  const std::string name = String("a name"), type = String("a type"), kind = String("a kind");
  PbrtParameters parameters = Parameters(kind);
  parameters.AddDefaults(state_.textures);
  textures_.Define(name, type, kind, parameters, fromPbrt_ * state_.transform);
  parameters.ReportUnused(context_.findings);
}

void PbrtReader::MakeNamedMedium() {
  Parameters(String("a name"));
  context_.findings.Add("medium", "left out: rays go through it unchanged", "", place_);
}

void PbrtReader::MediumInterface() {
  String("a name");
  if (words_->Peek().kind == PbrtWord::Kind::String) String("a name");
}

void PbrtReader::LightSource() {
  RequireWorld(true);
  const std::string type = String("a type");
  PbrtParameters parameters = Parameters(type);
  parameters.AddDefaults(state_.lights);
  AddLight(type, parameters, fromPbrt_ * state_.transform, context_);
}

void PbrtReader::AreaLightSource() {
  RequireWorld(true);
  const std::string type = String("a type");
  PbrtParameters parameters = Parameters(type);
  parameters.AddDefaults(state_.lights);
  state_.areaLight = ReadAreaLight(type, parameters, context_);
}

void PbrtReader::ObjectBegin() {
  RequireWorld(true);
  const std::string name = String("a name");
  if (openObject_) throw Error("an object cannot be defined within another one", place_);
  Push('o');
  openObject_ = &objects_[name];
  openObject_->clear();
}

void PbrtReader::ObjectEnd() {
  Pop('o');
  openObject_ = nullptr;
}

void PbrtReader::ObjectInstance() {
  RequireWorld(true);
  const std::string name = String("a name");
  if (openObject_) throw Error("an object cannot hold instances of others", place_);
  const auto object = objects_.find(name);
  if (object == objects_.end())
    throw Error(fmt::format("there is no object {}", Quoted(name)), place_);
  for (scene::Object part : object->second) {
    part.motion =
        scene::Compose(state_.transform, MotionOf(scene::Affine(1.0)), part.toWorld, part.motion);
    part.toWorld = state_.transform * part.toWorld;
    part.place = place_;
    AddObject(std::move(part));
  }
}

// Objects within a definition stay in pbrt's world.
void PbrtReader::AddObject(scene::Object object) {
  if (context_.scene.objects.size() >= MaxObjects)
    throw Error(fmt::format("the scene has more than {}", Plural(MaxObjects, "object")), place_);
  object.toWorld = fromPbrt_ * object.toWorld;
  for (scene::MotionKey& key : object.motion) key.place = fromPbrt_ * key.place;
  context_.scene.objects.push_back(std::move(object));
}

static bool IsTextured(const scene::Material& material, const PbrtSurface& surface) {
  const scene::OpenPbr& pbr = *material.physical;
  return pbr.baseColor.texture >= 0 || pbr.specularRoughness.texture >= 0 ||
         pbr.coatRoughness.texture >= 0 || pbr.diffuseTransmissionColor.texture >= 0 ||
         material.bumpMap.texture >= 0 || material.normalMap.texture >= 0 ||
         surface.alpha.texture >= 0;
}

void PbrtReader::Shape() {
  RequireWorld(true);
  const std::string type = String("a type");
  PbrtParameters parameters = Parameters(type);
  parameters.AddDefaults(state_.shapes);
  const PbrtMaterial& material = materials_.At(state_.material);
  PbrtSurface surface{state_.material, textures_.Scalar(parameters, "alpha", 1)};
  const bool isHidden =
      material.isInterface || (surface.alpha.texture < 0 && surface.alpha.value <= 0);
  const std::optional<PbrtAreaLight> light = openObject_ ? std::nullopt : state_.areaLight;
  if (openObject_ && state_.areaLight)
    context_.findings.Add("area light", "in an object for instances left out", "", place_);
  if (isHidden && !light) {
    context_.findings.Add("unseen shape", "left out, such as a medium's border", "", place_);
    return;
  }

  // Which side is out matters for light and glass only
  const bool isTurned = state_.isReversed && (light || material.record.Refractive());
  const bool isTextured = IsTextured(material.record, surface);
  const auto shape = shapes_.Make(type, parameters, isTurned, isTextured);
  parameters.ReportUnused(context_.findings);
  if (!shape) return;
  const auto* mesh = std::get_if<scene::MeshGeometry>(&shape->geometry);
  if (mesh && isTextured && context_.scene.meshes[std::size_t(mesh->mesh)].uvs.empty())
    context_.findings.Add("textured mesh", "without texture coordinates: laid out on each triangle",
                          type, place_);
  scene::Object object;
  object.name = type;
  object.geometry = shape->geometry;
  object.toWorld = state_.transform * shape->toObject;
  object.motion = MotionOf(shape->toObject);
  object.place = place_;
  if (light) {
    const PbrtEmitter emitter{shape->geometry, fromPbrt_ * object.toWorld, !isHidden};
    surface.emission = RadianceOf(*light, emitter, context_.scene);
    const bool lights = AddEmitter(*light, emitter, context_.scene);
    if (!lights)
      context_.findings.Add(
          "glowing shape", isHidden ? "that is not seen left out" : "shown without lighting others",
          type, place_);
    // The light itself is seen
    if (isHidden || (lights && !light->isTwoSided)) {
      if (type == "trianglemesh" || type == "bilinearmesh") context_.scene.meshes.pop_back();
      return;
    }
  }
  object.material = materials_.Use(surface);
  if (!openObject_) return AddObject(std::move(object));
  openObject_->push_back(std::move(object));
}

}  // namespace snell::io
