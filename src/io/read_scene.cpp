// SPDX-License-Identifier: Apache-2.0
#include "io/read_scene.h"

#include <cmath>
#include <utility>

#include "io/contents.h"
#include "io/format.h"
#include "io/gltf/gltf.h"
#include "io/images.h"
#include "scene/framing.h"
#include "scene/validate.h"
#include "util/file.h"

namespace snell::io {

// A turn by −90° about x: z up becomes y up.
static scene::Affine ZUpToYUp() {
  return {glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 0, -1, 0), glm::dvec4(0, 1, 0, 0),
          glm::dvec4(0, 0, 0, 1)};
}

// Give objects that bring no material one that shows their colours, or the grey one.
static void GiveMaterials(scene::Scene& scene) {
  scene::MaterialIndex standard[2] = {-1, -1};
  for (scene::Object& object : scene.objects) {
    if (object.material >= 0) continue;
    const auto* mesh = std::get_if<scene::MeshGeometry>(&object.geometry);
    const bool colored = mesh && !scene.meshes[std::size_t(mesh->mesh)].colors.empty();
    scene::MaterialIndex& material = standard[colored];
    if (material < 0) {
      material = scene::MaterialIndex(scene.materials.size());
      scene.materials.push_back(colored ? scene::ColoredMaterial() : scene::DefaultMaterial());
    }
    object.material = material;
  }
}

static void SetUpMeshes(scene::Scene& scene, bool zUp, bool wantsStudio) {
  GiveMaterials(scene);
  if (zUp)
    for (scene::Object& object : scene.objects) object.toWorld = ZUpToYUp();
  if (wantsStudio) scene::AddStudio(scene);
}

static void SetUpGltf(scene::Scene& scene, bool wantsStudio) {
  if (scene.lights.empty()) {
    if (!scene.objects.empty() && wantsStudio) scene::AddStudio(scene);
    return;
  }
  // Expose for the file's lights, which are in lumens: a matt white surface under π lux comes out white. What
  // glows is in nits then, too
  scene.settings.exposure = std::log2(LumensPerWatt);
  for (scene::Material& material : scene.materials) {
    if (material.physical) material.physical->emission.value /= LumensPerWatt;
  }
}

// Put the map around the scene in place of its surroundings.
static void ReplaceEnvironment(scene::Scene& scene, const ReadOptions& options, Format format) {
  scene::Environment& environment = scene.environment;
  if (environment.sun >= 0) scene.lights.erase(scene.lights.begin() + environment.sun);
  const float ior = environment.ior;
  environment = {};
  environment.ior = ior;
  environment.map = scene::ImageIndex(scene.images.size());
  environment.ambient = true;
  // The map is not in the file's unit of light
  if (format == Format::Gltf)
    environment.mapScale = scene::Spectrum(std::exp2(-scene.settings.exposure));
  scene.images.push_back(DecodeTexels(ReadWithin(options.environment, options.limits),
                                      options.environment.string(), ImageUse::Color,
                                      options.limits));
}

scene::Scene ReadScene(const std::filesystem::path& path, const ReadOptions& options,
                       const WarningSink& warn) {
  Contents contents = ReadContents(path, options, warn);
  scene::Scene& scene = contents.scene;
  if (options.time && !contents.animated && warn)
    warn({"there are no animations: the time changes nothing", {path.string()}});
  const Format format = FormatOf(path);
  const bool wantsStudio = options.environment.empty();
  if (format == Format::Gltf) SetUpGltf(scene, wantsStudio);
  if (format == Format::Mesh)
    SetUpMeshes(scene, options.zUp.value_or(LowerExtension(path) == "stl"), wantsStudio);
  if (format == Format::Other) {
    GiveMaterials(scene);
    if (scene.lights.empty() && wantsStudio) scene::AddStudio(scene);
  }
  if (!wantsStudio) ReplaceEnvironment(scene, options, format);
  scene.name = path.string();
  scene::Validate(scene, warn);
  return std::move(scene);
}

}  // namespace snell::io
