// SPDX-License-Identifier: Apache-2.0
//
// The scenes of agreement use everything that the kernel knows, so that equality there means something. A
// tag that is new in src/kernel/types.h is missing here until a scene uses it.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

#include "agree/scenes.h"
#include "cpu/flatten.h"
#include "kernel/values.h"
#include "scene/validate.h"

namespace snell::agree {

namespace {

using namespace kernel;

using cpu::FlatScene;
using std::ranges::any_of;

std::vector<FlatScene> FlatScenes() {
  std::vector<FlatScene> flat;
  for (const scene::Scene& scene : AllScenes())
    flat.push_back(cpu::Flatten(scene, scene.settings, scene.cameras[0]));
  return flat;
}

// The records of one kind of all scenes.
template <class T>
std::vector<T> Every(std::vector<T> FlatScene::*records) {
  std::vector<T> all;
  for (const FlatScene& flat : FlatScenes())
    all.insert(all.end(), (flat.*records).begin(), (flat.*records).end());
  return all;
}

// The values that a field has in the records.
template <class T>
std::set<uint> Values(const std::vector<T>& records, uint T::*field) {
  std::set<uint> values;
  for (const T& record : records) values.insert(record.*field);
  return values;
}

// All tags from 0 to `last`.
std::set<uint> TagsTo(uint last) {
  std::set<uint> tags;
  for (uint tag = 0; tag <= last; ++tag) tags.insert(tag);
  return tags;
}

bool Mirrored(const Transform& m) { return glm::dot(glm::cross(m.x, m.y), m.z) < 0; }

bool Sheared(const Transform& m) {
  return std::abs(glm::dot(m.x, m.y)) > 0.01f * glm::length(m.x) * glm::length(m.y);
}

TEST(Coverage, ScenesAreValid) {
  for (const scene::Scene& scene : AllScenes()) {
    EXPECT_NO_THROW(scene::Validate(scene, nullptr)) << scene.name;
    EXPECT_EQ(scene.settings.width, 64) << scene.name;
    EXPECT_EQ(scene.settings.height, 64) << scene.name;
  }
}

TEST(Coverage, ShapesAndMeshes) {
  const auto shapes = Every(&FlatScene::shapes);
  EXPECT_EQ(Values(shapes, &Shape::kind), TagsTo(SHAPE_TORUS));
  EXPECT_TRUE(any_of(shapes, Mirrored, &Shape::toWorld));
  EXPECT_TRUE(any_of(shapes, Sheared, &Shape::toWorld));
  const auto meshes = Every(&FlatScene::meshes);
  EXPECT_TRUE(any_of(meshes, [](const Mesh& m) { return m.normals == kernel::None; }));
  EXPECT_TRUE(any_of(meshes, [](const Mesh& m) { return m.normals != kernel::None; }));
  EXPECT_TRUE(any_of(meshes, [](const Mesh& m) { return m.uvs != kernel::None; }));
  for (const auto offset : {&Mesh::normals, &Mesh::tangents, &Mesh::uvs}) {
    for (const bool has : {false, true})
      EXPECT_TRUE(any_of(meshes, [&](const Mesh& m) {
        return m.steps > 0 && (m.*offset != kernel::None) == has;
      }));
  }
  const auto instances = Every(&FlatScene::instances);
  EXPECT_TRUE(any_of(instances, Mirrored, &Instance::toWorld));
  EXPECT_TRUE(any_of(instances, Sheared, &Instance::toWorld));
}

TEST(Coverage, Visibility) {
  const auto objects = Every(&FlatScene::objects);
  for (const uint bit : {MASK_CAMERA, MASK_SECONDARY, MASK_SHADOW, MASK_TINT, MASK_INSIDE}) {
    const auto marked = [&](const Object& object) { return (object.mask & bit) != 0; };
    EXPECT_TRUE(any_of(objects, marked)) << "mask bit " << bit;
    EXPECT_FALSE(std::ranges::all_of(objects, marked)) << "mask bit " << bit;
  }
  EXPECT_TRUE(any_of(objects, [](const Object& o) { return o.light != kernel::None; }));
}

TEST(Coverage, Terms) {
  const auto terms = Every(&FlatScene::terms);
  EXPECT_EQ(Values(terms, &Term::kind), TagsTo(TERM_BLINN));
  for (const uint kind : {TERM_PHONG, TERM_BLINN}) {
    auto specular = terms;
    std::erase_if(specular, [&](const Term& term) { return term.kind != kind; });
    EXPECT_EQ(Values(specular, &Term::normalized), TagsTo(1)) << "term " << kind;
  }
}

TEST(Coverage, Materials) {
  const auto materials = Every(&FlatScene::materials);
  EXPECT_EQ(Values(materials, &Material::reflection), TagsTo(REFLECTION_SCHLICK));
  EXPECT_EQ(Values(materials, &Material::refractive), TagsTo(1));
  EXPECT_EQ(Values(materials, &Material::thin), TagsTo(1));
  EXPECT_TRUE(any_of(materials, [](const Material& m) { return m.termCount > CachedTerms; }));
  EXPECT_TRUE(any_of(materials, [](const Material& m) { return m.priority > 1; }));
  EXPECT_TRUE(any_of(materials, [](const Material& m) { return m.inside.extinction.x > 0; }));
  for (const uint role :
       {ROLE_EMISSION, ROLE_REFLECTIVITY, ROLE_TRANSPARENCY, ROLE_OPACITY, ROLE_NORMAL,
        ROLE_BASE_COLOR, ROLE_METALNESS, ROLE_ROUGHNESS, ROLE_ANISOTROPY, ROLE_TRANSMISSION_COLOR,
        ROLE_COAT_COLOR, ROLE_COAT_NORMAL, ROLE_FILM_WEIGHT, ROLE_FILM_THICKNESS,
        ROLE_DIFFUSE_TRANSMISSION, ROLE_DIFFUSE_TRANSMISSION_COLOR})
    EXPECT_TRUE(
        any_of(materials, [&](const Material& m) { return m.textures[role] != kernel::None; }));
}

TEST(Coverage, Media) {
  const auto materials = Every(&FlatScene::materials);
  EXPECT_EQ(Values(materials, &Material::container), TagsTo(1));
  EXPECT_TRUE(any_of(materials, [](const Material& m) { return m.inside.scattering.x > 0; }));
  EXPECT_TRUE(any_of(materials, [](const Material& m) { return m.inside.emission.x > 0; }));
  EXPECT_FALSE(Every(&FlatScene::grids).empty());
  EXPECT_TRUE(any_of(Every(&FlatScene::physicals),
                     [](const Physical& p) { return p.subsurface.value > 0; }));
  EXPECT_TRUE(any_of(FlatScenes(), [](const FlatScene& flat) {
    return flat.params.surroundings.scattering.x > 0;
  }));
}

TEST(Coverage, PhysicalMaterialsAndMaps) {
  const auto materials = Every(&FlatScene::materials);
  EXPECT_EQ(Values(materials, &Material::alphaMode), TagsTo(ALPHA_BLEND));
  EXPECT_EQ(Values(materials, &Material::singleSided), TagsTo(1));
  for (const auto map : {&Material::physical, &Material::bumpMap})
    EXPECT_TRUE(any_of(materials, [&](const Material& m) { return m.*map != kernel::None; }));
  const auto meshes = Every(&FlatScene::meshes);
  for (const auto offset : {&Mesh::uvs1, &Mesh::tangents, &Mesh::colors})
    EXPECT_TRUE(any_of(meshes, [&](const Mesh& m) { return m.*offset != kernel::None; }));
  const auto physicals = Every(&FlatScene::physicals);
  for (const auto source :
       {&Physical::metalness, &Physical::transmission, &Physical::coatWeight, &Physical::fuzzWeight,
        &Physical::filmWeight, &Physical::anisotropy, &Physical::diffuseTransmission})
    EXPECT_TRUE(any_of(physicals, [&](const Physical& p) { return (p.*source).value > 0; }));
  EXPECT_EQ(Values(physicals, &Physical::anisotropyModel), TagsTo(ANISOTROPY_GLTF));
  EXPECT_EQ(Values(physicals, &Physical::anisotropyMapped), TagsTo(1));
  EXPECT_TRUE(any_of(materials, [](const Material& m) { return m.dispersion > 0; }));
}

TEST(Coverage, PicturesInEveryEncodingWrapAndFilter) {
  EXPECT_EQ(Values(Every(&FlatScene::images), &Image::encoding), TagsTo(IMAGE_FLOATS));
  std::set<uint> found;
  for (const Texture& t : Every(&FlatScene::textures)) {
    if (t.image != kernel::None) found.insert(t.wrapU * 3 + t.lookup);
  }
  EXPECT_EQ(found, TagsTo(WRAP_MIRROR * 3 + LOOKUP_MIPMAP));
}

TEST(Coverage, TexturesInEverySpaceSharpAndSmooth) {
  std::set<uint> found;
  for (const Texture& t : Every(&FlatScene::textures)) {
    if (t.kind != TEXTURE_IMAGE) found.insert((t.kind * 3 + t.space) * 2 + t.smoothEdges);
  }
  EXPECT_EQ(found, TagsTo((TEXTURE_WOOD * 3 + SPACE_WORLD) * 2 + 1));
}

TEST(Coverage, LightsAndFalloffs) {
  const auto lights = Every(&FlatScene::lights);
  EXPECT_EQ(Values(lights, &Light::kind), TagsTo(LIGHT_SPHERE));
  EXPECT_EQ(Values(lights, &Light::falloff), TagsTo(FALLOFF_INVERSE_SQUARE));
  EXPECT_TRUE(any_of(lights, [](const Light& l) { return l.group > 0; }));
  EXPECT_TRUE(any_of(lights, [](const Light& l) { return l.profile != kernel::None; }));
  EXPECT_TRUE(
      any_of(Every(&FlatScene::materials), [](const Material& m) { return m.lightGroup > 0; }));
  EXPECT_TRUE(any_of(lights, [](const Light& l) { return l.range > 0; }));
  EXPECT_TRUE(any_of(lights, [](const Light& l) { return l.oneMinusCos > 0; }));
  for (const uint kind : {LIGHT_POINT, LIGHT_SPOT}) {
    EXPECT_TRUE(any_of(lights, [&](const Light& l) { return l.kind == kind && l.radius > 0; }));
    EXPECT_TRUE(any_of(lights, [&](const Light& l) { return l.kind == kind && l.radius == 0; }));
  }
}

TEST(Coverage, EmittersAndTheLightTree) {
  std::set<uint> shapes, flags, sampling;
  bool inWorld = false, instanced = false, byChance = false, directional = false;
  for (scene::Scene& scene : AllScenes()) {
    scene.settings.integrator = scene::Integrator::Path;
    const FlatScene flat = cpu::Flatten(scene, scene.settings, scene.cameras[0]);
    for (const Emitter& emitter : flat.emitters) {
      const bool isShape = emitter.instance == INSTANCE_SHAPE;
      if (isShape && emitter.node != kernel::None)
        shapes.insert(flat.shapes[emitter.primitive].kind);
      inWorld |= emitter.instance == kernel::None;
      instanced |= !isShape && emitter.instance != kernel::None;
      byChance |= emitter.node == kernel::None;
    }
    if (flat.lightNodes.size() > 3) sampling.insert(flat.params.lightSampling);
    for (const LightNode& node : flat.lightNodes) flags.insert(node.flags);
    directional |= flat.params.firstDirectional != kernel::None;
  }
  EXPECT_EQ(shapes, (std::set<uint>{SHAPE_SPHERE, SHAPE_DISK, SHAPE_RECTANGLE}));
  EXPECT_EQ(flags, TagsTo(LIGHT_NODE_LEAF | LIGHT_NODE_TWO_SIDED));
  EXPECT_EQ(sampling, TagsTo(LIGHTS_BY_POWER));
  EXPECT_TRUE(inWorld && instanced && byChance && directional);
}

TEST(Coverage, LimitsOfPaths) {
  std::set<uint> caustics;
  bool limited = false;
  for (const FlatScene& flat : FlatScenes()) {
    const RenderParams& params = flat.params;
    caustics.insert(params.caustics);
    limited |= std::max({params.maxDiffuseDepth, params.maxSpecularDepth,
                         params.maxTransmissionDepth}) < params.maxDepth;
  }
  EXPECT_EQ(caustics, TagsTo(CAUSTICS_NONE));
  EXPECT_TRUE(limited);
}

TEST(Coverage, CamerasAndSurroundings) {
  std::set<uint> cameras, inside, tinted, lenses, blades, movingShapes;
  bool movingInstances = false, movingCameras = false;
  bool ambient = false, gradient = false, under = false;
  for (const FlatScene& flat : FlatScenes()) {
    const RenderParams& params = flat.params;
    cameras.insert(params.camera.kind);
    if (params.camera.inside == 1) inside.insert(params.camera.kind);
    if (HasLens(params.camera)) {
      lenses.insert(params.camera.kind);
      blades.insert(params.camera.blades == 0 ? 0 : 1);
    }
    for (const Shape& shape : flat.shapes)
      if (flat.objects[shape.object].motion != None) movingShapes.insert(shape.kind);
    for (const Instance& instance : flat.instances)
      movingInstances = movingInstances || flat.objects[instance.object].motion != None;
    movingCameras = movingCameras || params.camera.motion != None;
    tinted.insert(params.tintedShadows);
    ambient = ambient || params.ambient.x > 0;
    gradient = gradient || params.environment.bottom != params.environment.top;
    under = under || params.environment.ior > 1;
  }
  EXPECT_EQ(cameras, TagsTo(CAMERA_STEREOGRAPHIC));
  EXPECT_EQ(movingShapes.size(), 8u) << "all shapes but ellipsoids, which are spheres on the move";
  EXPECT_TRUE(movingInstances && movingCameras);
  EXPECT_EQ(lenses, TagsTo(CAMERA_ORTHOGRAPHIC));
  EXPECT_EQ(blades, TagsTo(1)) << "round apertures and others";
  EXPECT_EQ(inside, TagsTo(CAMERA_ORTHOGRAPHIC)) << "cameras within glass";
  EXPECT_EQ(tinted, TagsTo(1));
  EXPECT_TRUE(ambient);
  EXPECT_TRUE(gradient);
  EXPECT_TRUE(under) << "surroundings denser than air";
}

}  // namespace

}  // namespace snell::agree
