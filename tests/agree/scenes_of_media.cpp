// SPDX-License-Identifier: Apache-2.0
//
// Media: fog around everything, smoke within boundaries that are not seen, milk in glass, and light below surfaces.
#include "agree/scene_builder.h"
#include "agree/scenes.h"

namespace snell::agree {

namespace {

using scene::Box;
using scene::Sphere;

SceneBuilder Begin(const char* name) {
  SceneBuilder builder(name, vec3(0, 1.2f, 5), vec3(0, 0, 0));
  builder.environment().bottom = {0.3f, 0.2f, 0.1f};
  builder.environment().top = {0.4f, 0.5f, 0.9f};
  builder.settings().maxVolumeDepth = 24;
  builder.Add(PointLight(vec3(1.5f, 3, 2), 30));
  return builder;
}

scene::Material Volume(scene::Medium medium) {
  scene::Material material;
  material.volume = medium;
  material.transparency.value = Spectrum(1.0f);
  material.priority = -1;
  return material;
}

scene::Material Physical(const scene::OpenPbr& physical) {
  scene::Material material;
  material.physical = physical;
  return material;
}

// A spot's beam in fog that glows a little, past a ball.
scene::Scene Fog() {
  SceneBuilder builder = Begin("Fog");
  builder.environment().medium = {
      {0.02f, 0.03f, 0.04f}, Spectrum(0.15f), 0.9f, 0.5f, {0.001f, 0.002f, 0.003f}};
  builder.Add(SpotLight(vec3(-3, 2, 0), vec3(0, 0, 0), 60));
  builder.Place(Sphere{vec3(0.4f, 0, 0), 0.5f}, builder.Add(Matte({0.8f, 0.3f, 0.2f})));
  builder.Floor(-1);
  return builder.Finish();
}

// Coloured smoke with a glass ball half in it, overlapping smoke that glows, and a camera within a thin haze.
scene::Scene Smoke() {
  SceneBuilder builder = Begin("Smoke");
  const int haze = builder.Add(Volume({Spectrum(0.01f), Spectrum(0.03f), 1, 0, Spectrum(0.0f)}));
  const int smoke =
      builder.Add(Volume({{0.1f, 0.3f, 0.9f}, {0.9f, 1.2f, 1.5f}, 1.5f, -0.3f, Spectrum(0.0f)}));
  const int flame = builder.Add(Volume({Spectrum(0.5f), Spectrum(0.0f), 1, 0, {1.5f, 0.5f, 0.1f}}));
  builder.Place(Sphere{vec3(0, 0, 0), 30}, haze);
  builder.Place(Sphere{vec3(-0.7f, 0, 0), 0.9f}, smoke);
  builder.Place(Box{vec3(-0.5f, -0.9f, -0.5f), vec3(0.9f, 0.3f, 0.5f)}, flame);
  builder.Place(Sphere{vec3(0.6f, 0.4f, 0.6f), 0.5f}, builder.Add(Glass(1.5f)));
  scene::Light lamp;
  lamp.kind = scene::LightKind::Sphere;
  lamp.position = vec3(-1, 0.4f, 0);
  lamp.radius = 0.2f;
  lamp.strength = 8;
  builder.Add(lamp);
  builder.Floor(-1);
  return builder.Finish();
}

// Milk in a ball and in a mesh that is placed twice, wax, and a waxen sheet.
scene::Scene MilkAndWax() {
  SceneBuilder builder = Begin("MilkAndWax");
  scene::OpenPbr clear;
  clear.transmissionWeight.value = 1;
  clear.specularRoughness.value = 0.1f;
  clear.transmissionDepth = 0.5f;
  clear.transmissionColor.value = {0.9f, 0.7f, 0.4f};
  clear.transmissionScatter = {0.6f, 0.9f, 1.2f};
  clear.transmissionScatterAnisotropy = 0.6f;
  scene::OpenPbr wax;
  wax.subsurfaceWeight.value = 0.9f;
  wax.subsurfaceColor.value = {0.9f, 0.6f, 0.3f};
  wax.subsurfaceRadius = 0.2f;
  wax.subsurfaceScatterAnisotropy = 0.2f;
  wax.coatWeight.value = 0.4f;
  const int milk = builder.Add(Physical(clear));
  builder.Place(Sphere{vec3(-1, 0, 0.4f), 0.7f}, milk);
  const int mesh = builder.Add(SmoothOctahedron());
  const int waxen = builder.Add(Physical(wax));
  builder.Place(scene::MeshGeometry{mesh}, waxen, Move({0.6f, 0, 0.6f}) * Scale(vec3(0.7f)));
  builder.Place(scene::MeshGeometry{mesh}, milk, Move({1.8f, 0, -0.6f}) * Scale(vec3(0.6f)));
  // A ball of wax around a lamp and another ball
  builder.Place(Sphere{vec3(-0.2f, 0.9f, -1), 0.6f}, waxen);
  builder.Place(Sphere{vec3(-0.2f, 1.1f, -0.8f), 0.15f}, waxen);
  scene::Light lamp;
  lamp.kind = scene::LightKind::Sphere;
  lamp.position = vec3(-0.3f, 0.7f, -1.1f);
  lamp.radius = 0.1f;
  lamp.strength = 60;
  builder.Add(lamp);
  scene::Material sheet = Physical(wax);
  sheet.thin = true;
  builder.Place(scene::Rectangle{vec3(-2.5f, -0.8f, -1.5f), vec3(1, 0, 0), vec3(0, 1.4f, 0)},
                builder.Add(sheet));
  builder.Floor(-1);
  return builder.Finish();
}

// Uneven smoke: a lattice of some bricks, one of them empty, turned and stretched with the ball that holds it.
scene::Scene Cloud() {
  SceneBuilder builder = Begin("Cloud");
  scene::Medium medium = {{0.2f, 0.4f, 0.8f}, {2, 3, 4}, 1, 0.3f, {0.05f, 0.02f, 0.0f}};
  medium.grid = 0;
  builder.Place(Sphere{vec3(0, 0, 0), 1}, builder.Add(Volume(medium)),
                Move({0, 0.2f, 0}) * Turn(30, vec3(1, 2, 0)) * Scale(vec3(1.4f, 1, 0.8f)));
  builder.Place(Sphere{vec3(0.9f, -0.4f, 1), 0.4f}, builder.Add(Matte({0.3f, 0.6f, 0.8f})));
  builder.Floor(-1);
  scene::Scene scene = builder.Finish();
  scene::DensityGrid grid;
  grid.bricks = {3, 2, 2};
  grid.toObject = Move({-1.1f, -0.9f, -0.9f}) * Scale(vec3(0.1f));
  for (int i = 0; i < 12; ++i) grid.table.push_back(i == 4 ? -1 : i < 4 ? i : i - 1);
  for (std::uint32_t i = 0; i < 11 * 512; ++i)
    grid.values.push_back(float((i * 2654435761u) >> 24) / 128.0f);
  scene.grids.push_back(grid);
  return scene;
}

}  // namespace

std::vector<scene::Scene> ScenesOfMedia() { return {Fog(), Smoke(), MilkAndWax(), Cloud()}; }

}  // namespace snell::agree
