// SPDX-License-Identifier: Apache-2.0
//
// Refraction: absorption, tinted and opaque shadows, nested and overlapping bodies, sheets, cameras within
// glass, ray trees that grow wide.
#include "agree/scene_builder.h"
#include "agree/scenes.h"

namespace snell::agree {

namespace {

using scene::Box;
using scene::Cone;
using scene::Sphere;

scene::Material Absorbing(float ior, Spectrum color, float distance, int priority) {
  scene::Material material = Glass(ior);
  material.attenuationColor = color;
  material.attenuationDistance = distance;
  material.priority = priority;
  return material;
}

// A floor and lights, one hard and one soft.
SceneBuilder Table(const char* name) {
  SceneBuilder builder(name, vec3(0, 2, 7), vec3(0, 0.4f, 0));
  builder.Add(PointLight(vec3(3, 5, 3), 90));
  scene::Light soft = PointLight(vec3(-3, 5, 1), 50);
  soft.radius = 0.3f;
  soft.samples = 2;
  builder.Add(soft);
  builder.environment() = {{0.2f, 0.15f, 0.1f}, {0.4f, 0.5f, 0.7f}, -0.5f, 1, 1};
  builder.Floor(-0.5f);
  return builder;
}

void PlaceGlasses(SceneBuilder& builder) {
  builder.Place(Sphere{vec3(-1.6f, 0.3f, 0.5f), 0.8f}, builder.Add(Glass(1.5f)));
  builder.Place(Box{vec3(0, -0.5f, 0), vec3(1, 1, 1)},
                builder.Add(Absorbing(1.33f, {0.2f, 0.6f, 0.9f}, 0.8f, 0)));
  builder.Place(Cone{vec3(2.2f, -0.5f, 0), vec3(2.2f, 1, 0.3f), 0.5f, 0.3f, true},
                builder.Add(Glass(2.42f, {1, 0.8f, 0.9f})));
  builder.Place(scene::MeshGeometry{builder.Add(SmoothOctahedron())},
                builder.Add(Glass(1.7f, {0.8f, 1, 0.8f})),
                Move({-0.2f, 0, 2.2f}) * Scale(vec3(0.5f)));
  builder.Place(scene::Torus{vec3(-0.6f, -0.2f, -1.5f), vec3(0.3f, 1, 0), 0.9f, 0.25f},
                builder.Add(Glass(1.4f)));
  builder.Place(Sphere{vec3(1, 0.5f, -2), 0.9f}, builder.Add(Matte({0.9f, 0.3f, 0.2f})));
}

scene::Scene TintedShadows() {
  SceneBuilder builder = Table("TintedShadows");
  PlaceGlasses(builder);
  return builder.Finish();
}

scene::Scene OpaqueShadows() {
  SceneBuilder builder = Table("OpaqueShadows");
  builder.settings().tintedShadows = false;
  PlaceGlasses(builder);
  return builder.Finish();
}

// A bubble in a ball, water in a tumbler that it overlaps, equal priorities.
scene::Scene NestedMedia() {
  SceneBuilder builder = Table("NestedMedia");
  builder.settings().maxDepth = 10;
  builder.settings().minContribution = 0.01f;
  builder.settings().clampIndirect = 0.05f;
  builder.settings().caustics = scene::Caustics::Regularized;
  const int glass = builder.Add(Absorbing(1.5f, {0.7f, 0.9f, 0.7f}, 1, 2));
  const int air = builder.Add(Absorbing(1.0f, Spectrum(1.0f), 1, 3));
  const int water = builder.Add(Absorbing(1.33f, {0.5f, 0.7f, 0.9f}, 1, 1));
  const int ice = builder.Add(Absorbing(1.31f, Spectrum(0.9f), 1, 1));
  builder.Place(Sphere{vec3(-1.6f, 0.4f, 0), 0.9f}, glass);
  builder.Place(Sphere{vec3(-1.5f, 0.5f, 0.2f), 0.5f}, air);
  builder.Place(Sphere{vec3(-1.5f, 0.5f, 0.2f), 0.3f}, glass);
  builder.Place(Cone{vec3(1.2f, -0.49f, 0), vec3(1.2f, 1.3f, 0), 0.7f, 0.8f, true}, glass);
  builder.Place(Cone{vec3(1.2f, -0.35f, 0), vec3(1.2f, 1.4f, 0), 0.6f, 0.7f, true}, air);
  builder.Place(Cone{vec3(1.2f, -0.36f, 0), vec3(1.2f, 0.8f, 0), 0.65f, 0.7f, true}, water);
  builder.Place(Box{vec3(0.9f, 0.5f, 0.1f), vec3(1.3f, 1, 0.5f)}, ice, Shear(0.1f));
  return builder.Finish();
}

// Sheets without inside, clear and textured, flat and bent.
scene::Scene ThinSheets() {
  SceneBuilder builder = Table("ThinSheets");
  builder.settings().caustics = scene::Caustics::None;
  scene::Material pane = Glass(1.5f, {0.9f, 0.9f, 1});
  pane.thin = true;
  scene::Texture stripes;
  stripes.kind = scene::TextureKind::Stripes;
  stripes.placement = Scale(vec3(0.2f));
  scene::Material stained = pane;
  stained.transparency = Textured(builder.Add(stripes), {1, 0.5f, 0.2f});
  stained.reflectivity.value = Spectrum(0.2f);
  const int clear = builder.Add(pane);
  builder.Place(scene::Rectangle{vec3(-2.5f, -0.4f, 1), vec3(2, 0, 0.5f), vec3(0, 2, 0)}, clear);
  builder.Place(scene::Disk{vec3(1.3f, 0.5f, 1), vec3(0.2f, 0.1f, 1), 0.9f, 0.2f},
                builder.Add(stained));
  builder.Place(Sphere{vec3(0, 1, -1), 0.9f}, clear);
  builder.Place(Cone{vec3(2.5f, -0.5f, -1), vec3(2.5f, 1.5f, -1), 0.5f, 0.4f, false}, clear);
  builder.Place(Box{vec3(-2, -0.5f, -1.5f), vec3(-1, 0.5f, -0.5f)},
                builder.Add(Matte({0.8f, 0.3f, 0.3f})));
  return builder.Finish();
}

// The camera within a ball within a block, the sun outside.
scene::Scene CameraInGlass() {
  SceneBuilder builder("CameraInGlass", vec3(0.1f, 0.2f, 0.3f), vec3(0, 0, -3));
  builder.camera().fov = 1.6f;
  builder.settings().maxDepth = 10;
  builder.Add(SunLight(vec3(-1, -2, -1), 3));
  builder.environment() = {{0.3f, 0.2f, 0.1f}, {0.3f, 0.5f, 0.9f}, -0.3f, 0.6f, 1};
  const int block = builder.Add(Absorbing(1.33f, {0.8f, 0.9f, 0.95f}, 2, 0));
  const int ball = builder.Add(Absorbing(1.6f, {0.95f, 0.9f, 0.8f}, 1, 1));
  builder.Place(Box{vec3(-2.5f, -0.9f, -2), vec3(2, 2, 2)}, block, Turn(10, vec3(0, 1, 0)));
  builder.Place(Sphere{vec3(0, 0.1f, 0), 0.8f}, ball);
  builder.Place(scene::MeshGeometry{builder.Add(Tetrahedron())}, ball, Move({0.5f, 0.3f, -1.5f}));
  builder.Place(Sphere{vec3(-1, 0, -4), 1}, builder.Add(Matte({0.9f, 0.4f, 0.2f})));
  builder.Floor(-1);
  return builder.Finish();
}

// An orthographic camera whose plane cuts through instances and balls of glass, under water.
scene::Scene ViewThroughGlass() {
  SceneBuilder builder("ViewThroughGlass", vec3(0, 0.3f, 0), vec3(0, -0.5f, -4));
  builder.camera().kind = scene::CameraKind::Orthographic;
  builder.camera().height = 4;
  builder.Add(PointLight(vec3(2, 4, 0), 80));
  builder.Add(AmbientLight(0.2f));
  builder.environment().ior = 1.33f;
  builder.environment().top = Spectrum(0.4f);
  const int glass = builder.Add(Absorbing(1.5f, {0.9f, 0.7f, 0.7f}, 1, 0));
  const int bubble = builder.Add(Glass(1.0f));
  const scene::MeshGeometry octahedron{builder.Add(SmoothOctahedron())};
  builder.Place(octahedron, glass, Move({-1, 0.5f, 0}) * Scale(vec3(0.9f, 0.7f, -0.8f)));
  builder.Place(octahedron, bubble, Move({1, -0.5f, 0.1f}) * Turn(30, vec3(0, 1, 0)));
  builder.Place(Sphere{vec3(0.5f, 1, -0.2f), 0.7f}, glass);
  builder.Place(Sphere{vec3(0.5f, 1, -0.2f), 0.5f}, bubble);
  builder.Floor(-1.8f);
  return builder.Finish();
}

// Balls of glass that touch, and no branch cut: ray trees as wide as their depth allows.
scene::Scene WideTrees() {
  SceneBuilder builder("WideTrees", vec3(0, 0, 3.5f), vec3(0, 0, 0));
  builder.settings().maxDepth = 6;
  builder.settings().minContribution = 0;
  builder.Add(PointLight(vec3(1, 3, 3), 30));
  builder.environment() = {{0.9f, 0.5f, 0.2f}, {0.2f, 0.3f, 0.9f}, -1, 1, 1};
  const int glass = builder.Add(Absorbing(2, {0.9f, 0.95f, 1}, 1, 0));
  for (int i = 0; i < 8; ++i) {
    const vec3 place((i & 1) == 0 ? 0.6f : -0.6f, (i & 2) == 0 ? 0.6f : -0.6f,
                     (i & 4) == 0 ? 0.6f : -0.6f);
    builder.Place(Sphere{place, 0.62f}, glass);
  }
  return builder.Finish();
}

}  // namespace

std::vector<scene::Scene> ScenesOfGlass() {
  return {TintedShadows(), OpaqueShadows(),    NestedMedia(), ThinSheets(),
          CameraInGlass(), ViewThroughGlass(), WideTrees()};
}

}  // namespace snell::agree
