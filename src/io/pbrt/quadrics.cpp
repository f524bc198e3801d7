// SPDX-License-Identifier: Apache-2.0
//
// Spheres, cylinders and disks around the z axis, whole or cut.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "io/pbrt/shapes.h"

namespace snell::io {

using Kind = PbrtQuadric::Kind;

static constexpr double Pi = std::numbers::pi;
static constexpr int Around = 64;  // steps of a whole turn
static constexpr int Along = 32;   // from pole to pole

// Our quadrics stand on the y axis, with the seam of the texture at −z; pbrt's on the z axis, with it at +x.
static const scene::Affine& FromOurs() {
  static const scene::Affine map(glm::dvec4(0, -1, 0, 0), glm::dvec4(0, 0, 1, 0),
                                 glm::dvec4(-1, 0, 0, 0), glm::dvec4(0, 0, 0, 1));
  return map;
}

PbrtQuadric ReadQuadric(Kind kind, const PbrtParameters& parameters) {
  PbrtQuadric q;
  q.kind = kind;
  const float radius = parameters.Number("radius", 1);
  q.radius = double(radius);
  q.phiMax = std::clamp(double(parameters.Number("phimax", 360)), 0.0, 360.0);
  const auto require = [&](bool hasExtent) {
    if (!hasExtent) throw Error("the shape has no extent", parameters.place());
  };
  require(q.radius > 0 && q.phiMax > 0);
  if (kind == Kind::Disk) {
    q.zMin = q.zMax = double(parameters.Number("height", 0));
    q.innerRadius = double(parameters.Number("innerradius", 0));
    require(q.innerRadius >= 0 && q.innerRadius < q.radius);
  } else {
    const float end = kind == Kind::Sphere ? radius : 1;
    q.zMin = double(parameters.Number("zmin", -end));
    q.zMax = double(parameters.Number("zmax", end));
    if (q.zMin > q.zMax) std::swap(q.zMin, q.zMax);
    if (kind == Kind::Sphere) {
      q.zMin = std::clamp(q.zMin, -q.radius, q.radius);
      q.zMax = std::clamp(q.zMax, -q.radius, q.radius);
    }
    require(q.zMin < q.zMax);
  }
  return q;
}

std::optional<PbrtShape> AnalyticQuadric(const PbrtQuadric& q, bool isTurned) {
  if (q.phiMax < 360 || (isTurned && q.kind != Kind::Disk)) return {};
  const float radius = float(q.radius), zMin = float(q.zMin), zMax = float(q.zMax);
  switch (q.kind) {
    case Kind::Sphere:
      if (q.zMin > -q.radius || q.zMax < q.radius) return {};
      return PbrtShape{scene::Sphere{scene::vec3(0.0f), radius}, FromOurs()};
    case Kind::Cylinder:
      return PbrtShape{
          scene::Cone{scene::vec3(0, zMin, 0), scene::vec3(0, zMax, 0), radius, radius, false},
          FromOurs()};
    case Kind::Disk:
      return PbrtShape{scene::Disk{scene::vec3(0, zMin, 0), scene::vec3(0, isTurned ? -1 : 1, 0),
                                   radius, float(q.innerRadius)},
                       FromOurs()};
  }
  return {};
}

namespace {

struct Vertex {
  glm::dvec3 position, normal;
};

// At an angle around the axis and a share of the way along.
Vertex VertexAt(const PbrtQuadric& q, double phi, double v) {
  const glm::dvec3 outward(std::cos(phi), std::sin(phi), 0), up(0, 0, 1);
  if (q.kind == Kind::Disk) {
    const double radius = q.radius + (q.innerRadius - q.radius) * v;
    return {outward * radius + up * q.zMin, up};
  }
  if (q.kind == Kind::Cylinder)
    return {outward * q.radius + up * (q.zMin + (q.zMax - q.zMin) * v), outward};
  const double bottom = std::acos(q.zMin / q.radius), top = std::acos(q.zMax / q.radius);
  const double theta = bottom + (top - bottom) * v;
  const glm::dvec3 normal = outward * std::sin(theta) + up * std::cos(theta);
  return {normal * q.radius, normal};
}

}  // namespace

scene::Mesh QuadricMesh(const PbrtQuadric& q) {
  const int columns = std::max(3, int(std::ceil(Around * q.phiMax / 360)));
  const int rows = q.kind == Kind::Sphere ? Along : 1;
  scene::Mesh mesh;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      const double u = double(column) / columns, v = double(row) / rows;
      const Vertex vertex = VertexAt(q, u * q.phiMax * Pi / 180, v);
      mesh.positions.push_back(scene::vec3(vertex.position));
      mesh.normals.push_back(scene::vec3(vertex.normal));
      mesh.uvs.push_back(scene::vec2(float(u * q.phiMax / 360), float(v)));
    }
  }
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const unsigned a = unsigned(row * (columns + 1) + column), b = a + 1;
      const unsigned c = a + unsigned(columns) + 1, d = c + 1;
      const bool startsAtPole = q.kind == Kind::Sphere && row == 0 && q.zMin <= -q.radius;
      const bool endsAtPole = (q.kind == Kind::Sphere && row == rows - 1 && q.zMax >= q.radius) ||
                              (q.kind == Kind::Disk && q.innerRadius == 0);
      if (!startsAtPole) mesh.triangles.push_back({a, b, d});
      if (!endsAtPole) mesh.triangles.push_back({a, d, c});
    }
  }
  return mesh;
}

void TurnInsideOut(scene::Mesh& mesh) {
  for (scene::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
  for (scene::vec3& n : mesh.normals) n = -n;
}

}  // namespace snell::io
