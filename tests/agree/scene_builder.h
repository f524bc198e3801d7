// SPDX-License-Identifier: Apache-2.0
//
// Words for building test scenes in C++ in a few lines: materials, lights, transforms, meshes.
#pragma once

#include <string>
#include <utility>

#include "scene/scene.h"

namespace snell::agree {

using scene::Affine;
using scene::Spectrum;
using scene::vec3;

// A scene in the making. Functions that add something return its index.
class SceneBuilder {
 public:
  // 64 × 64 pixels; a camera at `eye` that looks at `target`, 45 degrees wide; no light.
  SceneBuilder(std::string name, vec3 eye, vec3 target);

  int Add(scene::Image image);
  int Add(scene::Texture texture);
  int Add(scene::Material material);
  int Add(scene::Mesh mesh);
  void Add(scene::Light light);
  scene::Object& Place(scene::Geometry geometry, int material, const Affine& toWorld = Affine(1.0));
  // The plane at this height, with a checker in world space.
  void Floor(float y);

  scene::Camera& camera() { return scene_.cameras[0]; }
  scene::RenderSettings& settings() { return scene_.settings; }
  scene::Environment& environment() { return scene_.environment; }
  // Hand the scene out.
  scene::Scene Finish() { return std::move(scene_); }

 private:
  scene::Scene scene_;
};

// Transforms; angles in degrees. Combine them by multiplication, the last one is applied first.
Affine Move(vec3 offset);
Affine Turn(float degrees, vec3 axis);
Affine Scale(vec3 factors);
// x is pushed along by y.
Affine Shear(float xByY);

// Materials
scene::ColorInput Textured(int texture, Spectrum value = Spectrum(1.0f));
scene::Term TermOf(scene::TermKind kind, Spectrum color, float exponent = 32,
                   bool normalized = false);
scene::Material Matte(Spectrum color);
scene::Material Mirror(Spectrum reflectivity);
scene::Material Glass(float ior, Spectrum transparency = Spectrum(1.0f));

// Lights
scene::Light AmbientLight(float strength);
scene::Light PointLight(vec3 position, float intensity);
scene::Light SpotLight(vec3 position, vec3 target, float intensity);
scene::Light SunLight(vec3 direction, float irradiance);

// Meshes, each around the origin
// A tetrahedron with flat faces, of circumradius 1.
scene::Mesh Tetrahedron();
// An octahedron of radius 1 with smooth normals and texture coordinates.
scene::Mesh SmoothOctahedron();

}  // namespace snell::agree
