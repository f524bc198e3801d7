// SPDX-License-Identifier: Apache-2.0
//
// Shader terms, reflection models, textures in every space and in every place.
#include "agree/scene_builder.h"
#include "agree/scenes.h"

namespace snell::agree {

namespace {

using scene::Box;
using scene::ReflectionModel;
using scene::Sphere;
using scene::TermKind;
using scene::TextureKind;
using scene::TextureSpace;

// Each term alone, their stack, and a stack longer than what the kernel keeps.
scene::Scene Terms() {
  SceneBuilder builder("Terms", vec3(0, 0, 7), vec3(0, 0, 0));
  builder.Add(AmbientLight(0.6f));
  builder.Add(SunLight(vec3(-1, -1, -1), 2));
  builder.Add(PointLight(vec3(-3, 3, 4), 40));
  builder.settings().filter = scene::PixelFilter::Gaussian;
  builder.settings().filterRadius = 0.8f;
  const Spectrum orange(0.9f, 0.5f, 0.1f);
  const Spectrum white(0.8f);
  std::vector<std::vector<scene::Term>> stacks = {
      {TermOf(TermKind::Ambient, orange)},
      {TermOf(TermKind::Diffuse, orange)},
      {TermOf(TermKind::Phong, white, 30)},
      {TermOf(TermKind::Phong, white, 30, true)},
      {TermOf(TermKind::Blinn, white, 0.5f)},
      {TermOf(TermKind::Blinn, white, 90, true)},
      {TermOf(TermKind::Phong, white, 0)},
      {TermOf(TermKind::Ambient, orange), TermOf(TermKind::Diffuse, orange),
       TermOf(TermKind::Phong, white, 1000)},
      {}};
  for (int i = 0; i < 11; ++i)
    stacks.back().push_back(TermOf(i % 2 == 0 ? TermKind::Diffuse : TermKind::Blinn,
                                   Spectrum(0.02f * float(i), 0.1f, 0.05f), 5 + float(i)));
  for (std::size_t i = 0; i < stacks.size(); ++i) {
    scene::Material material;
    material.terms = stacks[i];
    const vec3 place(float(i % 3) * 1.9f - 1.9f, float(i / 3) * 1.9f - 1.9f, 0);
    builder.Place(Sphere{place, 0.9f}, builder.Add(material));
  }
  return builder.Finish();
}

// Two mirrors that face each other, and the three models of reflection between them.
scene::Scene Mirrors() {
  SceneBuilder builder("Mirrors", vec3(0.5f, 1.5f, 6), vec3(0, 0.5f, 0));
  builder.Add(PointLight(vec3(0, 5, 3), 80));
  builder.Add(AmbientLight(0.2f));
  builder.environment() = {{0.1f, 0.1f, 0.2f}, {0.5f, 0.6f, 0.8f}, -1, 1, 1};
  builder.settings().maxDepth = 12;
  builder.settings().maxDiffuseDepth = 1;
  builder.settings().maxSpecularDepth = 2;
  builder.settings().maxTransmissionDepth = 3;
  builder.settings().minContribution = 0.001f;
  const ReflectionModel models[3] = {ReflectionModel::Constant, ReflectionModel::Fresnel,
                                     ReflectionModel::Schlick};
  for (int i = 0; i < 3; ++i) {
    scene::Material material = Matte({0.6f, 0.2f, 0.2f * float(i)});
    material.reflection = models[i];
    material.reflectivity.value = i == 1 ? Spectrum(1.0f) : Spectrum(0.6f, 0.4f, 0.2f);
    material.ior = 1.8f;
    builder.Place(Sphere{vec3(float(i) * 1.3f - 1.3f, 0.1f, 0), 0.6f}, builder.Add(material));
  }
  const int mirror = builder.Add(Mirror({0.95f, 0.9f, 0.9f}));
  builder.Place(scene::Rectangle{vec3(-2, -0.5f, -2), vec3(0, 0, 5), vec3(0, 3, 0)}, mirror);
  builder.Place(scene::Rectangle{vec3(2, -0.5f, -2), vec3(0, 0, 5), vec3(0.1f, 3, 0)}, mirror);
  builder.Floor(-0.5f);
  return builder.Finish();
}

scene::Texture TextureOf(TextureKind kind, TextureSpace space, bool smooth) {
  scene::Texture texture;
  texture.kind = kind;
  texture.space = space;
  texture.smooth = smooth;
  texture.colorA = {0.9f, 0.3f, 0.1f};
  texture.colorB = {0.1f, 0.4f, 0.8f};
  texture.turbulence = 0.6f;
  texture.octaves = 3;
  texture.placement = Turn(20, vec3(1, 2, 3)) * Scale(vec3(0.3f, 0.4f, 0.25f));
  return texture;
}

// The five textures in the three spaces, sharp above and smooth below.
scene::Scene Textures() {
  SceneBuilder builder("Textures", vec3(0, 0, 9), vec3(0, 0, 0));
  builder.Add(PointLight(vec3(-4, 5, 8), 300));
  builder.settings().filter = scene::PixelFilter::BlackmanHarris;
  builder.settings().filterRadius = 2;
  const TextureKind kinds[5] = {TextureKind::Checker, TextureKind::Stripes, TextureKind::Gradient,
                                TextureKind::Marble, TextureKind::Wood};
  const TextureSpace spaces[3] = {TextureSpace::Uv, TextureSpace::Object, TextureSpace::World};
  for (int i = 0; i < 30; ++i) {
    scene::Material material = Matte(Spectrum(0.9f));
    material.terms[1].color.texture =
        builder.Add(TextureOf(kinds[i % 5], spaces[i / 5 % 3], i >= 15));
    const Affine place = Move({float(i % 5) * 1.3f - 2.6f, float(i / 5) * 1.2f - 3, 0}) *
                         Turn(float(i) * 25, vec3(0, 1, 1)) * Scale(vec3(0.55f));
    const int index = builder.Add(material);
    if (i % 2 == 0) {
      builder.Place(Sphere{}, index, place);
    } else {
      builder.Place(Box{vec3(-0.8f), vec3(0.8f)}, index, place);
    }
  }
  return builder.Finish();
}

// Textures of emission, reflectivity, transparency and specular terms.
scene::Scene TexturedEverything() {
  SceneBuilder builder("TexturedEverything", vec3(0, 2, 7), vec3(0, 0.3f, 0));
  builder.Add(PointLight(vec3(3, 5, 4), 120));
  builder.environment().top = {0.5f, 0.6f, 0.7f};
  const int checker = builder.Add(TextureOf(TextureKind::Checker, TextureSpace::Object, false));
  const int wood = builder.Add(TextureOf(TextureKind::Wood, TextureSpace::Object, true));
  const int stripes = builder.Add(TextureOf(TextureKind::Stripes, TextureSpace::Uv, false));
  scene::Material glowing = Matte(Spectrum(0.3f));
  glowing.emission = Textured(wood, Spectrum(0.7f));
  scene::Material patchy = Matte(Spectrum(0.5f));
  patchy.reflectivity = Textured(checker, Spectrum(0.9f));
  scene::Material window = Glass(1.5f);
  window.transparency = Textured(stripes);
  window.terms = {TermOf(TermKind::Diffuse, Spectrum(0.8f))};
  scene::Material varnish = Matte({0.4f, 0.2f, 0.1f});
  varnish.terms.push_back(TermOf(TermKind::Blinn, Spectrum(1.0f), 60));
  varnish.terms.back().color.texture = checker;
  builder.Place(Sphere{vec3(-2.2f, 0.2f, 0), 0.7f}, builder.Add(glowing));
  builder.Place(Sphere{vec3(-0.7f, 0.2f, 0.5f), 0.7f}, builder.Add(patchy));
  builder.Place(Sphere{vec3(0.9f, 0.2f, 0.8f), 0.7f}, builder.Add(window));
  builder.Place(Sphere{vec3(2.3f, 0.2f, 0), 0.7f}, builder.Add(varnish));
  builder.Floor(-0.5f);
  return builder.Finish();
}

}  // namespace

std::vector<scene::Scene> ScenesOfMaterials() {
  return {Terms(), Mirrors(), Textures(), TexturedEverything()};
}

}  // namespace snell::agree
