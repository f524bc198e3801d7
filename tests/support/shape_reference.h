// SPDX-License-Identifier: Apache-2.0
//
// The analytic shapes once more, in double precision and by other means than the kernel's: signed distances
// from the shapes' profiles, and all crossings of a line by the roots of polynomials. Each crossing tells how
// certain it is, so that single precision may miss those that graze the surface or its rim.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel/types.h"
#include "support/numeric.h"
#include "support/random.h"

namespace snell::test {

using glm::dvec2;
using glm::dvec3;

// Where a line meets the surface.
struct Crossing {
  double t;
  double cosine;  // between the line and the normal, ≥ 0
  double
      margin;  // distance from the nearest rim or edge; negative beyond it, where there is no surface
  double radius;  // of the surface's strongest curvature there
};

struct ReferenceShape {
  unsigned kind;
  double a;
  double b;
  double c;

  explicit ReferenceShape(const kernel::Shape& s)
      : kind(s.kind), a(double(s.a)), b(double(s.b)), c(double(s.c)) {}

  bool Solid() const {
    return kind == kernel::SHAPE_SPHERE || kind == kernel::SHAPE_ELLIPSOID ||
           kind == kernel::SHAPE_BOX || kind == kernel::SHAPE_FRUSTUM ||
           kind == kernel::SHAPE_TORUS;
  }

  // About half the extent.
  double Size() const {
    switch (kind) {
      case kernel::SHAPE_SPHERE: return a;
      case kernel::SHAPE_FRUSTUM:
      case kernel::SHAPE_TUBE: return std::max({a, b, c});
      case kernel::SHAPE_TORUS: return a + b;
    }
    return 1;
  }

  // Distance to the surface, negative inside solids.
  double Distance(dvec3 p) const {
    const double fromAxis = std::hypot(p.x, p.z);
    switch (kind) {
      case kernel::SHAPE_SPHERE: return glm::length(p) - a;
      case kernel::SHAPE_ELLIPSOID: return glm::length(p) - 1;
      case kernel::SHAPE_PLANE: return p.y;
      case kernel::SHAPE_DISK: return std::hypot(std::max({0.0, fromAxis - 1, a - fromAxis}), p.y);
      case kernel::SHAPE_RECTANGLE: {
        const double x = std::max({0.0, -p.x, p.x - 1}), z = std::max({0.0, p.z, -1 - p.z});
        return std::sqrt(x * x + p.y * p.y + z * z);
      }
      case kernel::SHAPE_BOX: {
        const dvec3 q(std::abs(p.x) - 1, std::abs(p.y) - 1, std::abs(p.z) - 1);
        const dvec3 outside(std::max(q.x, 0.0), std::max(q.y, 0.0), std::max(q.z, 0.0));
        return glm::length(outside) + std::min(0.0, std::max({q.x, q.y, q.z}));
      }
      case kernel::SHAPE_TUBE: return ToSegment({fromAxis, p.y}, {a, 0}, {b, c});
      case kernel::SHAPE_FRUSTUM: {
        const dvec2 q(fromAxis, p.y);
        const double distance =
            std::min({ToSegment(q, {a, 0}, {b, c}), ToSegment(q, {0, 0}, {a, 0}),
                      ToSegment(q, {0, c}, {b, c})});
        const bool inside = p.y > 0 && p.y < c && fromAxis < a + (b - a) * p.y / c;
        return inside ? -distance : distance;
      }
    }
    return std::hypot(fromAxis - a, p.y) - b;  // torus
  }

  // The gradient of the distance: the outward unit normal near the surface. That of open shapes, whose
  // distance has a kink there, by their own formulas.
  dvec3 Normal(dvec3 p) const {
    if (kind == kernel::SHAPE_DISK || kind == kernel::SHAPE_RECTANGLE) return {0, 1, 0};
    if (kind == kernel::SHAPE_TUBE) {
      const double fromAxis = std::hypot(p.x, p.z);
      return glm::normalize(dvec3(p.x / fromAxis, (a - b) / c, p.z / fromAxis));
    }
    const double h = 1e-6 * Size();
    dvec3 n(0.0);
    for (int i = 0; i < 3; ++i) {
      dvec3 step(0.0);
      step[i] = h;
      n[i] = Distance(p + step) - Distance(p - step);
    }
    return glm::normalize(n);
  }

  // All crossings of the line o + t·d with the surface and its extension beyond rims, in no order.
  std::vector<Crossing> Crossings(dvec3 o, dvec3 d) const {
    std::vector<Crossing> found;
    const auto add = [&](double t, dvec3 n, double margin, double radius) {
      found.push_back({t, std::abs(glm::dot(glm::normalize(d), n)), margin, radius});
    };
    switch (kind) {
      case kernel::SHAPE_SPHERE:
      case kernel::SHAPE_ELLIPSOID: {
        const double r = kind == kernel::SHAPE_SPHERE ? a : 1;
        for (const double t : Quadratic(Dot(d, d), 2 * Dot(o, d), Dot(o, o) - Real(r) * r))
          add(t, (o + d * t) / r, 1e30, r);
        break;
      }
      case kernel::SHAPE_BOX:
        for (int axis = 0; axis < 3; ++axis) {
          for (const double side : {-1.0, 1.0}) {
            if (d[axis] == 0) continue;
            const double t = (side - o[axis]) / d[axis];
            const dvec3 p = glm::abs(o + d * t);
            dvec3 n(0.0);
            n[axis] = side;
            add(t, n, 1 - std::max(p[(axis + 1) % 3], p[(axis + 2) % 3]), 1e30);
          }
        }
        break;
      case kernel::SHAPE_FRUSTUM:
        for (const double y : {0.0, c}) {
          if (d.y == 0) continue;
          const double t = (y - o.y) / d.y;
          add(t, {0, 1, 0}, (y == 0 ? a : b) - std::hypot(o.x + t * d.x, o.z + t * d.z), 1e30);
        }
        [[fallthrough]];
      case kernel::SHAPE_TUBE: {
        const Real k = (Real(b) - a) / c;
        const Real radius = a + k * o.y, slope = k * d.y;
        const Real qa = Real(d.x) * d.x + Real(d.z) * d.z - slope * slope;
        const Real qb = 2 * (Real(o.x) * d.x + Real(o.z) * d.z - radius * slope);
        const Real qc = Real(o.x) * o.x + Real(o.z) * o.z - radius * radius;
        for (const double t : Quadratic(qa, qb, qc)) {
          const dvec3 p = o + d * t;
          const double r = double(a + k * p.y);
          const dvec3 n = glm::normalize(dvec3(p.x, -double(k) * r, p.z));
          add(t, n, r < 0 ? -1e30 : std::min(p.y, c - p.y), r);
        }
        break;
      }
      case kernel::SHAPE_TORUS: {
        // The quartic along the unit direction from the point nearest to the centre
        const double speed = glm::length(d);
        const dvec3 w = d / speed;
        const double start = glm::dot(o, w);
        const dvec3 q = o - w * start;
        const Real k = Dot(q, q) + Real(a) * a - Real(b) * b;
        const Real four = 4 * Real(a) * a;
        const Real ww = Dot(w, w), qw = Dot(q, w);
        const Real reach = Real(1.01) * (a + b);
        const std::vector<Real> quartic = {
            k * k - four * (Real(q.x) * q.x + Real(q.z) * q.z),
            4 * k * qw - 2 * four * (Real(q.x) * w.x + Real(q.z) * w.z),
            2 * k * ww + 4 * qw * qw - four * (Real(w.x) * w.x + Real(w.z) * w.z), 4 * ww * qw,
            ww * ww};
        for (const Real s : RealRoots(quartic, -reach, reach)) {
          const dvec3 p = q + w * double(s);
          add((double(s) - start) / speed, Normal(p), 1e30, std::clamp(a - b, 0.01 * b, b));
        }
        break;
      }
      default: {  // flat
        if (d.y == 0) break;
        const double t = -o.y / d.y;
        const dvec3 p = o + d * t;
        double margin = 1e30;
        const double fromAxis = std::hypot(p.x, p.z);
        if (kind == kernel::SHAPE_DISK)
          margin = a > 0 ? std::min(1 - fromAxis, fromAxis - a) : 1 - fromAxis;
        if (kind == kernel::SHAPE_RECTANGLE) margin = std::min({p.x, 1 - p.x, -p.z, 1 + p.z});
        add(t, {0, 1, 0}, margin, 1e30);
      }
    }
    return found;
  }

 private:
  using Real = long double;
  static Real Dot(dvec3 u, dvec3 v) { return Real(u.x) * v.x + Real(u.y) * v.y + Real(u.z) * v.z; }

  static double ToSegment(dvec2 p, dvec2 u, dvec2 v) {
    const dvec2 e = v - u;
    const double t = glm::dot(p - u, e) / std::max(glm::dot(e, e), 1e-300);
    return glm::length(p - u - e * std::clamp(t, 0.0, 1.0));
  }

  static std::vector<double> Quadratic(Real qa, Real qb, Real qc) {
    if (qa == 0) return qb == 0 ? std::vector<double>{} : std::vector<double>{double(-qc / qb)};
    const Real discriminant = qb * qb - 4 * qa * qc;
    if (discriminant < 0) return {};
    const Real q = -(qb + std::copysign(std::sqrt(discriminant), qb)) / 2;
    if (q == 0) return {0.0};
    return {double(q / qa), double(qc / q)};
  }
};

}  // namespace snell::test
