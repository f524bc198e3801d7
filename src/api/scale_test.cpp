// SPDX-License-Identifier: Apache-2.0
//
// Whole pictures from 1e-4 to 1e5 units, near the origin and far from it: no dark speckles on lit surfaces, no
// bright ones in shadows, the same picture at every scale; and closed meshes that neither light nor mirrored
// rays get through.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <utility>

#include "api/render.h"
#include "scene/scene.h"
#include "scene/validate.h"
#include "support/meshes.h"
#include "support/transforms.h"

namespace snell {
namespace {

using glm::dvec3;
using kernel::Spectrum;
using kernel::vec3;
using scene::Affine;
using test::Random;

scene::Mesh ToMesh(const test::TriangleMesh& mesh) {
  scene::Mesh out;
  out.positions = mesh.positions;
  out.triangles = mesh.triangles;
  return out;
}

Picture Rendered(const scene::Scene& scene) {
  scene::Validate(scene, nullptr);
  return Render(Scene(std::make_shared<scene::Scene>(scene))).picture;
}

// --- Speckles -------------------------------------------------------------------------------------------

// Where the scene stands and how large it is.
struct Place {
  double scale;
  dvec3 offset;  // in scales
};

// One of every shape on a ground of a plane or a mesh, matte, under a point light that keeps its brightness.
scene::Scene Table(const Place& place, bool meshGround) {
  scene::Scene scene;
  scene.settings.width = 240;
  scene.settings.height = 160;
  scene.settings.spp = 1;
  scene.settings.filter = scene::PixelFilter::Box;
  const Affine map = glm::translate(glm::scale(Affine(1.0), dvec3(place.scale)), place.offset);
  const auto at = [&](dvec3 p) { return vec3(dvec3(map * glm::dvec4(p, 1))); };

  scene::Camera camera;
  camera.position = at({1, 5.5, 11});
  camera.lookAt = at({0, 0.5, 0});
  scene.cameras = {camera};
  scene::Light light;
  light.position = at({5, 7, 6});
  light.strength = float(100 * place.scale * place.scale);
  scene.lights = {light};
  scene::Material matte;
  matte.terms.resize(1);
  scene.materials = {matte};

  const auto add = [&](const scene::Geometry& geometry, const Affine& local = Affine(1.0)) {
    scene::Object object;
    object.geometry = geometry;
    object.material = 0;
    object.toWorld = map * local;
    scene.objects.push_back(object);
  };
  Random random(750);
  scene.meshes = {ToMesh(test::Icosphere(3)), ToMesh(test::Bipyramid(random, 24, 1, 0.05)),
                  ToMesh(test::Grid(24))};
  const auto move = [](double x, double y, double z) {
    return glm::translate(Affine(1.0), dvec3(x, y, z));
  };
  if (meshGround) {
    add(scene::MeshGeometry{2}, glm::scale(Affine(1.0), dvec3(12)));
  } else {
    add(scene::Plane{});
  }
  add(scene::Sphere{vec3(-3, 1, 0), 1});
  add(scene::Sphere{}, glm::scale(move(-1.4, 0.5, 2.5), dvec3(1, 0.5, 0.6)));
  add(scene::MeshGeometry{0}, move(0, 1, 0));
  add(scene::MeshGeometry{0}, glm::scale(move(2.6, 0.4, 2.4), dvec3(0.9, 0.4, 0.5)));
  add(scene::MeshGeometry{1}, move(3, 1, 0));
  add(scene::Torus{vec3(0.6f, 0.3f, 3), vec3(0, 1, 0), 0.7f, 0.3f});
  add(scene::Box{vec3(-5, 0, -1), vec3(-4.2f, 2, 1)});
  add(scene::Cone{vec3(5, 0, 0), vec3(5, 2, 0), 0.8f, 0, true});
  add(scene::Cone{vec3(-3, 0, 3), vec3(-3, 0.8f, 3), 0.6f, 0.4f, false});
  add(scene::Disk{vec3(1, 1.5f, -2.5f), glm::normalize(vec3(1, 2, 2)), 1, 0.4f});
  add(scene::Rectangle{vec3(-2.5f, 0, -2), vec3(1.5f, 0, -0.5f), vec3(0, 2, -0.3f)});
  return scene;
}

// By pixel: the share of the light that arrives; −1 where the surface is turned away.
struct LightMap {
  int width;
  int height;
  std::vector<float> share;
};
LightMap LightMapOf(scene::Scene scene) {
  const Picture shadowed = Rendered(scene);
  for (scene::Object& object : scene.objects) object.castsShadow = false;
  const Picture lit = Rendered(scene);
  LightMap map{lit.width, lit.height, {}};
  const float brightest = *std::max_element(lit.rgb.begin(), lit.rgb.end());
  for (std::size_t i = 0; i < lit.rgb.size(); i += 3)
    map.share.push_back(lit.rgb[i] > 1e-3f * brightest ? shadowed.rgb[i] / lit.rgb[i] : -1.0f);
  return map;
}

// Pixels unlike all of their neighbours, which are alike.
std::vector<std::pair<int, int>> SpecklesIn(const LightMap& map) {
  std::vector<std::pair<int, int>> speckles;
  for (int y = 1; y + 1 < map.height; ++y) {
    for (int x = 1; x + 1 < map.width; ++x) {
      const auto at = [&](int dx, int dy) {
        return map.share[std::size_t(y + dy) * std::size_t(map.width) + std::size_t(x + dx)];
      };
      float least = 2, most = -2;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          if (dx == 0 && dy == 0) continue;
          least = std::min(least, at(dx, dy));
          most = std::max(most, at(dx, dy));
        }
      }
      if (at(0, 0) < 0 || least < 0 || most - least > 0.01f) continue;
      if (std::abs(at(0, 0) - least) > 0.02f) speckles.emplace_back(x, y);
    }
  }
  return speckles;
}

// The share of pixels whose light differs.
double Difference(const LightMap& a, const LightMap& b) {
  int different = 0;
  for (std::size_t i = 0; i < a.share.size(); ++i)
    different += std::abs(a.share[i] - b.share[i]) > 0.02f;
  return double(different) / double(a.share.size());
}

TEST(Scale, LeavesNoSpecklesAndChangesNothing) {
  for (const bool meshGround : {false, true}) {
    const LightMap one = LightMapOf(Table({1, dvec3(0)}, meshGround));
    // The picture shows what it should: much in light, some in shadow, some turned away
    const auto count = [&](float lower, float upper) {
      return std::count_if(one.share.begin(), one.share.end(),
                           [&](float s) { return s >= lower && s <= upper; });
    };
    EXPECT_GT(count(0.99f, 1.01f), 15000);
    EXPECT_GT(count(0, 0.01f), 1500);
    EXPECT_GT(count(-1, -1), 500);
    // The tip of a shadow beside the ball's rim fills one pixel; it does so at every scale
    const auto tip = SpecklesIn(one);
    EXPECT_LE(tip.size(), 1u);
    for (const double scale : {1e-4, 1e-3, 0.03, 0.7, 30.0, 1e3, 1e5}) {
      const LightMap map = LightMapOf(Table({scale, dvec3(0)}, meshGround));
      EXPECT_EQ(SpecklesIn(map), tip) << scale;
      EXPECT_LT(Difference(map, one), 0.002) << scale;
    }
    for (const double scale : {1e-4, 1.0, 1e5}) {
      const LightMap map = LightMapOf(Table({scale, dvec3(700, 30, -400)}, meshGround));
      EXPECT_EQ(SpecklesIn(map), tip) << "far from the origin, at " << scale;
    }
  }
}

// --- Dark rooms -----------------------------------------------------------------------------------------

// The camera stands in a closed mesh, in world space or one of two instances.
scene::Scene Room(Random& random, double scale, int kind, bool instanced) {
  scene::Scene scene;
  scene.settings.width = scene.settings.height = 64;
  scene.settings.spp = 2;
  scene.settings.maxDepth = 8;
  scene.settings.minContribution = 0;
  scene.meshes = {ToMesh(kind == 0   ? test::Icosphere(3)
                         : kind == 1 ? test::Cube()
                                     : test::Bipyramid(random, 40, 1, 1e-3))};
  scene::Object room;
  room.geometry = scene::MeshGeometry{0};
  room.material = 0;
  // In world space without squeezing: in edges that it makes as sharp as a degree or so, rounding may still
  // let one ray in some millions start beyond the other wall
  const test::MapKind map = instanced ? test::MapKind::Sheared : test::MapKind::Mirrored;
  room.toWorld = test::RandomMap(random, map, scale, instanced ? 0 : random.Index(2) * 20);
  scene.objects = {room};
  const dvec3 center(room.toWorld[3]);
  if (instanced) {
    room.toWorld = glm::translate(Affine(1.0), dvec3(1e3 * scale)) * room.toWorld;
    scene.objects.push_back(room);
  }
  scene.materials.resize(1);
  scene::Camera camera;
  camera.position = vec3(center);
  camera.lookAt = vec3(center + random.Direction() * scale);
  camera.up = vec3(random.Direction());
  camera.fov = 1.8f;
  scene.cameras = {camera};
  // Lights all round, outside
  for (int i = 0; i < 6; ++i) {
    scene::Light light;
    light.position = vec3(center + random.Direction() * (60 * scale));
    light.strength = float(1e6 * scale * scale);
    scene.lights.push_back(light);
  }
  return scene;
}

// Channels of the picture that are not exactly black.
std::ptrdiff_t Leaks(const scene::Scene& scene) {
  const Picture picture = Rendered(scene);
  return std::count_if(picture.rgb.begin(), picture.rgb.end(), [](float c) { return c != 0; });
}

TEST(ClosedMeshes, KeepLightAndRaysOut) {
  Random random(751);
  std::ptrdiff_t seen = 0, lit = 0, mirrored = 0;
  for (std::uint64_t round = 0; round < test::Scaled(2); ++round) {
    for (const double scale : {1e-4, 1.0, 1e5}) {
      for (const int kind : {0, 1, 2}) {
        for (const bool instanced : {false, true}) {
          // The bright surroundings through a black wall
          scene::Scene scene = Room(random, scale, kind, instanced);
          scene.environment.bottom = scene.environment.top = Spectrum(1.0f);
          seen += Leaks(scene);
          // In mirrors
          scene.materials[0].reflectivity.value = Spectrum(1.0f);
          mirrored += Leaks(scene);
          // The lights through a white one
          scene.materials[0].reflectivity.value = Spectrum(0.0f);
          scene.materials[0].terms.resize(1);
          scene.environment = {};
          lit += Leaks(scene);
        }
      }
    }
  }
  EXPECT_EQ(seen, 0) << "seen through walls";
  EXPECT_EQ(mirrored, 0) << "reflected rays through walls";
  EXPECT_EQ(lit, 0) << "light through walls";
}

TEST(ClosedMeshes, AreLitFromWithin) {
  // The counterpart: the same rooms with a lamp inside are bright all over
  Random random(752);
  for (const double scale : {1e-4, 1.0, 1e5}) {
    for (const int kind : {0, 1, 2}) {
      for (const bool instanced : {false, true}) {
        scene::Scene scene = Room(random, scale, kind, instanced);
        scene.materials[0].terms.resize(1);
        scene.lights.resize(1);
        scene.lights[0].position = scene.cameras[0].position;
        scene.lights[0].strength = float(scale * scale);
        const Picture picture = Rendered(scene);
        // Convex, and lit from where it is seen: no shadow anywhere
        EXPECT_EQ(std::count(picture.rgb.begin(), picture.rgb.end(), 0.0f), 0)
            << scale << ", mesh " << kind << (instanced ? ", instanced" : "");
      }
    }
  }
}

// --- Numbers beyond all measure -------------------------------------------------------------------------

TEST(Scale, NeverCrashesBeyondAllMeasure) {
  for (const double scale : {1e-35, 1e-25, 1e-15, 1e9, 1e15, 1e25, 1e35}) {
    scene::Scene scene = Table({scale, dvec3(0)}, true);
    scene.settings.width = 32;
    scene.settings.height = 24;
    for (scene::Light& light : scene.lights) light.strength = 1;
    const Picture picture = Rendered(scene);
    for (const float c : picture.rgb) EXPECT_TRUE(std::isfinite(c)) << scale;
  }
}

}  // namespace
}  // namespace snell
