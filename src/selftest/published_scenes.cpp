// SPDX-License-Identifier: Apache-2.0
//
// Scenes that the field compares by, from their published numbers: the Cornell box (Goral et al. 1984; measurements
// from Cornell's page of the box's data) and the plates that show multiple importance sampling (Veach and Guibas 1995; the numbers
// of the scene file that Mitsuba and Nori carry). What they show must not depend on how light is found.
#include <fmt/format.h>

#include <cmath>

#include "selftest/scenes.h"
#include "selftest/selftest.h"

namespace snell::selftest {
namespace {

// --- The Cornell box, in decimetres -------------------------------------------------------------------

const Spectrum White{0.725f, 0.71f, 0.68f}, Red{0.63f, 0.065f, 0.05f}, Green{0.14f, 0.45f, 0.091f};
const Spectrum Lamp{17, 12, 4};
const vec3 LampCorner{2.13f, 5.487f, 2.27f}, LampU{1.3f, 0, 0}, LampV{0, 0, 1.05f};

struct Corner {
  float x, z;
};

void AddBlock(scene::Scene& scene, const Corner (&floor)[4], float height) {
  for (int i = 0; i < 4; ++i) {
    const Corner a = floor[i], b = floor[(i + 1) % 4];
    AddQuad(scene, {a.x, 0, a.z}, {b.x - a.x, 0, b.z - a.z}, {0, height, 0}, White);
  }
  const Corner a = floor[0], b = floor[1], d = floor[3];
  AddQuad(scene, {a.x, height, a.z}, {b.x - a.x, 0, b.z - a.z}, {d.x - a.x, 0, d.z - a.z}, White);
}

scene::Scene CornellBox() {
  constexpr float Width = 5.528f, Height = 5.488f, Depth = 5.592f;
  scene::Scene scene = Empty(40, 256, 12);
  LookAt(scene, {2.78f, 2.73f, -8}, {2.78f, 2.73f, 0}, 39.3077f);
  AddQuad(scene, {0, 0, 0}, {0, 0, Depth}, {Width, 0, 0}, White);
  AddQuad(scene, {0, Height, 0}, {Width, 0, 0}, {0, 0, Depth}, White);
  AddQuad(scene, {0, 0, Depth}, {0, Height, 0}, {Width, 0, 0}, White);
  AddQuad(scene, {0, 0, 0}, {0, Height, 0}, {0, 0, Depth}, Green);
  AddQuad(scene, {Width, 0, 0}, {0, 0, Depth}, {0, Height, 0}, Red);
  AddBlock(scene, {{1.30f, 0.65f}, {0.82f, 2.25f}, {2.40f, 2.72f}, {2.90f, 1.14f}}, 1.65f);
  AddBlock(scene, {{4.23f, 2.47f}, {2.65f, 2.96f}, {3.14f, 4.56f}, {4.72f, 4.06f}}, 3.30f);
  return scene;
}

scene::Light RectangleLamp() {
  scene::Light lamp;
  lamp.kind = scene::LightKind::Rectangle;
  lamp.color = Lamp;
  lamp.position = LampCorner;
  lamp.edgeU = LampU;
  lamp.edgeV = LampV;
  return lamp;
}

// The same lamp as a mesh; it shines from both sides, of which only one is seen.
void AddGlowingLamp(scene::Scene& scene) {
  scene::Mesh mesh;
  mesh.positions = {LampCorner, LampCorner + LampU, LampCorner + LampU + LampV, LampCorner + LampV};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.meshes.push_back(mesh);
  scene::Material material = Physical(Spectrum(0.0f));
  material.physical->emission.value = Lamp;
  material.doubleSided = false;
  Add(scene, scene::MeshGeometry{0}, material);
}

void Cornell(const CheckSink& sink) {
  scene::Scene byLamp = CornellBox(), byMesh = CornellBox();
  byLamp.lights.push_back(RectangleLamp());
  AddGlowingLamp(byMesh);
  // Below the lamp
  const Part part{0, 12, 40, 40};
  const glm::dvec3 expected = MeanRadiance(byLamp, part), measured = MeanRadiance(byMesh, part);
  for (const int channel : {0, 1, 2})
    sink(Near("scenes", fmt::format("Cornell box, {}, lamp as a mesh", "rgb"[channel]),
              measured[channel], expected[channel], 0.012 * expected[channel]));
}

// --- Veach's plates ------------------------------------------------------------------------------------

struct Plate {
  float front, frontZ, back, backZ;  // heights and depths of its edges
  float roughness;                   // width of its lobe
};
const Plate Plates[] = {{-2.70651f, 0.25609f, -2.08375f, -0.526323f, 0.005f},
                        {-3.28825f, 1.36972f, -2.83856f, 0.476536f, 0.02f},
                        {-3.73096f, 2.70046f, -3.43378f, 1.74564f, 0.05f},
                        {-3.99615f, 4.0667f, -3.82069f, 3.08221f, 0.1f}};

struct Ball {
  float x, radius, radiance;
};
const Ball Balls[] = {{-3.75f, 0.03333f, 901.803f},
                      {-1.25f, 0.1f, 100},
                      {1.25f, 0.3f, 11.1111f},
                      {3.75f, 0.9f, 1.23457f}};

scene::Scene VeachPlates(bool lampsAreMet) {
  scene::Scene scene = Empty(60, 256, 2);
  LookAt(scene, {0, 2, 15}, {0, -2, 2.5f}, 28);
  AddQuad(scene, {-10, -4.14615f, 10}, {20, 0, 0}, {0, 0, -20}, Spectrum(0.4f));
  AddQuad(scene, {-10, -10, -2}, {20, 0, 0}, {0, 20, 0}, Spectrum(0.4f));
  for (const Plate& plate : Plates) {
    scene::Material metal = Physical(Spectrum(0.9f), 1);
    metal.physical->baseMetalness.value = 1;
    metal.physical->specularRoughness.value = std::sqrt(plate.roughness);
    Add(scene,
        scene::Rectangle{{-4, plate.front, plate.frontZ},
                         {8, 0, 0},
                         {0, plate.back - plate.front, plate.backZ - plate.frontZ}},
        metal);
  }
  for (const Ball& ball : Balls) {
    scene::Light lamp;
    lamp.kind = scene::LightKind::Sphere;
    lamp.position = {ball.x, 0, 0};
    lamp.radius = ball.radius;
    lamp.strength = ball.radiance;
    lamp.visible = lampsAreMet;
    scene.lights.push_back(lamp);
  }
  return scene;
}

void Veach(const CheckSink& sink) {
  // The two roughest plates, where lamps alone can be sampled without much noise
  const Part part{8, 36, 52, 52};
  const double expected = MeanRadiance(VeachPlates(false), part).y;
  sink(Near("scenes", "Veach's plates, lamps sampled and met",
            MeanRadiance(VeachPlates(true), part).y, expected, 0.02 * expected));
}

}  // namespace

void PublishedScenes(const CheckSink& sink) {
  Cornell(sink);
  Veach(sink);
}

}  // namespace snell::selftest
