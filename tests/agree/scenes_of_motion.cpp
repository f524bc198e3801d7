// SPDX-License-Identifier: Apache-2.0
//
// Things and cameras that move while the shutter is open: every shape, meshes, glass, textures, and turns; and meshes
// that change their shape.
#include <cmath>

#include "agree/scene_builder.h"
#include "agree/scenes.h"

namespace snell::agree {

namespace {

void Open(SceneBuilder& builder) { builder.camera().shutterClose = 1; }

scene::Scene MovingShapes() {
  SceneBuilder builder("MovingShapes", vec3(0, 3, 9), vec3(0, 0.2f, 0));
  Open(builder);
  builder.Add(PointLight(vec3(3, 7, 5), 200));
  builder.Add(AmbientLight(0.2f));
  builder.environment().top = {0.2f, 0.3f, 0.5f};
  scene::Texture checker;
  checker.space = scene::TextureSpace::Object;
  scene::Material textured = Matte(Spectrum(0.9f));
  textured.terms[1].color = Textured(builder.Add(checker), {0.9f, 0.7f, 0.5f});
  const int patterned = builder.Add(textured);
  const int mirror = builder.Add(Mirror(Spectrum(0.7f)));
  const int glass = builder.Add(Glass(1.5f, {0.9f, 1, 0.9f}));
  const scene::Geometry shapes[] = {
      scene::Sphere{vec3(0), 0.6f},
      scene::Box{vec3(-0.5f), vec3(0.5f)},
      scene::Torus{vec3(0), vec3(0.2f, 1, 0.4f), 0.6f, 0.2f},
      scene::Cone{vec3(0, -0.5f, 0), vec3(0, 0.5f, 0), 0.5f, 0.2f},
      scene::Disk{vec3(0), vec3(0, 0.5f, 1), 0.7f, 0.2f},
      scene::Rectangle{},
      scene::Cone{vec3(0, -0.5f, 0), vec3(0, 0.5f, 0), 0.4f, 0.4f, false}};
  for (int i = 0; i < 7; ++i) {
    const float at = float(i);
    const Affine start = Move({float(i % 4) * 1.8f - 2.7f, float(i / 4) * 1.5f - 0.3f, 0});
    const Affine end = i % 3 == 0   ? Move({0.5f, 0.2f, 0}) * start
                       : i % 3 == 1 ? start * Turn(30 + at, vec3(1, at, 0.5f)) * Scale(vec3(1.3f))
                                    : Move({0, 0.4f, 0.3f}) * start * Turn(-20, vec3(0, 0, 1)) *
                                          Scale(vec3(0.8f, 1.2f, 1));
    scene::Object& object = builder.Place(shapes[i],
                                          i == 3   ? glass
                                          : i == 4 ? mirror
                                                   : patterned,
                                          start);
    object.motion = {{0, start}, {0.5, start}, {1, end}};
  }
  builder.Place(scene::Sphere{vec3(0), 1}, patterned, Scale(vec3(0.4f, 0.2f, -0.3f))).motion = {
      {0, Move({2, -0.5f, 2}) * Scale(vec3(0.4f, 0.2f, -0.3f))},
      {1, Move({1, -0.5f, 2}) * Scale(vec3(0.4f, 0.2f, -0.3f))}};
  builder.Place(scene::Plane{vec3(0, -1, 0), vec3(0, 1, 0)}, patterned).motion = {
      {0, Affine(1.0)}, {1, Move({0.3f, -0.2f, 0})}};
  return builder.Finish();
}

scene::Scene MovingMeshes() {
  SceneBuilder builder("MovingMeshes", vec3(1, 2, 6), vec3(0, 0, 0));
  Open(builder);
  builder.Add(PointLight(vec3(3, 6, 3), 120));
  builder.environment().top = {0.4f, 0.5f, 0.7f};
  const int matte = builder.Add(Matte({0.8f, 0.5f, 0.3f}));
  const int mirror = builder.Add(Mirror(Spectrum(0.7f)));
  const int glass = builder.Add(Glass(1.4f));
  scene::Material lamp = Matte(Spectrum(0.0f));
  lamp.emission.value = {2, 1, 0.5f};
  const int glowing = builder.Add(lamp);
  const scene::MeshGeometry smooth{builder.Add(SmoothOctahedron())};
  const scene::MeshGeometry sharp{builder.Add(Tetrahedron())};
  const scene::MeshGeometry alone{builder.Add(Tetrahedron())};
  const int materials[] = {matte, mirror, glass, matte};
  for (int i = 0; i < 4; ++i) {
    const Affine start = Move({float(i) * 1.6f - 2.4f, 0.2f, -0.5f}) *
                         Scale(vec3(i == 1 ? -0.8f : 0.8f, 0.8f, 0.7f));
    builder.Place(i % 2 == 0 ? smooth : sharp, materials[i], start).motion = {
        {0.1, start}, {0.9, Move({0.2f, 0.3f, 0}) * start * Turn(50, vec3(0.3f, 1, 0))}};
  }
  builder.Place(sharp, matte, Move({0, -0.6f, 1.5f}) * Scale(vec3(0.5f)));
  builder.Place(alone, glowing).motion = {{0, Move({-1, 1.6f, 0}) * Scale(vec3(0.4f))},
                                          {1, Move({1, 1.6f, 0}) * Scale(vec3(0.5f))}};
  builder.Floor(-1);
  return builder.Finish();
}

// The mesh with further keys, in each of which its vertices have turned and moved apart a little more.
scene::Mesh Deforming(scene::Mesh mesh, int keys, float strength) {
  mesh.time = 0;
  for (int k = 1; k < keys; ++k) {
    const float time = float(k) / float(keys - 1);
    scene::MeshKey& key = mesh.keys.emplace_back(
        scene::MeshKey{double(time), mesh.positions, mesh.normals, mesh.tangents});
    for (std::size_t i = 0; i < key.positions.size(); ++i) {
      vec3& p = key.positions[i];
      p += vec3(std::sin(3 * p.y + 2 * time), 0.5f * p.x * p.z, std::cos(2 * p.x) * time) *
           (strength * time);
      if (!key.normals.empty()) key.normals[i] += vec3(p.y, -p.x, 0.3f) * (strength * time);
      if (!key.tangents.empty()) key.tangents[i] += scene::vec4(p.z, p.x, 0, 0) * strength;
    }
  }
  return mesh;
}

// Meshes that change their shape: smooth, flat, moving and mirrored besides, of glass, glowing, under a normal map, and
// one that is placed three times.
scene::Scene DeformingMeshes() {
  SceneBuilder builder("DeformingMeshes", vec3(1, 2, 6), vec3(0, 0, 0));
  Open(builder);
  builder.Add(PointLight(vec3(3, 6, 3), 120));
  builder.environment().top = {0.4f, 0.5f, 0.7f};
  const int matte = builder.Add(Matte({0.8f, 0.5f, 0.3f}));
  const int mirror = builder.Add(Mirror(Spectrum(0.7f)));
  const int glass = builder.Add(Glass(1.4f));
  scene::Material lamp = Matte(Spectrum(0.0f));
  lamp.emission.value = {2, 1, 0.5f};
  scene::Texture bumps;
  scene::Material bumpy = Matte(Spectrum(0.8f));
  bumpy.normalMap = {builder.Add(bumps), 0.5f, false};
  const int materials[] = {matte, mirror, glass, builder.Add(lamp), builder.Add(bumpy)};
  const scene::MeshGeometry shared{builder.Add(Deforming(SmoothOctahedron(), 3, 0.4f))};
  for (int i = 0; i < 5; ++i) {
    const Affine place = Move({float(i) * 1.3f - 2.6f, 0.3f, i % 2 == 0 ? -0.5f : 0.7f}) *
                         Scale(vec3(i == 1 ? -0.7f : 0.7f, 0.7f, 0.6f));
    scene::Mesh own = i % 2 == 0 ? SmoothOctahedron() : Tetrahedron();
    if (i == 4) own.tangents.assign(own.positions.size(), scene::vec4(1, 0, 0, 1));
    const scene::MeshGeometry mesh =
        i < 2 ? shared : scene::MeshGeometry{builder.Add(Deforming(own, 2 + i, 0.3f))};
    scene::Object& object = builder.Place(mesh, materials[i], place);
    if (i % 2 == 1)
      object.motion = {{0, place}, {1, Move({0.1f, 0.3f, 0}) * place * Turn(20, vec3(0, 1, 0))}};
  }
  builder.Place(shared, matte, Move({0, -0.6f, 1.5f}) * Scale(vec3(0.4f)));
  builder.Floor(-1);
  return builder.Finish();
}

scene::Scene MovingCamera() {
  SceneBuilder builder("MovingCamera", vec3(0, 1, 4), vec3(0, 0, 0));
  Open(builder);
  scene::Camera& camera = builder.camera();
  camera.lens.radius = 0.05f;
  camera.lens.focusDistance = 4;
  const Affine start = Move({0, 1, 4});
  camera.motion = {{0, start}, {1, Move({0.4f, 0.1f, 0}) * start * Turn(8, vec3(0.1f, 1, 0.3f))}};
  builder.Add(SunLight(vec3(-1, -2, -1), 3));
  // Glass through which the camera flies
  builder.Place(scene::Sphere{vec3(0.6f, 1, 4), 0.4f}, builder.Add(Glass(1.3f)));
  builder.Place(scene::Box{vec3(-0.7f), vec3(0.7f)}, builder.Add(Matte({0.3f, 0.5f, 0.8f})));
  builder.Floor(-0.7f);
  return builder.Finish();
}

}  // namespace

std::vector<scene::Scene> ScenesOfMotion() {
  return {MovingShapes(), MovingMeshes(), DeformingMeshes(), MovingCamera()};
}

}  // namespace snell::agree
