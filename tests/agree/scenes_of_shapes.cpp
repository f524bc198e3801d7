// SPDX-License-Identifier: Apache-2.0
//
// Shapes, transforms, meshes, instances, cameras and filters.
#include <glm/geometric.hpp>

#include "agree/scene_builder.h"
#include "agree/scenes.h"

namespace snell::agree {

namespace {

using scene::Box;
using scene::Cone;
using scene::Disk;
using scene::MeshGeometry;
using scene::Rectangle;
using scene::Sphere;
using scene::Torus;

// A matte material whose checker in uv space shows the texture coordinates.
int UvChecker(SceneBuilder& builder, Spectrum color) {
  scene::Texture checker;
  checker.placement = Scale(vec3(0.25f));
  scene::Material material = Matte(color);
  material.terms[1].color.texture = builder.Add(checker);
  return builder.Add(material);
}

// One of each analytic shape around the origin.
std::vector<scene::Geometry> EachShape() {
  return {Sphere{vec3(0.0f), 0.8f},
          Disk{vec3(0.0f), vec3(0, 1, 1), 0.9f, 0.3f},
          Rectangle{vec3(-0.8f, -0.5f, 0.3f), vec3(1.4f, 0.2f, 0), vec3(0.1f, 1, -0.4f)},
          Box{vec3(-0.6f, -0.4f, -0.7f), vec3(0.6f, 0.5f, 0.4f)},
          Cone{vec3(0, -0.7f, 0), vec3(0.2f, 0.7f, 0), 0.5f, 0.5f, true},
          Cone{vec3(0, -0.7f, 0), vec3(0, 0.8f, 0.1f), 0.7f, 0, true},
          Cone{vec3(0, -0.7f, 0), vec3(0, 0.6f, 0.3f), 0.7f, 0.3f, true},
          Cone{vec3(-0.6f, 0, 0), vec3(0.6f, 0.2f, 0), 0.4f, 0.6f, false},
          Torus{vec3(0.0f), vec3(0.2f, 1, 0.4f), 0.6f, 0.22f}};
}

scene::Scene Shapes() {
  SceneBuilder builder("Shapes", vec3(0, 3, 8), vec3(0, 0.4f, 0));
  builder.Add(PointLight(vec3(3, 6, 5), 160));
  builder.Add(AmbientLight(0.2f));
  builder.environment().top = {0.2f, 0.3f, 0.5f};
  const int material = UvChecker(builder, {0.9f, 0.8f, 0.7f});
  const auto shapes = EachShape();
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const vec3 place(float(i % 3) * 2.0f - 2.0f, 0.3f, float(i / 3) * 2.0f - 2.0f);
    builder.Place(shapes[i], material, Move(place));
  }
  builder.Floor(-0.8f);
  return builder.Finish();
}

// The same, turned, stretched, sheared, mirrored.
scene::Scene TransformedShapes() {
  SceneBuilder builder("TransformedShapes", vec3(1, 4, 8), vec3(0, 0, 0));
  builder.settings().filter = scene::PixelFilter::Tent;
  builder.Add(SunLight(vec3(-1, -2, -1), 3));
  builder.environment() = {{0.3f, 0.2f, 0.1f}, {0.2f, 0.3f, 0.6f}, -0.2f, 0.9f, 1};
  scene::Material material = Matte({0.4f, 0.7f, 0.5f});
  material.terms.push_back(TermOf(scene::TermKind::Phong, Spectrum(0.6f), 20));
  material.reflectivity.value = Spectrum(0.2f);
  const int shiny = builder.Add(material);
  const auto shapes = EachShape();
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const vec3 place(float(i % 3) * 2.2f - 2.2f, 0, float(i / 3) * 2.2f - 2.2f);
    const Affine turned = Move(place) * Turn(float(i) * 40, vec3(1, float(i), 2));
    const Affine bent = i % 3 == 0   ? Scale(vec3(1.2f, 0.5f, -0.8f))
                        : i % 3 == 1 ? Scale(vec3(-1, 1, 1))
                                     : Shear(0.6f) * Scale(vec3(0.8f, 1.1f, 0.7f));
    builder.Place(shapes[i], shiny, turned * bent);
  }
  builder.Place(Sphere{vec3(0, 3, -6), 2}, shiny,
                Turn(30, vec3(0, 0, 1)) * Scale(vec3(0.7f, 0.7f, -0.7f)));
  builder.Place(scene::Plane{vec3(0, -1.5f, 0), vec3(0.1f, 1, 0.05f)}, shiny, Shear(0.3f));
  return builder.Finish();
}

// Meshes in world space, with and without attributes, plain and mirrored; some of them degenerate.
scene::Scene Meshes() {
  SceneBuilder builder("Meshes", vec3(0, 2, 6), vec3(0, 0, 0));
  builder.camera().kind = scene::CameraKind::Orthographic;
  builder.camera().height = 5;
  builder.settings().filter = scene::PixelFilter::Gaussian;
  builder.Add(PointLight(vec3(-3, 5, 4), 120));
  builder.Add(AmbientLight(0.3f));
  const int checkered = UvChecker(builder, {0.8f, 0.9f, 0.9f});
  const int mirror = builder.Add(Mirror({0.8f, 0.7f, 0.5f}));
  builder.Place(MeshGeometry{builder.Add(SmoothOctahedron())}, checkered, Move({-1.5f, 0.6f, 0}));
  builder.Place(MeshGeometry{builder.Add(SmoothOctahedron())}, mirror,
                Move({1.2f, 0.8f, -0.5f}) * Turn(25, vec3(1, 1, 0)) * Scale(vec3(-1, 1.2f, 0.9f)));
  builder.Place(MeshGeometry{builder.Add(Tetrahedron())}, checkered,
                Move({0, -0.4f, 1}) * Scale(vec3(1, -1, 1)));

  // Normals that cancel out and texture coordinates without extent
  scene::Mesh odd = SmoothOctahedron();
  odd.normals[0] = vec3(0, 0, 1);
  odd.normals[2] = vec3(0, 0, -1);
  odd.normals[4] = vec3(0.0f);
  odd.uvs.assign(odd.uvs.size(), scene::vec2(0.3f, 0.6f));
  builder.Place(MeshGeometry{builder.Add(odd)}, checkered,
                Move({-1.2f, -1, 1}) * Scale(vec3(0.6f)));

  // Triangles that are points and lines, and ones that lie in each other's plane
  scene::Mesh flat = Tetrahedron();
  flat.triangles.push_back({0, 0, 0});
  flat.triangles.push_back({0, 1, 1});
  flat.triangles.push_back({0, 2, 1});
  builder.Place(MeshGeometry{builder.Add(flat)}, checkered, Move({1.5f, -1, 1}));
  builder.Floor(-1.6f);
  return builder.Finish();
}

// Meshes used several times: plain, stretched, mirrored; matte, mirrors and glass.
scene::Scene Instances() {
  SceneBuilder builder("Instances", vec3(2, 2.5f, 6), vec3(0, 0, 0));
  builder.settings().filter = scene::PixelFilter::BlackmanHarris;
  builder.Add(PointLight(vec3(3, 6, 3), 150));
  builder.environment().top = {0.4f, 0.5f, 0.7f};
  const int checkered = UvChecker(builder, {0.9f, 0.6f, 0.5f});
  const int mirror = builder.Add(Mirror(Spectrum(0.7f)));
  const int glass = builder.Add(Glass(1.5f, {0.9f, 1, 0.9f}));
  const MeshGeometry smooth{builder.Add(SmoothOctahedron())};
  const MeshGeometry sharp{builder.Add(Tetrahedron())};
  builder.Place(smooth, checkered, Move({-2, 0, 0}));
  builder.Place(smooth, mirror, Move({0, 0.3f, -2}) * Scale(vec3(-1, 1, 1)));
  builder.Place(smooth, glass, Move({0.3f, 0.1f, 1}) * Turn(40, vec3(0, 1, 0)));
  builder.Place(sharp, checkered, Move({2, 0, 0}) * Scale(vec3(0.8f, 1.3f, 0.6f)));
  builder.Place(sharp, glass, Move({-1.2f, -0.3f, 2}) * Scale(vec3(0.7f, -0.7f, 0.7f)));
  builder.Place(sharp, mirror, Move({1.6f, 1.2f, -1.5f}) * Shear(0.4f));
  builder.Floor(-1.1f);
  return builder.Finish();
}

// Objects that the camera, mirrors or shadows do not know.
scene::Scene Visibility() {
  SceneBuilder builder("Visibility", vec3(0, 2, 7), vec3(0, 0.5f, 0));
  builder.Add(PointLight(vec3(2, 6, 4), 150));
  builder.Add(AmbientLight(0.2f));
  const int red = builder.Add(Matte({0.9f, 0.2f, 0.1f}));
  const int blue = builder.Add(Matte({0.1f, 0.3f, 0.9f}));
  const int green = builder.Add(Matte({0.2f, 0.8f, 0.2f}));
  builder.Place(Sphere{vec3(-2, 0.5f, 1), 0.8f}, red).visibleToCamera = false;
  builder.Place(Sphere{vec3(0, 0.5f, 1), 0.8f}, blue).visibleToSecondary = false;
  builder.Place(Sphere{vec3(2, 0.5f, 1), 0.8f}, green).castsShadow = false;
  builder.Place(Rectangle{vec3(-4, -0.5f, -2), vec3(8, 0, 0), vec3(0, 4, -0.5f)},
                builder.Add(Mirror(Spectrum(0.9f))));
  builder.Floor(-0.5f);
  return builder.Finish();
}

// Everything at a hundred-thousandth of the size, far from the origin in proportion.
scene::Scene TinyWorld() {
  const float unit = 1e-4f;
  const vec3 center(3 * unit, 5 * unit, -2 * unit);
  SceneBuilder builder("TinyWorld", center + vec3(0, 2, 6) * unit, center);
  builder.Add(PointLight(center + vec3(2, 5, 4) * unit, 100 * unit * unit));
  const int material = UvChecker(builder, Spectrum(0.8f));
  const int glass = builder.Add(Glass(1.4f));
  const Affine small = Move(center) * Scale(vec3(unit));
  builder.Place(Sphere{}, glass, small);
  builder.Place(Torus{}, material, small * Move({1.5f, 0.3f, -1}));
  builder.Place(Box{}, material, small * Move({-2, 0, -1.5f}) * Turn(30, vec3(1, 2, 0)));
  builder.Place(MeshGeometry{builder.Add(SmoothOctahedron())}, material, small * Move({1, 0, 2}));
  builder.Floor(center.y - unit);
  return builder.Finish();
}

}  // namespace

std::vector<scene::Scene> ScenesOfShapes() {
  return {Shapes(), TransformedShapes(), Meshes(), Instances(), Visibility(), TinyWorld()};
}

}  // namespace snell::agree
