// SPDX-License-Identifier: Apache-2.0
//
// The shapes that the databases' construction promises: what touches, what closes, what has which volume.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "io/nff/nff.h"
#include "spd/generators.h"

namespace snell::spd {
namespace {

using glm::dvec3;
using scene::vec3;

scene::Scene Read(const std::string& text) { return io::ParseNff(text, "test.nff", {}); }

template <class Shape>
std::vector<Shape> All(const scene::Scene& scene) {
  std::vector<Shape> shapes;
  for (const scene::Object& object : scene.objects)
    if (const Shape* shape = std::get_if<Shape>(&object.geometry)) shapes.push_back(*shape);
  return shapes;
}

struct Bounds {
  dvec3 lower{std::numeric_limits<double>::infinity()};
  dvec3 upper{-std::numeric_limits<double>::infinity()};
  void Include(const vec3& p, float radius = 0) {
    lower = glm::min(lower, dvec3(p) - double(radius));
    upper = glm::max(upper, dvec3(p) + double(radius));
  }
};

Bounds BoundsOf(const scene::Mesh& mesh) {
  Bounds bounds;
  for (const vec3& p : mesh.positions) bounds.Include(p);
  return bounds;
}

void ExpectNear(const dvec3& a, const dvec3& b, double tolerance) {
  EXPECT_LE(glm::length(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z;
}

// Every edge is passed once in each direction: the surface is closed and its sides agree.
void ExpectClosed(const scene::Mesh& mesh) {
  using Point = std::array<float, 3>;
  std::map<std::pair<Point, Point>, int> edges;
  const auto point = [&](std::uint32_t i) {
    const vec3 p = mesh.positions[i];
    return Point{p.x, p.y, p.z};
  };
  for (const scene::uvec3& t : mesh.triangles)
    for (const auto& [a, b] : {std::pair(t.x, t.y), std::pair(t.y, t.z), std::pair(t.z, t.x)})
      ++edges[{point(a), point(b)}];
  for (const auto& [edge, times] : edges) {
    ASSERT_EQ(times, 1);
    ASSERT_EQ(edges.count({edge.second, edge.first}), 1u);
  }
}

double VolumeOf(const scene::Mesh& mesh) {
  double volume = 0;
  for (const scene::uvec3& t : mesh.triangles)
    volume += glm::dot(dvec3(mesh.positions[t.x]),
                       glm::cross(dvec3(mesh.positions[t.y]), dvec3(mesh.positions[t.z]))) /
              6;
  return volume;
}

TEST(Spd, BallsTouchTheirParents) {
  const std::vector<scene::Sphere> spheres = All<scene::Sphere>(Read(Balls(3)));
  ASSERT_EQ(spheres.size(), 820u);

  // 9ⁿ balls of radius ½·3⁻ⁿ, all within the unit sphere
  std::map<int, int> levels;
  for (const scene::Sphere& sphere : spheres) {
    ++levels[int(std::lround(std::log(0.5 / double(sphere.radius)) / std::log(3.0)))];
    EXPECT_LE(glm::length(sphere.center) + sphere.radius, 1.0f + 1e-6f);
  }
  EXPECT_EQ(levels, (std::map<int, int>{{0, 1}, {1, 9}, {2, 81}, {3, 729}}));

  // The nine of the first level: six around the waist, three above
  std::vector<int> children;
  for (std::size_t i = 1; i < spheres.size(); ++i)
    if (spheres[i].radius > 0.16f) children.push_back(int(i));
  ASSERT_EQ(children.size(), 9u);
  int waist = 0, above = 0;
  for (const int i : children) {
    const dvec3 direction = dvec3(spheres[std::size_t(i)].center) / (2.0 / 3);
    EXPECT_NEAR(glm::length(direction), 1, 1e-6);
    waist += std::abs(direction.z) < 1e-6;
    above += std::abs(direction.z - std::sqrt(2.0 / 3)) < 1e-6;
  }
  EXPECT_EQ(waist, 6);
  EXPECT_EQ(above, 3);
}

TEST(Spd, BallsStandOnTheirFloor) {
  const scene::Scene scene = Read(Balls(1));
  const Bounds floor = BoundsOf(scene.meshes.at(0));
  ExpectNear(floor.lower, {-12, -12, -0.5}, 1e-6);
  ExpectNear(floor.upper, {12, 12, -0.5}, 1e-6);
  EXPECT_EQ(scene.cameras[0].position, vec3(2.1f, 1.3f, 1.7f));
}

TEST(Spd, GearsAreClosedAndOneInFiveIsGlass) {
  const scene::Scene scene = Read(Gears(3));
  ASSERT_EQ(scene.meshes.size(), 28u);
  int glass = 0;
  for (const scene::Object& object : scene.objects) {
    const scene::Mesh& mesh =
        scene.meshes[std::size_t(std::get<scene::MeshGeometry>(object.geometry).mesh)];
    if (mesh.triangles.size() == 2) continue;  // the ground
    ExpectClosed(mesh);
    EXPECT_EQ(mesh.triangles.size(), 2u * 142 + 2 * 144);
    glass += scene.materials[std::size_t(object.material)].Refractive();
  }
  EXPECT_EQ(glass, 6);  // of 4x + 2y + z divisible by five
}

TEST(Spd, AGearsVolume) {
  const scene::Scene scene = Read(Gears(1));
  ASSERT_EQ(scene.meshes.size(), 2u);
  const scene::Mesh& gear = scene.meshes[1];

  // Per tooth, triangles around the axis over its top, its flanks and the gap
  const double outer = 0.995, inner = 0.9, tooth = 2 * std::numbers::pi / 36;
  const double area =
      36 * 0.5 *
      (outer * outer * std::sin(0.38 * tooth) + inner * inner * std::sin(0.4 * tooth) +
       2 * outer * inner * std::sin(0.11 * tooth));
  EXPECT_NEAR(VolumeOf(gear), 0.1 * area, 1e-5);
  const Bounds bounds = BoundsOf(gear);
  EXPECT_NEAR(bounds.upper.z, 1, 1e-6);
  EXPECT_NEAR(bounds.lower.z, 0.9, 1e-6);
  EXPECT_LE(bounds.upper.x, 0.995 + 1e-6);
}

TEST(Spd, GearsFillTheirSquareWithoutOverlap) {
  const scene::Scene scene = Read(Gears(4));
  Bounds bounds;
  for (std::size_t i = 1; i < scene.meshes.size(); ++i)
    for (const vec3& p : scene.meshes[i].positions) bounds.Include(p);
  for (int axis = 0; axis < 2; ++axis) {
    EXPECT_GE(bounds.lower[axis], -1);
    EXPECT_LE(bounds.upper[axis], 1);
    EXPECT_NEAR(bounds.upper[axis], 1, 0.01);
  }
  EXPECT_NEAR(bounds.upper.z, 1, 1e-6);
  EXPECT_NEAR(bounds.lower.z, 0.15, 1e-6);  // a quarter less a tenth above the mirror
}

TEST(Spd, TheMountainCoversItsSquare) {
  const scene::Scene scene = Read(Mount(4));
  const scene::Mesh& mountain = scene.meshes.at(0);
  EXPECT_EQ(mountain.triangles.size(), 512u);
  const Bounds bounds = BoundsOf(mountain);
  EXPECT_EQ(bounds.lower.x, -1);
  EXPECT_EQ(bounds.lower.y, -1);
  EXPECT_EQ(bounds.upper.x, 1);
  EXPECT_EQ(bounds.upper.y, 1);

  // Seen from above it is the square, once, and its corners stay at height 0
  double area = 0;
  for (const scene::uvec3& t : mountain.triangles) {
    const dvec3 a(mountain.positions[t.x]), b(mountain.positions[t.y]), c(mountain.positions[t.z]);
    const double z = 0.5 * glm::cross(b - a, c - a).z;
    EXPECT_GT(z, 0);
    area += z;
  }
  EXPECT_NEAR(area, 4, 1e-5);
  for (const vec3& p : mountain.positions) {
    if (std::abs(p.x) == 1 && std::abs(p.y) == 1) {
      EXPECT_EQ(p.z, 0);
    }
  }
}

TEST(Spd, TheMountainIsTheKnownOne) {
  // The height in the middle is the first displacement of all; with size 6, all that is left of the hash's
  // 16 bits is y·2⁹ + x·2
  const scene::Scene scene = Read(Mount(6));
  double middle = 0;
  for (const vec3& p : scene.meshes.at(0).positions)
    if (p.x == 0 && p.y == 0) middle = double(p.z);

  const long seed = 21 + (((32L << 9) + (32L << 1)) & 0xffff);
  long first = (28411 + seed * 8121) % 134456, second = (28411 + first * 8121) % 134456;
  const auto unit = [](long x) { return double(x) * 2 / 134456 - 1; };
  while (unit(first) * unit(first) + unit(second) * unit(second) >= 1) {
    first = (28411 + second * 8121) % 134456;
    second = (28411 + first * 8121) % 134456;
  }
  const double r = unit(first) * unit(first) + unit(second) * unit(second);
  const double deviate = unit(first) * std::sqrt(-2 * std::log(r) / r);
  const double roughness = std::sqrt(std::pow(2, 2 - 2 / 1.2) - 1);
  EXPECT_NEAR(middle, std::numbers::sqrt2 * roughness * deviate, 1e-6);
}

TEST(Spd, TheMountainsBallsTouchOneAnother) {
  const std::vector<scene::Sphere> balls = All<scene::Sphere>(Read(Mount(1)));
  ASSERT_EQ(balls.size(), 4u);
  dvec3 middle(0.0);
  for (std::size_t i = 0; i < 4; ++i) {
    middle += dvec3(balls[i].center) / 4.0;
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_NEAR(glm::length(balls[i].center - balls[k].center), 0.34f, 1e-6f);
  }
  ExpectNear(middle, {-0.8, 0.8, 1}, 1e-6);
}

TEST(Spd, RingsJoinTheMiddlesOfADodecahedronsEdges) {
  const scene::Scene scene = Read(Rings(1));
  const std::vector<scene::Sphere> spheres = All<scene::Sphere>(scene);
  const std::vector<scene::Cone> tubes = All<scene::Cone>(scene);
  ASSERT_EQ(spheres.size(), 30u);
  ASSERT_EQ(tubes.size(), 30u);

  // All corners lie on one sphere, around the body's centre, and come in opposite pairs
  dvec3 center(0.0);
  for (const scene::Sphere& sphere : spheres) center += dvec3(sphere.center) / 30.0;
  ExpectNear(center, {0, 1 / std::sin(std::numbers::pi / 8), 0}, 1e-6);
  for (const scene::Sphere& sphere : spheres) {
    const dvec3 corner = dvec3(sphere.center) - center;
    EXPECT_NEAR(glm::length(corner) + double(sphere.radius) / 1.07412, 1, 1e-6);
    EXPECT_TRUE(std::ranges::any_of(spheres, [&](const scene::Sphere& other) {
      return glm::length(dvec3(other.center) - center + corner) < 1e-6;
    }));
  }

  // Pentagons: five equal sides each, from corner to corner
  const double side = 2 / 1.07412 * std::sin(std::numbers::pi / 5);
  for (const scene::Cone& tube : tubes) {
    EXPECT_NEAR(double(glm::length(tube.top - tube.base)), side, 1e-6);
    EXPECT_EQ(tube.radius, tube.topRadius);
    EXPECT_FALSE(tube.capped);
  }
}

TEST(Spd, RingsWouldJustTouchOnTheUnitSphere) {
  // On the unit sphere the axes of different rings' tubes would come as near as twice the radius
  const std::vector<scene::Cone> tubes = All<scene::Cone>(Read(Rings(1)));
  double least = 1;
  for (std::size_t i = 0; i < 30; ++i) {
    for (std::size_t k = 0; k < i / 5 * 5; ++k) {
      const dvec3 d1 = dvec3(tubes[i].top) - dvec3(tubes[i].base);
      const dvec3 d2 = dvec3(tubes[k].top) - dvec3(tubes[k].base);
      const dvec3 across = glm::cross(d1, d2), apart = dvec3(tubes[k].base) - dvec3(tubes[i].base);
      const double square = glm::dot(across, across);
      if (square < 1e-9) continue;
      const double s = glm::dot(glm::cross(apart, d2), across) / square;
      const double t = glm::dot(glm::cross(apart, d1), across) / square;
      if (s >= 0 && s <= 1 && t >= 0 && t <= 1)
        least = std::min(least, std::abs(glm::dot(apart, across)) / std::sqrt(square));
    }
  }
  EXPECT_NEAR(least * 1.07412, 2 * 0.07412, 2e-5);
}

TEST(Spd, TheWallBehindTheRingsFillsTheView) {
  const scene::Scene scene = Read(Rings(2));
  const Bounds wall = BoundsOf(scene.meshes.at(0));
  const scene::Camera& camera = scene.cameras[0];
  const double distance = wall.lower.y - double(camera.position.y);
  const double half = 0.5 * (wall.upper.x - wall.lower.x);
  EXPECT_NEAR(half / distance, 1.01 * std::tan(std::numbers::pi / 8), 1e-6);
  EXPECT_NEAR(0.5 * (wall.upper.z + wall.lower.z), double(camera.position.z), 1e-6);
}

TEST(Spd, TheTeapotsShape) {
  const scene::Scene scene = Read(Teapot(8));
  const scene::Mesh& teapot = scene.meshes.back();
  const Bounds bounds = BoundsOf(teapot);

  // The spout's tip and the handle's bend; the knob; the body's width; the bottom, which is not flat
  EXPECT_NEAR(bounds.upper.x, 3.434, 0.02);
  EXPECT_NEAR(bounds.lower.x, -3, 1e-6);
  EXPECT_NEAR(bounds.upper.y, 2, 1e-6);
  EXPECT_NEAR(bounds.lower.y, -2, 1e-6);
  EXPECT_NEAR(bounds.upper.z, 3.15, 1e-6);
  EXPECT_NEAR(bounds.lower.z, 0, 1e-6);

  // Its normals have unit length and lie on the side that the corners' order says
  ASSERT_EQ(teapot.normals.size(), teapot.positions.size());
  for (const scene::uvec3& t : teapot.triangles) {
    const dvec3 a(teapot.positions[t.x]), b(teapot.positions[t.y]), c(teapot.positions[t.z]);
    const dvec3 face = glm::normalize(glm::cross(b - a, c - a));
    for (int i = 0; i < 3; ++i) {
      const dvec3 normal(teapot.normals[t[i]]);
      EXPECT_NEAR(glm::length(normal), 1, 1e-5);
      EXPECT_GT(glm::dot(normal, face), 0);
    }
  }
}

TEST(Spd, TheTeapotsBodyIsRoundToAPercent) {
  // The quarters of its waist are the usual cubics with 0.56 in the place of a circle's 0.5523
  const scene::Scene scene = Read(Teapot(4));
  for (const vec3& p : scene.meshes.back().positions) {
    if (std::abs(p.z - 0.9f) > 1e-6f || p.x < -1.99f) continue;  // beside the handle's foot
    const double radius = std::hypot(double(p.x), double(p.y));
    if (radius > 1.9) {
      EXPECT_NEAR(radius, 2, 0.02);
    }
  }
}

TEST(Spd, TetraIsSierpinskis) {
  const scene::Scene scene = Read(Tetra(3));
  const scene::Mesh& mesh = scene.meshes.at(0);
  ASSERT_EQ(mesh.triangles.size(), 64u);

  // Sixteen regular tetrahedra of edge √8/4, facing outwards: a third of a small cube's volume each
  const double edge = std::sqrt(8.0) / 4;
  for (const scene::uvec3& t : mesh.triangles)
    for (const auto& [a, b] : {std::pair(t.x, t.y), std::pair(t.y, t.z), std::pair(t.z, t.x)})
      EXPECT_NEAR(double(glm::length(mesh.positions[a] - mesh.positions[b])), edge, 1e-6);
  EXPECT_NEAR(VolumeOf(mesh), 16 * std::pow(0.5, 3) / 3, 1e-6);
  const Bounds bounds = BoundsOf(mesh);
  ExpectNear(bounds.lower, dvec3(-1.0), 1e-6);
  ExpectNear(bounds.upper, dvec3(1.0), 1e-6);
}

TEST(Spd, TheTreeForks) {
  const scene::Scene scene = Read(Tree(2));
  const std::vector<scene::Cone> branches = All<scene::Cone>(scene);
  const std::vector<scene::Sphere> ends = All<scene::Sphere>(scene);
  ASSERT_EQ(branches.size(), 7u);
  ASSERT_EQ(ends.size(), 7u);

  // In the order of growth: the trunk, its first branch with two twigs, its second with two
  const int parents[7] = {-1, 0, 1, 1, 0, 4, 4};
  const bool second[7] = {false, false, false, true, true, false, true};
  EXPECT_EQ(branches[0].base, vec3(0, 0, 0));
  EXPECT_EQ(branches[0].top, vec3(0, 0, 1));
  EXPECT_FLOAT_EQ(branches[0].radius, 0.15f);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_EQ(ends[i].center, branches[i].top);
    EXPECT_EQ(ends[i].radius, branches[i].topRadius);
    EXPECT_NEAR(branches[i].topRadius, 0.67f * branches[i].radius, 1e-7f);
    if (i == 0) continue;
    const scene::Cone& parent = branches[std::size_t(parents[i])];
    ExpectNear(dvec3(branches[i].base), dvec3(parent.top), 1e-6);
    EXPECT_NEAR(branches[i].radius, parent.topRadius, 1e-7f);

    // Lengths shrink by 0.65 or 0.70, angles are 40° or 25°
    const dvec3 along = dvec3(branches[i].top) - dvec3(branches[i].base);
    const dvec3 before = dvec3(parent.top) - dvec3(parent.base);
    EXPECT_NEAR(glm::length(along) / glm::length(before), second[i] ? 0.70 : 0.65, 1e-6);
    const double angle = std::acos(glm::dot(glm::normalize(along), glm::normalize(before)));
    EXPECT_NEAR(angle * 180 / std::numbers::pi, second[i] ? 25 : 40, 1e-4);
  }

  // The first branch leans by 40° about x, turned by 90°: towards +x
  ExpectNear(
      dvec3(branches[1].top) - dvec3(0, 0, 1),
      0.65 * dvec3(std::sin(40 * std::numbers::pi / 180), 0, std::cos(40 * std::numbers::pi / 180)),
      1e-6);
}

}  // namespace
}  // namespace snell::spd
