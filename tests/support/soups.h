// SPDX-License-Identifier: Apache-2.0
//
// Soups of primitives that give builders and traversals trouble, and the rays that do.
#pragma once

#include <array>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "support/soup.h"

namespace snell::test {

using glm::dvec3;

inline dvec3 RandomCorner(Random& random, dvec3 center, double size) {
  return center + random.InCube() * size;
}
inline void AddRandomTriangle(Soup& soup, Random& random, dvec3 center, double size,
                              unsigned mask = kernel::MASK_ALL) {
  const auto corner = [&] { return vec3(RandomCorner(random, center, size)); };
  const vec3 a = corner(), b = corner();
  soup.AddTriangle(a, b, corner(), mask);
}
inline unsigned RandomMask(Random& random) { return 1 + random.Index(kernel::MASK_ALL); }

inline void AddRandomShapes(Soup& soup, Random& random, unsigned count, double reach,
                            bool infinite) {
  for (unsigned i = 0; i < count; ++i) {
    const unsigned kind = ShapeKinds[random.Index(std::size(ShapeKinds))];
    if (kind == kernel::SHAPE_PLANE && !infinite) continue;
    const double scale = random.LogUniform(0.05, 0.5);
    soup.AddShape(RandomShape(random, kind, {MapKinds[random.Index(4)], scale, reach / scale}),
                  RandomMask(random));
  }
}
inline void AddRandomInstances(Soup& soup, Random& random, unsigned count, double reach) {
  const std::array<kernel::Instance, 4> meshes = {soup.AddMesh(Icosphere(1)), soup.AddMesh(Cube()),
                                                  soup.AddMesh(Bipyramid(random, 12, 1, 0.1)),
                                                  soup.AddMesh(TriangleMesh{})};
  for (unsigned i = 0; i < count; ++i) {
    const double scale = random.LogUniform(0.05, 0.5);
    soup.AddInstance(meshes[random.Index(4)],
                     RandomMap(random, MapKinds[random.Index(4)], scale, reach / scale),
                     RandomMask(random));
  }
}

// Fills a soup of about `count` primitives.
struct SoupKind {
  std::string name;
  std::function<void(Soup&, Random&, unsigned count)> fill;
};

inline void PrintTo(const SoupKind& kind, std::ostream* out) { *out << kind.name; }

inline std::vector<SoupKind> SoupKinds() {
  std::vector<SoupKind> kinds;
  const auto add = [&](const char* name, auto fill) { kinds.push_back({name, fill}); };

  add("One", [](Soup& soup, Random& random, unsigned) { AddRandomTriangle(soup, random, {}, 1); });
  add("Scattered", [](Soup& soup, Random& random, unsigned count) {
    for (unsigned i = 0; i < count; ++i)
      AddRandomTriangle(soup, random, random.InCube(), random.LogUniform(0.01, 0.5));
  });
  add("FarFromTheOrigin", [](Soup& soup, Random& random, unsigned count) {
    for (unsigned i = 0; i < count; ++i)
      AddRandomTriangle(soup, random, dvec3(1e4, -2e4, 3e3) + random.InCube(), 0.2);
  });
  add("HugeAndTiny", [](Soup& soup, Random& random, unsigned count) {
    for (unsigned i = 0; i < count; ++i)
      AddRandomTriangle(soup, random, random.InCube() * random.LogUniform(1e-3, 1e3),
                        random.LogUniform(1e-5, 1e5));
  });
  add("Slivers", [](Soup& soup, Random& random, unsigned count) {
    for (unsigned i = 0; i < count; ++i) {
      const dvec3 a = random.InCube(), along = random.Direction();
      const dvec3 side = random.Direction() * random.LogUniform(1e-7, 1e-2);
      soup.AddTriangle(vec3(a), vec3(a + along), vec3(a + along * random.Uniform() + side));
    }
  });
  add("Degenerate", [](Soup& soup, Random& random, unsigned count) {
    // Points, lines, and a few triangles between them
    for (unsigned i = 0; i < count; ++i) {
      const vec3 a(random.InCube()), b(random.InCube());
      switch (random.Index(5)) {
        case 0: soup.AddTriangle(a, a, a); break;
        case 1: soup.AddTriangle(a, b, a); break;
        case 2: soup.AddTriangle(a, b, (a + b) * 0.5f); break;
        default: AddRandomTriangle(soup, random, random.InCube(), 0.3);
      }
    }
  });
  add("Duplicates", [](Soup& soup, Random& random, unsigned count) {
    for (unsigned i = 0; i < count / 10 + 1; ++i) {
      const vec3 a(random.InCube()), b(random.InCube()), c(random.InCube());
      for (int copy = 0; copy < 10; ++copy) {
        // Turned round, too
        copy % 2 == 0 ? soup.AddTriangle(a, b, c) : soup.AddTriangle(a, c, b);
      }
    }
  });
  add("AllEqual", [](Soup& soup, Random& random, unsigned count) {
    const vec3 a(random.InCube()), b(random.InCube()), c(random.InCube());
    for (unsigned i = 0; i < count; ++i) soup.AddTriangle(a, b, c, RandomMask(random));
  });
  add("EqualCentroids", [](Soup& soup, Random& random, unsigned count) {
    // Boxes around the origin
    for (unsigned i = 0; i < count; ++i) {
      const vec3 half(glm::abs(random.InCube()) * random.LogUniform(1e-3, 1));
      soup.AddTriangle(half, -half, vec3(half.x, -half.y, half.z));
    }
  });
  add("GeometricProgression", [](Soup& soup, Random&, unsigned count) {
    // Every split that the heuristic likes parts one from the rest
    for (unsigned i = 0; i < std::min(count, 120u); ++i) {
      const float s = float(std::exp2(20 - 0.5 * i));
      soup.AddTriangle(vec3(s, 0, 0), vec3(s, s, 0), vec3(s, 0, s));
    }
  });
  add("AxisAligned", [](Soup& soup, Random& random, unsigned count) {
    // Rectangles of flat boxes in a few planes, often overlapping
    for (unsigned i = 0; i < count / 2 + 1; ++i) {
      const unsigned axis = random.Index(3);
      const auto place = [&] { return float(int(random.Index(9)) - 4) / 4; };
      vec3 a(place(), place(), place()), u(0.0f), v(0.0f);
      u[int((axis + 1) % 3)] = 0.25f * float(1 + random.Index(3));
      v[int((axis + 2) % 3)] = 0.25f * float(1 + random.Index(3));
      soup.AddTriangle(a, a + u, a + v, RandomMask(random));
      soup.AddTriangle(a + u + v, a + v, a + u, RandomMask(random));
    }
  });
  add("ClosedMeshes", [](Soup& soup, Random& random, unsigned count) {
    const TriangleMesh meshes[] = {Icosphere(1), Cube(), Bipyramid(random, 30, 1, 1e-3), Grid(6)};
    for (unsigned i = 0; i < count / 60 + 1; ++i)
      soup.AddWorldMesh(Placed(meshes[i % 4], RandomMap(random, MapKind::Sheared, 0.3, 3)));
  });
  add("Shapes", [](Soup& soup, Random& random, unsigned count) {
    AddRandomShapes(soup, random, count / 4, 1, true);
  });
  add("Instances", [](Soup& soup, Random& random, unsigned count) {
    AddRandomInstances(soup, random, count / 8, 1);
  });
  add("Everything", [](Soup& soup, Random& random, unsigned count) {
    for (unsigned i = 0; i < count / 2; ++i)
      AddRandomTriangle(soup, random, random.InCube(), 0.2, RandomMask(random));
    AddRandomShapes(soup, random, count / 8, 1, true);
    AddRandomInstances(soup, random, count / 16, 1);
  });
  return kinds;
}

// A ray that starts somewhere and passes near some primitive: from outside and inside, from on the surface
// or far away, along axes, with components that are zero, negative zero, or next to nothing, and with
// directions of many lengths.
inline kernel::Ray RandomRay(Random& random, const Soup& soup) {
  const dvec3 target = soup.PointOnSurface(random);
  dvec3 o, d;
  switch (random.Index(5)) {
    case 0: o = soup.PointOnSurface(random); break;
    case 1: o = random.Direction() * random.LogUniform(1, 1e4); break;
    case 2: o = target + random.Direction() * random.LogUniform(1e-6, 1); break;
    default: o = target + random.Direction() * random.LogUniform(0.1, 10);
  }
  d = target - o;
  if (random.Chance(0.3)) {
    // Along an axis or within a plane of axes
    const int axis = int(random.Index(3));
    if (random.Chance(0.5)) {
      d[axis] = 0;
      o[axis] = target[axis];
    } else {
      d = dvec3(0);
      d[axis] = random.Chance(0.5) ? 1 : -1;
      o = target - d * random.LogUniform(0.1, 10);
    }
  }
  vec3 direction(glm::length(d) > 0 ? glm::normalize(d) : dvec3(0, 0, 1));
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] != 0) continue;
    const float tiny[] = {0.0f, -0.0f, 1e-40f, -1e-40f, 1e-30f, -1e-15f};
    direction[axis] = tiny[random.Index(6)];
  }
  if (random.Chance(0.2)) direction *= float(random.LogUniform(1e-4, 1e4));
  return {vec3(o), direction, 0};
}

}  // namespace snell::test
