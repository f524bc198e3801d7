// SPDX-License-Identifier: Apache-2.0
//
// Every kind of light, hard and soft, seen and unseen, with every fall-off, few and many, and what glows.
#include <glm/geometric.hpp>

#include "agree/scene_builder.h"
#include "agree/scenes.h"

namespace snell::agree {

namespace {

using scene::Falloff;
using scene::LightKind;
using scene::Sphere;

scene::Light AreaLight(LightKind kind, vec3 position, float radiance) {
  scene::Light light;
  light.kind = kind;
  light.position = position;
  light.strength = radiance;
  light.radius = 0.5f;
  return light;
}

// A room's corner with a few things in it that cast shadows.
SceneBuilder Corner(const char* name) {
  SceneBuilder builder(name, vec3(0, 2, 7), vec3(0, 0.5f, 0));
  scene::Material grey = Matte(Spectrum(0.7f));
  grey.terms.push_back(TermOf(scene::TermKind::Blinn, Spectrum(0.3f), 40, true));
  const int wall = builder.Add(grey);
  builder.Place(Sphere{vec3(-1.2f, 0.2f, 0), 0.7f}, wall);
  builder.Place(scene::Box{vec3(0.5f, -0.5f, -0.5f), vec3(1.4f, 1, 0.3f)}, wall);
  builder.Place(scene::MeshGeometry{builder.Add(Tetrahedron())}, wall, Move({0, 0.2f, 1.5f}));
  builder.Place(scene::Plane{vec3(0, 0, -3), vec3(0, 0, 1)}, wall);
  builder.Floor(-0.5f);
  return builder;
}

// How a lamp shines that was measured: in planes all around, or the same in all.
scene::LightProfile Measured(std::size_t planes) {
  scene::LightProfile profile;
  profile.verticals = {0, 0.3f, 0.7f, 1, 1.6f, 2.5f};
  profile.horizontals.push_back(0);
  for (std::size_t i = 1; i < planes; ++i)
    profile.horizontals.push_back(6.2831853f * float(i) / float(planes - 1));
  for (std::size_t i = 0; i < planes * profile.verticals.size(); ++i)
    profile.intensities.push_back(float((i * 7 + 3) % 11));
  return profile;
}

// Let lights shine by profiles in turn, as lamps that are turned.
scene::Scene WithProfiles(scene::Scene scene, scene::LightKind kind) {
  scene.profiles = {Measured(1), Measured(5)};
  int count = 0;
  for (scene::Light& light : scene.lights) {
    if (light.kind != kind || ++count % 2 == 0) continue;
    light.profile = count / 2 % 2;
    if (kind == LightKind::Point) light.direction = glm::normalize(vec3(0.2f, -1, 0.1f));
    light.edgeU = vec3(1, 0, 0.5f);
    light.edgeV = vec3(0.5f, 0, -1);
  }
  return scene;
}

// Points and spots by each law, with and without a range, some of them as measured.
scene::Scene FalloffLaws() {
  SceneBuilder builder = Corner("FalloffLaws");
  const vec3 colors[3] = {{1, 0.4f, 0.3f}, {0.3f, 1, 0.4f}, {0.3f, 0.5f, 1}};
  const Falloff laws[3] = {Falloff::None, Falloff::Linear, Falloff::InverseSquare};
  const float strengths[3] = {0.8f, 2, 8};
  for (int i = 0; i < 3; ++i) {
    scene::Light point = PointLight(vec3(float(i) * 2 - 2, 3, 2), strengths[i]);
    point.color = colors[i];
    point.falloff = laws[i];
    point.falloffFactor = 0.7f;
    point.range = i == 0 ? 0 : 4 + float(i);
    builder.Add(point);
    scene::Light spot =
        SpotLight(vec3(float(i) * 2 - 2, 4, 3), vec3(float(i) - 1, 0, 0), 3 * strengths[i]);
    spot.falloff = laws[i];
    spot.range = i == 1 ? 8 : 0;
    spot.innerAngle = i == 2 ? 0.4f : 0.2f;
    spot.outerAngle = 0.4f;
    builder.Add(spot);
  }
  return WithProfiles(builder.Finish(), LightKind::Point);
}

// The four areas, visible and reflected in a ball.
scene::Scene AreaLights() {
  SceneBuilder builder = Corner("AreaLights");
  builder.Place(Sphere{vec3(1, 0.2f, 2), 0.6f}, builder.Add(Mirror(Spectrum(0.8f))));
  scene::Light rectangle = AreaLight(LightKind::Rectangle, vec3(-2.5f, 3, 0.5f), 5);
  rectangle.edgeU = vec3(0, 0, -1);
  rectangle.edgeV = vec3(1, 0.2f, 0);
  rectangle.color = {1, 0.8f, 0.6f};
  rectangle.group = "key";
  builder.Add(rectangle);
  scene::Light triangle = AreaLight(LightKind::Triangle, vec3(0, 3, 0), 6);
  triangle.edgeU = vec3(0, 0, -1);
  triangle.edgeV = vec3(1, 0, 0);
  builder.Add(triangle);
  scene::Light disk = AreaLight(LightKind::Disk, vec3(2.5f, 2.5f, 1), 6);
  disk.direction = glm::normalize(vec3(-1, -1, 0));
  disk.samples = 3;
  builder.Add(disk);
  builder.Add(AreaLight(LightKind::Sphere, vec3(-0.5f, 1.8f, -1.5f), 3));
  scene::Light around = AmbientLight(0.1f);
  around.group = "around";
  builder.Add(around);
  scene::Material glowing = Matte(Spectrum(0.2f));
  glowing.emission.value = Spectrum(0.5f, 0.3f, 0.1f);
  glowing.lightGroup = "glow";
  builder.Place(scene::MeshGeometry{builder.Add(Tetrahedron())}, builder.Add(glowing),
                Move({2, -0.3f, 2}) * Scale(vec3(0.3f)));
  builder.environment().top = builder.environment().bottom = Spectrum(0.02f, 0.03f, 0.05f);
  builder.environment().lightGroup = "around";
  return builder.Finish();
}

// Areas that nobody sees, by the teaching laws and with ranges; one of them around the scene's middle.
scene::Scene UnseenAreas() {
  SceneBuilder builder = Corner("UnseenAreas");
  const LightKind kinds[4] = {LightKind::Rectangle, LightKind::Triangle, LightKind::Disk,
                              LightKind::Sphere};
  for (int i = 0; i < 4; ++i) {
    scene::Light light = AreaLight(kinds[i], vec3(float(i) * 1.5f - 2.5f, 3, 1), 1.5f);
    light.visible = false;
    light.falloff = i % 2 == 0 ? Falloff::Linear : Falloff::None;
    light.falloffFactor = 1.5f;
    light.range = i < 2 ? 6 : 0;
    light.samples = 2;
    builder.Add(light);
  }
  scene::Light around = AreaLight(LightKind::Sphere, vec3(0, 0, 0), 0.1f);
  around.visible = false;
  around.radius = 30;
  builder.Add(around);
  return builder.Finish();
}

// Points, spots and the sun with an extent, whose shadows are soft.
scene::Scene SoftLights() {
  SceneBuilder builder = Corner("SoftLights");
  scene::Light point = PointLight(vec3(-2, 3, 2), 12);
  point.radius = 0.4f;
  builder.Add(point);
  scene::Light linear = PointLight(vec3(2, 3, 2), 1);
  linear.radius = 0.3f;
  linear.falloff = Falloff::Linear;
  linear.samples = 2;
  builder.Add(linear);
  scene::Light spot = SpotLight(vec3(0, 4, 3), vec3(0, 0, 0), 60);
  spot.radius = 0.2f;
  builder.Add(spot);
  scene::Light sun = SunLight(vec3(1, -2, -1), 1);
  sun.angularSize = 0.1f;
  sun.samples = 5;
  builder.Add(sun);
  scene::Light low = SunLight(vec3(-1, -0.3f, -0.5f), 0.5f);
  low.angularSize = 0.009f;
  builder.Add(low);
  return builder.Finish();
}

// Pictures of all directions: dim, with a bright spot that stretches over the border.
scene::Image Panorama(bool isFloat) {
  scene::Image image;
  image.name = "panorama";
  image.width = 16;
  image.height = 8;
  image.srgb = !isFloat;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const bool isBright = y == 2 && (x == 0 || x == 15);
      const int dim[4] = {40 + 8 * y, 60 + 3 * x, 110 - 10 * y, 255};
      for (const int code : dim) {
        if (isFloat) image.floats.push_back(isBright ? 20.0f : float(code) / 255);
        if (!isFloat) image.bytes.push_back(std::uint8_t(isBright ? 255 : code / 2));
      }
    }
  }
  return image;
}

// A turned map, beside a sun whose disc a ball mirrors.
scene::Scene MapAndSun() {
  SceneBuilder builder = Corner("MapAndSun");
  builder.Place(Sphere{vec3(1, 0.2f, 2), 0.6f}, builder.Add(Mirror(Spectrum(0.8f))));
  builder.environment().map = builder.Add(Panorama(true));
  builder.environment().mapScale = {1, 0.9f, 0.7f};
  builder.environment().rotation = 2;
  builder.environment().sun = 0;
  builder.environment().ambient = true;
  scene::Light sun = SunLight(vec3(-0.3f, -1, -1), 2);
  sun.angularSize = 0.3f;
  builder.Add(sun);
  sun.direction = glm::normalize(vec3(0.8f, -1, -0.5f));
  builder.Add(sun);
  return builder.Finish();
}

// A map of few bits alone, which the camera does not see.
scene::Scene UnseenMap() {
  SceneBuilder builder = Corner("UnseenMap");
  builder.Place(Sphere{vec3(1, 0.2f, 2), 0.6f}, builder.Add(Glass(1.5f)));
  builder.environment().map = builder.Add(Panorama(false));
  builder.environment().visible = false;
  builder.environment().ambient = true;
  return builder.Finish();
}

// More lights of all kinds than a loop would want, among them two suns and one that is dark.
SceneBuilder CornerOfManyLights(const char* name) {
  SceneBuilder builder = Corner(name);
  for (int i = 0; i < 24; ++i) {
    const float x = float(i % 6) - 2.5f, z = float(i / 6) - 1;
    if (i % 3 == 0) {
      builder.Add(PointLight(vec3(x, 2.5f, z), i == 0 ? 0 : 0.7f));
    } else if (i % 3 == 1) {
      builder.Add(SpotLight(vec3(x, 3, z), vec3(0, 0, 0), 1.5f));
    } else {
      scene::Light sphere = AreaLight(LightKind::Sphere, vec3(x, 2, z), 4);
      sphere.radius = 0.06f;
      builder.Add(sphere);
    }
  }
  builder.Add(SunLight(vec3(1, -2, -1), 0.2f));
  scene::Light wide = SunLight(vec3(-1, -0.5f, -0.5f), 0.1f);
  wide.angularSize = 0.2f;
  builder.Add(wide);
  return builder;
}

scene::Scene ManyLights() {
  return WithProfiles(CornerOfManyLights("ManyLights").Finish(), LightKind::Spot);
}

// The same, chosen by power alone.
scene::Scene ManyLightsByPower() {
  SceneBuilder builder = CornerOfManyLights("ManyLightsByPower");
  builder.settings().lightSampling = scene::LightSampling::Power;
  return builder.Finish();
}

// Everything that glows: meshes in the world and as instances, spheres, disks, rectangles and a box; one with a
// texture, one that glows from its front alone; and one light beside them.
scene::Scene GlowingThings() {
  SceneBuilder builder = Corner("GlowingThings");
  const auto glowing = [](Spectrum radiance) {
    scene::Material material = Matte(Spectrum(0.3f));
    material.emission.value = radiance;
    return material;
  };
  scene::Texture checker;
  checker.space = scene::TextureSpace::Object;
  checker.placement = Scale(vec3(0.3f));
  scene::Material tiled = glowing(Spectrum(4));
  tiled.emission.texture = builder.Add(checker);
  scene::Material front = glowing({3, 1, 1});
  front.doubleSided = false;
  const int warm = builder.Add(glowing({4, 3, 1})), pattern = builder.Add(tiled);
  const int mesh = builder.Add(Tetrahedron());
  for (const float x : {-2.0f, 0.0f})
    builder.Place(scene::MeshGeometry{mesh}, warm,
                  Move({x, 2.4f, 1}) * Shear(0.3f) * Scale({0.2f, 0.3f, -0.2f}));
  builder.Place(scene::MeshGeometry{builder.Add(SmoothOctahedron())}, pattern,
                Move({1.8f, 2, 1}) * Scale(vec3(0.4f)));
  builder.Place(Sphere{vec3(-0.2f, 1.5f, -0.5f), 0.25f}, warm);
  builder.Place(Sphere{vec3(0), 0.2f}, pattern, Move({1, 1.6f, -0.5f}) * Scale({2, 1, 1}));
  builder.Place(scene::Disk{vec3(-2, 1, -1), vec3(0.5f, 0, 1), 0.5f, 0.3f}, pattern);
  builder.Place(scene::Rectangle{vec3(-0.5f, 2.5f, -1), vec3(0, 0, -0.5f), vec3(-1, 0, 0)},
                builder.Add(front));
  builder.Place(scene::Box{vec3(2, 0, 0), vec3(2.2f, 0.2f, 0.2f)}, warm);
  builder.Add(PointLight(vec3(0, 3, 4), 2));
  return builder.Finish();
}

}  // namespace

std::vector<scene::Scene> ScenesOfLights() {
  return {FalloffLaws(), AreaLights(), UnseenAreas(),       SoftLights(),   MapAndSun(),
          UnseenMap(),   ManyLights(), ManyLightsByPower(), GlowingThings()};
}

}  // namespace snell::agree
