// SPDX-License-Identifier: Apache-2.0
#include "agree/scene_builder.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace snell::agree {

SceneBuilder::SceneBuilder(std::string name, vec3 eye, vec3 target) {
  scene_.name = std::move(name);
  scene_.settings.width = 64;
  scene_.settings.height = 64;
  scene_.settings.filter = scene::PixelFilter::Box;
  scene_.settings.maxDepth = 8;
  scene::Camera camera;
  camera.position = eye;
  camera.lookAt = target;
  camera.fov = 0.785398f;
  scene_.cameras.push_back(camera);
}

int SceneBuilder::Add(scene::Image image) {
  scene_.images.push_back(std::move(image));
  return int(scene_.images.size()) - 1;
}

int SceneBuilder::Add(scene::Texture texture) {
  scene_.textures.push_back(std::move(texture));
  return int(scene_.textures.size()) - 1;
}

int SceneBuilder::Add(scene::Material material) {
  scene_.materials.push_back(std::move(material));
  return int(scene_.materials.size()) - 1;
}

int SceneBuilder::Add(scene::Mesh mesh) {
  scene_.meshes.push_back(std::move(mesh));
  return int(scene_.meshes.size()) - 1;
}

void SceneBuilder::Add(scene::Light light) { scene_.lights.push_back(std::move(light)); }

scene::Object& SceneBuilder::Place(scene::Geometry geometry, int material, const Affine& toWorld) {
  scene::Object object;
  object.geometry = geometry;
  object.material = material;
  object.toWorld = toWorld;
  scene_.objects.push_back(std::move(object));
  return scene_.objects.back();
}

void SceneBuilder::Floor(float y) {
  scene::Texture checker;
  checker.space = scene::TextureSpace::World;
  scene::Material material;
  material.terms = {TermOf(scene::TermKind::Diffuse, Spectrum(1.0f))};
  material.terms[0].color.texture = Add(std::move(checker));
  Place(scene::Plane{vec3(0, y, 0)}, Add(std::move(material)));
}

Affine Move(vec3 offset) { return glm::translate(Affine(1.0), glm::dvec3(offset)); }

Affine Turn(float degrees, vec3 axis) {
  return glm::rotate(Affine(1.0), glm::radians(double(degrees)), glm::normalize(glm::dvec3(axis)));
}

Affine Scale(vec3 factors) { return glm::scale(Affine(1.0), glm::dvec3(factors)); }

Affine Shear(float xByY) {
  Affine shear(1.0);
  shear[1].x = double(xByY);
  return shear;
}

scene::ColorInput Textured(int texture, Spectrum value) { return {value, texture}; }

scene::Term TermOf(scene::TermKind kind, Spectrum color, float exponent, bool normalized) {
  return {kind, {color, -1}, exponent, normalized};
}

scene::Material Matte(Spectrum color) {
  scene::Material material;
  material.terms = {TermOf(scene::TermKind::Ambient, color),
                    TermOf(scene::TermKind::Diffuse, color)};
  return material;
}

scene::Material Mirror(Spectrum reflectivity) {
  scene::Material material;
  material.reflectivity.value = reflectivity;
  return material;
}

scene::Material Glass(float ior, Spectrum transparency) {
  scene::Material material;
  material.terms = {TermOf(scene::TermKind::Phong, Spectrum(0.5f), 200)};
  material.transparency.value = transparency;
  material.ior = ior;
  return material;
}

scene::Light AmbientLight(float strength) {
  scene::Light light;
  light.kind = scene::LightKind::Ambient;
  light.strength = strength;
  return light;
}

scene::Light PointLight(vec3 position, float intensity) {
  scene::Light light;
  light.kind = scene::LightKind::Point;
  light.position = position;
  light.strength = intensity;
  return light;
}

scene::Light SpotLight(vec3 position, vec3 target, float intensity) {
  scene::Light light = PointLight(position, intensity);
  light.kind = scene::LightKind::Spot;
  light.direction = glm::normalize(target - position);
  light.innerAngle = 0.3f;
  light.outerAngle = 0.5f;
  return light;
}

scene::Light SunLight(vec3 direction, float irradiance) {
  scene::Light light;
  light.kind = scene::LightKind::Directional;
  light.direction = glm::normalize(direction);
  light.strength = irradiance;
  return light;
}

scene::Mesh Tetrahedron() {
  const float a = 0.57735027f;
  scene::Mesh mesh;
  mesh.positions = {{a, a, a}, {-a, -a, a}, {-a, a, -a}, {a, -a, -a}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

scene::Mesh SmoothOctahedron() {
  scene::Mesh mesh;
  mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.normals = mesh.positions;
  mesh.uvs = {{0.75f, 0.5f}, {0.25f, 0.5f}, {0.5f, 1}, {0.5f, 0}, {0.5f, 0.5f}, {1, 0.5f}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return mesh;
}

}  // namespace snell::agree
