// SPDX-License-Identifier: Apache-2.0
//
// "teapot": Newell's teapot of 1975 with Crow's bottom of 1987, Bézier patches cut into triangles, on a
// chequered floor. The patches are symmetric, so that the control points follow from profiles: rim, body, lid
// and bottom turn one around the axis, handle and spout draw a loop along a path. Facts of SPD 3.14's teapot.
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "spd/generators.h"
#include "spd/nff_writer.h"

namespace snell::spd {
namespace {

using Patch = std::array<std::array<dvec3, 4>, 4>;  // [s][t]; t × s points out

struct ProfilePoint {
  double radius;
  double tangent;  // how far the control points beside an axis stand off it
  double z;
};
using Profile = std::array<ProfilePoint, 4>;

constexpr Profile Turned[] = {
    {{{1.4, 0.784, 2.4}, {1.3375, 0.749, 2.53125}, {1.4375, 0.805, 2.53125}, {1.5, 0.84, 2.4}}},
    {{{1.5, 0.84, 2.4}, {1.75, 0.98, 1.875}, {2, 1.12, 1.35}, {2, 1.12, 0.9}}},
    {{{2, 1.12, 0.9}, {2, 1.12, 0.45}, {1.5, 0.84, 0.225}, {1.5, 0.84, 0.15}}},
    {{{0, 0, 3.15}, {0.8, 0.45, 3.15}, {0, 0, 2.85}, {0.2, 0.112, 2.7}}},
    {{{0.2, 0.112, 2.7}, {0.4, 0.224, 2.55}, {1.3, 0.728, 2.55}, {1.3, 0.728, 2.4}}},
};
constexpr Profile Bottom = {{{0, 0, 0}, {1.425, 0.798, 0}, {1.5, 0.84, 0.075}, {1.5, 0.84, 0.15}}};

// A loop across the plane y = 0, through two points of it.
struct Loop {
  double innerX, innerZ;
  double outerX, outerZ;
  double halfWidth;
};
using Path = std::array<Loop, 4>;

constexpr Path Drawn[] = {
    // The handle
    {{{-1.6, 2.025, -1.5, 2.25, 0.3},
      {-2.3, 2.025, -2.5, 2.25, 0.3},
      {-2.7, 2.025, -3, 2.25, 0.3},
      {-2.7, 1.8, -3, 1.8, 0.3}}},
    {{{-2.7, 1.8, -3, 1.8, 0.3},
      {-2.7, 1.575, -3, 1.35, 0.3},
      {-2.5, 1.125, -2.65, 0.9375, 0.3},
      {-2, 0.9, -1.9, 0.6, 0.3}}},
    // The spout
    {{{1.7, 1.425, 1.7, 0.6, 0.66},
      {2.6, 1.425, 3.1, 0.825, 0.66},
      {2.3, 2.1, 2.4, 2.025, 0.25},
      {2.7, 2.4, 3.3, 2.4, 0.25}}},
    {{{2.7, 2.4, 3.3, 2.4, 0.25},
      {2.8, 2.475, 3.525, 2.49375, 0.25},
      {2.9, 2.475, 3.45, 2.5125, 0.15},
      {2.8, 2.4, 3.2, 2.4, 0.15}}},
};

// A quarter of the turned body, from the direction `from` to `to`.
Patch Quarter(const Profile& profile, dvec3 from, dvec3 to) {
  Patch patch;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto [radius, tangent, z] = profile[i];
    const dvec3 height(0, 0, z);
    patch[i] = {height + radius * from, height + radius * from + tangent * to,
                height + radius * to + tangent * from, height + radius * to};
  }
  return patch;
}

// Half of a drawn body, on the side −y, or on +y where the loop goes on.
Patch Half(const Path& path, bool second) {
  Patch patch;
  for (std::size_t i = 0; i < 4; ++i) {
    const dvec3 inner(path[i].innerX, 0, path[i].innerZ), outer(path[i].outerX, 0, path[i].outerZ);
    const dvec3 aside(0, path[i].halfWidth, 0);
    if (second) {
      patch[i] = {outer, outer + aside, inner + aside, inner};
    } else {
      patch[i] = {inner, inner - aside, outer - aside, outer};
    }
  }
  return patch;
}

struct Vertex {
  dvec3 p;
  dvec3 n;
  bool onAxis;
};

Vertex Evaluate(const Patch& patch, double s, double t) {
  // Bernstein's polynomials and their derivatives
  const auto basis = [](double x) {
    const double y = 1 - x;
    return std::array<double, 4>{y * y * y, 3 * x * y * y, 3 * x * x * y, x * x * x};
  };
  const auto slopes = [](double x) {
    const double y = 1 - x;
    return std::array<double, 4>{-3 * y * y, 3 * y * y - 6 * x * y, 6 * x * y - 3 * x * x,
                                 3 * x * x};
  };
  const auto sum = [&](const std::array<double, 4>& inS, const std::array<double, 4>& inT) {
    dvec3 total(0.0);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k < 4; ++k) total += patch[i][k] * (inS[i] * inT[k]);
    return total;
  };

  // On the axis, where a patch ends in a point, the normal is the axis
  const dvec3 p = sum(basis(s), basis(t));
  if (std::abs(p.x) <= 1e-4 && std::abs(p.y) <= 1e-4)
    return {p, dvec3(0, 0, p.z > 1.5 ? 1 : -1), true};
  return {p, glm::normalize(glm::cross(sum(basis(s), slopes(t)), sum(slopes(s), basis(t)))), false};
}

void AddTriangle(NffWriter& writer, const Vertex& a, const Vertex& b, const Vertex& c) {
  if (int(a.onAxis) + int(b.onAxis) + int(c.onAxis) > 1) return;  // it has no area
  const dvec3 corners[3] = {a.p, b.p, c.p};
  const dvec3 normals[3] = {a.n, b.n, c.n};
  writer.AddPatch(corners, normals);
}

void AddSurface(NffWriter& writer, const Patch& patch, int size) {
  for (int i = 0; i < size; ++i) {
    for (int k = 0; k < size; ++k) {
      const double s0 = double(i) / size, s1 = double(i + 1) / size;
      const double t0 = double(k) / size, t1 = double(k + 1) / size;
      const Vertex a = Evaluate(patch, s0, t0), b = Evaluate(patch, s0, t1),
                   c = Evaluate(patch, s1, t1), d = Evaluate(patch, s1, t0);
      AddTriangle(writer, a, b, c);
      AddTriangle(writer, c, d, a);
    }
  }
}

void AddFloor(NffWriter& writer, int size, int parity, double white) {
  writer.SetFill(
      {.color = dvec3(white), .diffuse = 0.5, .mirror = 0.5, .highlightDegrees = 30, .ior = 0});
  const auto at = [&](int i) { return 4 * (2.0 * i / size - 1); };
  for (int i = 0; i < size; ++i)
    for (int k = 0; k < size; ++k)
      if ((i + k) % 2 == parity)
        writer.AddPolygon({{at(i), at(k), 0},
                           {at(i + 1), at(k), 0},
                           {at(i + 1), at(k + 1), 0},
                           {at(i), at(k + 1), 0}});
}

}  // namespace

std::string Teapot(int size) {
  const View view = {{4.86, 7.2, 5.4}, {0, 0, 0}, {0, 0, 1}, 1};
  NffWriter writer("teapot", size, view, {{-3.1, 9.8, 12.1}, {11.3, 5.1, 8.8}});
  AddFloor(writer, size, 1, 1);
  AddFloor(writer, size, 0, 0.5);

  writer.SetFill(
      {.color = {1, 0.5, 0.1}, .diffuse = 0.75, .mirror = 0.25, .highlightDegrees = 37, .ior = 0});
  constexpr dvec3 Axes[5] = {{1, 0, 0}, {0, -1, 0}, {-1, 0, 0}, {0, 1, 0}, {1, 0, 0}};
  for (const Profile& profile : Turned)
    for (int i = 0; i < 4; ++i) AddSurface(writer, Quarter(profile, Axes[i], Axes[i + 1]), size);
  for (const Path& path : Drawn)
    for (const bool second : {false, true}) AddSurface(writer, Half(path, second), size);
  for (int i = 4; i > 0; --i) AddSurface(writer, Quarter(Bottom, Axes[i], Axes[i - 1]), size);
  return writer.Finish();
}

}  // namespace snell::spd
