// SPDX-License-Identifier: Apache-2.0
//
// Triangles of polygons: they cover the polygon's area, once, and keep its side.
#include "io/mesh/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <random>

namespace snell::io {
namespace {

using glm::dvec3;
using scene::uvec3;
using scene::vec3;

// Areas along the polygon's normal: positive for triangles that lie on its side.
double SignedArea(std::span<const vec3> corners, const uvec3& t, const vec3& normal) {
  const dvec3 a(corners[t.x]), b(corners[t.y]), c(corners[t.z]);
  return 0.5 * glm::dot(glm::cross(b - a, c - a), dvec3(normal));
}

double PolygonArea(std::span<const vec3> corners, const vec3& normal) {
  double area = 0;
  for (std::uint32_t i = 2; i < corners.size(); ++i)
    area += SignedArea(corners, uvec3(0, i - 1, i), normal);
  return area;
}

// Checks what must hold for every simple polygon.
void ExpectCovers(const std::vector<vec3>& corners, std::size_t triangleCount) {
  const PolygonTriangles result = TriangulatePolygon(corners);
  EXPECT_TRUE(result.simple);
  EXPECT_EQ(result.triangles.size(), triangleCount);
  double sum = 0;
  for (const uvec3& triangle : result.triangles) {
    const double area = SignedArea(corners, triangle, result.normal);
    EXPECT_GT(area, 0);
    sum += area;
  }
  const double area = PolygonArea(corners, result.normal);
  EXPECT_NEAR(sum, area, 1e-6 * area);
}

// A star-shaped outline around the origin, in a plane with a given normal.
std::vector<vec3> Star(int count, vec3 normal, const std::function<float(int)>& radius) {
  const vec3 n = glm::normalize(normal);
  const vec3 u =
      glm::normalize(glm::cross(n, std::abs(n.x) < 0.5f ? vec3(1, 0, 0) : vec3(0, 1, 0)));
  const vec3 v = glm::cross(n, u);
  std::vector<vec3> corners;
  for (int i = 0; i < count; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * float(i) / float(count);
    corners.push_back(radius(i) * (std::cos(angle) * u + std::sin(angle) * v));
  }
  return corners;
}

TEST(Polygon, ConvexOnesBecomeAFan) {
  const std::vector<vec3> square = {{0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}};
  const PolygonTriangles result = TriangulatePolygon(square);
  EXPECT_EQ(result.normal, vec3(0, 0, 1));
  EXPECT_EQ(result.triangles, (std::vector<uvec3>{{0, 1, 2}, {0, 2, 3}}));

  const std::vector<vec3> disk = Star(9, vec3(1, -2, 3), [](int) { return 2.0f; });
  const std::vector<uvec3> fan = TriangulatePolygon(disk).triangles;
  ASSERT_EQ(fan.size(), 7u);
  for (std::uint32_t i = 0; i < 7; ++i) EXPECT_EQ(fan[i], uvec3(0, i + 1, i + 2));
}

TEST(Polygon, TheNormalFollowsTheOrderOfTheCorners) {
  const std::vector<vec3> triangle = {{0, 0, 0}, {0, 0, 3}, {3, 0, 0}};
  EXPECT_EQ(TriangulatePolygon(triangle).normal, vec3(0, 1, 0));
  const std::vector<vec3> reversed(triangle.rbegin(), triangle.rend());
  EXPECT_EQ(TriangulatePolygon(reversed).normal, vec3(0, -1, 0));
}

TEST(Polygon, ConcaveOnesKeepTheirShape) {
  ExpectCovers({{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}}, 4);  // an L
  ExpectCovers({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}},
               2);  // a dart: no fan around corner 0 …
  ExpectCovers({{4, 4, 0}, {2, 1, 0}, {0, 0, 0}, {4, 0, 0}}, 2);  // … however it is listed
  ExpectCovers({{2, 1, 0}, {0, 0, 0}, {4, 0, 0}, {4, 4, 0}}, 2);
}

TEST(Polygon, GearsInAnyPlane) {
  const auto tooth = [](int i) { return i % 4 < 2 ? 1.0f : 0.9f; };
  for (const vec3 normal :
       {vec3(0, 0, 1), vec3(0, 0, -1), vec3(1, 0, 0), vec3(0, -1, 0.1f), vec3(-1, 2, -3)})
    ExpectCovers(Star(144, normal, tooth), 142);
}

TEST(Polygon, RandomStars) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> radius(0.05f, 1.0f), direction(-1, 1);
  for (int i = 0; i < 300; ++i) {
    const vec3 normal(direction(random), direction(random), direction(random));
    const int count = 4 + i % 60;
    ExpectCovers(Star(count, normal, [&](int) { return radius(random); }), std::size_t(count) - 2);
  }
}

TEST(Polygon, CornersOnStraightEdgesStayConnected) {
  // Every corner is used, so that no neighbour's vertex lies on an edge without being its end
  const std::vector<vec3> corners = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0},
                                     {2, 2, 0}, {1, 2, 0}, {0, 2, 0}};
  ExpectCovers(corners, 5);
}

TEST(Polygon, RepeatedCornersDoNoHarm) {
  const std::vector<vec3> corners = {{0, 0, 0}, {0, 0, 0}, {2, 0, 0},
                                     {2, 2, 0}, {2, 2, 0}, {0, 2, 0}};
  const PolygonTriangles result = TriangulatePolygon(corners);
  double sum = 0;
  for (const uvec3& triangle : result.triangles)
    sum += SignedArea(corners, triangle, result.normal);
  EXPECT_NEAR(sum, 4, 1e-12);
  EXPECT_TRUE(result.simple);
}

TEST(Polygon, AHoleJoinedByACut) {
  const std::vector<vec3> frame = {{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}, {0, 0, 0},
                                   {2, 2, 0}, {2, 4, 0}, {4, 4, 0}, {4, 2, 0}, {2, 2, 0}};
  const PolygonTriangles result = TriangulatePolygon(frame);
  EXPECT_TRUE(result.simple);
  double sum = 0;
  for (const uvec3& triangle : result.triangles) {
    const double area = SignedArea(frame, triangle, result.normal);
    EXPECT_GE(area, 0);
    sum += area;
    const dvec3 middle =
        (dvec3(frame[triangle.x]) + dvec3(frame[triangle.y]) + dvec3(frame[triangle.z])) / 3.0;
    EXPECT_FALSE(middle.x > 2 && middle.x < 4 && middle.y > 2 && middle.y < 4);
  }
  EXPECT_NEAR(sum, 32, 1e-12);
}

TEST(Polygon, WithoutAreaThereAreNoTriangles) {
  EXPECT_TRUE(TriangulatePolygon(std::vector<vec3>{}).triangles.empty());
  EXPECT_TRUE(TriangulatePolygon(std::vector<vec3>{{0, 0, 0}, {1, 0, 0}}).triangles.empty());
  EXPECT_TRUE(
      TriangulatePolygon(std::vector<vec3>{{1, 1, 1}, {2, 2, 2}, {3, 3, 3}}).triangles.empty());
  EXPECT_TRUE(TriangulatePolygon(std::vector<vec3>(5, vec3(1, 2, 3))).triangles.empty());
}

TEST(Polygon, CrossingOutlinesGiveSomeTriangles) {
  // The halves of a bow tie turn opposite ways
  const std::vector<vec3> bow = {{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 3, 0}};
  const PolygonTriangles result = TriangulatePolygon(bow);
  EXPECT_FALSE(result.simple);
  EXPECT_EQ(result.triangles.size(), 2u);

  // Whatever is thrown at it, there are at most n − 2 triangles, of existing corners
  std::mt19937 random(11);
  for (int i = 0; i < 500; ++i) {
    std::vector<vec3> corners(3 + random() % 20);
    for (vec3& corner : corners)
      corner = vec3(float(random() % 5), float(random() % 5), float(random() % 2));
    const PolygonTriangles any = TriangulatePolygon(corners);
    EXPECT_LE(any.triangles.size(), corners.size() - 2);
    for (const uvec3& triangle : any.triangles)
      EXPECT_LT(std::max({triangle.x, triangle.y, triangle.z}), corners.size());
  }
}

TEST(Polygon, PartsThatStandUprightAreKept) {
  // A square of the floor whose outline also climbs a wall: the wall's part has no area seen from above
  const std::vector<vec3> corners = {vec3(-1, 0, 1), vec3(1, 0, 1), vec3(1, 0, -1), vec3(-1, 0, -1),
                                     vec3(0, 1, -1)};
  const PolygonTriangles result = TriangulatePolygon(corners);
  EXPECT_EQ(result.triangles.size(), 3u);

  // Straight corners of a flat one still take no triangle
  const std::vector<vec3> straight = {vec3(0, 0, 0), vec3(1, 0, 0), vec3(2, 0, 0), vec3(2, 2, 0),
                                      vec3(0, 2, 0)};
  EXPECT_EQ(TriangulatePolygon(straight).triangles.size(), 3u);
}

TEST(Polygon, ThinCombsAreQuick) {
  // Half of the corners are reflex: the worst case
  std::vector<vec3> comb;
  const int teeth = 2500;
  for (int i = 0; i < teeth; ++i) {
    comb.push_back(vec3(2 * i, 0, 0));
    comb.push_back(vec3(2 * i + 1, 100, 0));
  }
  for (int i = teeth; i-- > 0;) {
    comb.push_back(vec3(2 * i + 1, 101, 0));
    comb.push_back(vec3(2 * i, 1, 0));
  }
  ExpectCovers(comb, comb.size() - 2);
}

}  // namespace
}  // namespace snell::io
