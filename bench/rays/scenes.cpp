// SPDX-License-Identifier: Apache-2.0
#include "rays/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>

#include "io/mesh/read_mesh.h"
#include "support/random.h"
#include "support/transforms.h"
#include "util/error.h"

namespace snell::bench {

namespace {

using glm::dvec3;
using test::Random;

constexpr double Pi = 3.141592653589793;

// Adds surfaces to a scene's mesh.
class Modeller {
 public:
  explicit Modeller(Scene& scene) : scene_(scene) {}

  // A grid of columns × rows quads over [0, 1]², each two triangles.
  template <class Surface>
  void Grid(int columns, int rows, const Surface& surface) {
    const std::uint32_t base = std::uint32_t(scene_.positions.size());
    for (int row = 0; row <= rows; ++row) {
      for (int column = 0; column <= columns; ++column)
        scene_.positions.push_back(vec3(surface(double(column) / columns, double(row) / rows)));
    }
    const auto at = [&](int column, int row) {
      return base + std::uint32_t(row * (columns + 1) + column);
    };
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        Triangle(at(column, row), at(column + 1, row), at(column + 1, row + 1));
        Triangle(at(column, row), at(column + 1, row + 1), at(column, row + 1));
      }
    }
  }

  void Sphere(dvec3 center, double radius, int columns, int rows) {
    Grid(columns, rows, [&](double u, double v) {
      const double theta = v * Pi, phi = 2 * Pi * u;
      return center + radius * dvec3(std::sin(theta) * std::cos(phi), std::cos(theta),
                                     std::sin(theta) * std::sin(phi));
    });
  }

  // An upright frustum without its disks.
  void Tube(dvec3 foot, double bottom, double top, double height, int columns, int rows = 1) {
    Grid(columns, rows, [&](double u, double v) {
      const double r = bottom + (top - bottom) * v, phi = 2 * Pi * u;
      return foot + dvec3(r * std::cos(phi), height * v, r * std::sin(phi));
    });
  }

  // A box, turned about the vertical through its middle.
  void Box(dvec3 lower, dvec3 upper, double turn = 0) {
    const dvec3 middle = (lower + upper) * 0.5, half = (upper - lower) * 0.5;
    const dvec3 x{std::cos(turn), 0, std::sin(turn)}, y{0, 1, 0},
        z{-std::sin(turn), 0, std::cos(turn)};
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-1.0, 1.0}) {
        Grid(1, 1, [&](double u, double v) {
          dvec3 p;
          p[axis] = side;
          p[(axis + 1) % 3] = 2 * u - 1;
          p[(axis + 2) % 3] = 2 * v - 1;
          p *= half;
          return middle + x * p.x + y * p.y + z * p.z;
        });
      }
    }
  }

 private:
  void Triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    scene_.triangles.push_back({a, b, c, 0});
  }

  Scene& scene_;
};

// Haines' sphereflake, tessellated: nine spheres of a third of the radius on every sphere, four levels deep.
void AddFlake(Modeller& modeller, dvec3 center, dvec3 up, double radius, int depth, int columns) {
  modeller.Sphere(center, radius, columns, columns / 2);
  if (depth == 0) return;
  const dvec3 side =
      glm::normalize(glm::cross(up, std::abs(up.x) > 0.5 ? dvec3(0, 1, 0) : dvec3(1, 0, 0)));
  const dvec3 front = glm::cross(side, up);
  for (int i = 0; i < 9; ++i) {
    const bool equator = i < 6;
    const double phi = equator ? i * Pi / 3 : Pi / 6 + (i - 6) * 2 * Pi / 3;
    const double height = equator ? 0 : std::sqrt(2.0 / 3);
    const double flat = std::sqrt(1 - height * height);
    const dvec3 out = side * (flat * std::cos(phi)) + front * (flat * std::sin(phi)) + up * height;
    AddFlake(modeller, center + out * (radius * 4 / 3), out, radius / 3, depth - 1, columns);
  }
}

Scene Sphereflake(std::uint64_t triangles) {
  Scene scene;
  scene.eye = {2.1f, 1.3f, 1.7f};
  scene.light = {4, 3, 2};
  Modeller modeller(scene);
  int depth = 4;
  while (depth > 0 && triangles / ((std::uint64_t(std::pow(9, depth + 1)) - 1) / 8) < 48) --depth;
  const double spheres = (std::pow(9, depth + 1) - 1) / 8;
  const int columns = 2 * std::max(2, int(std::lround(std::sqrt(double(triangles) / spheres) / 2)));
  AddFlake(modeller, dvec3(0), dvec3(0, 1, 0), 0.5, depth, columns);
  modeller.Grid(1, 1, [](double u, double v) { return dvec3(24 * v - 12, -0.5, 24 * u - 12); });
  return scene;
}

// Hills of eight octaves of waves.
Scene HeightField(std::uint64_t triangles) {
  Scene scene;
  scene.eye = {0, 1.2f, 6};
  scene.target = {0, 0, 1};
  scene.light = {-5, 3, -2};
  struct Wave {
    double x, z, phase, height;
  };
  Random random(301);
  std::vector<Wave> waves;
  for (int octave = 0; octave < 8; ++octave) {
    for (int i = 0; i < 4; ++i) {
      const double angle = 2 * Pi * random.Uniform(), frequency = 0.7 * std::pow(2, octave);
      waves.push_back({frequency * std::cos(angle), frequency * std::sin(angle),
                       2 * Pi * random.Uniform(), 0.22 * std::pow(0.5, octave)});
    }
  }
  const int n = std::max(1, int(std::lround(std::sqrt(double(triangles) / 2))));
  Modeller(scene).Grid(n, n, [&](double u, double v) {
    dvec3 p(12 * v - 6, 0, 12 * u - 6);
    for (const Wave& w : waves) p.y += w.height * std::sin(w.x * p.x + w.z * p.z + w.phase);
    return p;
  });
  return scene;
}

// Curved tubes of four sides that leave a ball in all directions.
Scene Hairball(std::uint64_t triangles) {
  Scene scene;
  scene.eye = {0.3f, 0.9f, 3.2f};
  scene.light = {3, 4, 2};
  constexpr int Segments = 50, Sides = 4;
  Random random(302);
  Modeller modeller(scene);
  modeller.Sphere(dvec3(0), 0.3, 32, 16);
  for (std::uint64_t i = 0; i < std::max<std::uint64_t>(triangles / (2 * Segments * Sides), 1);
       ++i) {
    const dvec3 out = random.Direction(), bend = random.Direction(), curl = random.Direction();
    const double turns = random.Uniform(0.5, 3), length = random.Uniform(0.5, 1);
    const auto center = [&](double t) {
      const double s = t * length;
      return out * (0.3 + 0.8 * s) + bend * (0.35 * s * s) +
             curl * (0.12 * s * std::sin(turns * Pi * s));
    };
    modeller.Grid(Sides, Segments, [&](double u, double v) {
      const dvec3 along = glm::normalize(center(v + 0.01) - center(v - 0.01));
      const dvec3 side = glm::normalize(
          glm::cross(along, std::abs(along.x) > 0.5 ? dvec3(0, 1, 0) : dvec3(1, 0, 0)));
      const double r = 0.0025 * (1.05 - v), phi = 2 * Pi * u;
      return center(v) + (side * std::cos(phi) + glm::cross(along, side) * std::sin(phi)) * r;
    });
  }
  return scene;
}

// A room whose walls are two triangles each, with desks, chairs, shelves of books, lamps, vases, rugs of
// pile and curtains: triangles of all sizes, mostly small.
Scene Interior(std::uint64_t triangles) {
  Scene scene;
  scene.eye = {-4.6f, 1.7f, 3.5f};
  scene.target = {1, 0.9f, -0.6f};
  scene.halfHeight = 0.7f;
  scene.light = {1.3f, 2.6f, 0.4f};
  Random random(303);
  Modeller modeller(scene);
  modeller.Box({-5, -0.1, -4}, {5, 0, 4});
  modeller.Box({-5, 3, -4}, {5, 3.1, 4});
  modeller.Box({-5.1, 0, -4}, {-5, 3, 4});
  modeller.Box({5, 0, -4}, {5.1, 3, 4});
  modeller.Box({-5, 0, -4.1}, {5, 3, -4});
  modeller.Box({-5, 0, 4}, {5, 3, 4.1});

  // Curtains
  const double detail = std::sqrt(double(triangles) / 500000);
  const auto rows = [&](int n) { return std::max(1, int(std::lround(n * detail))); };
  for (const double z : {-2.4, 2.0}) {
    modeller.Grid(rows(220), rows(100), [&](double u, double v) {
      return dvec3(4.85 + 0.06 * std::sin(u * 70) * (0.4 + v), 2.9 - 2.8 * v, z + 1.2 * u);
    });
  }

  // Shelves of books
  const auto shelf = [&](double x, double z, double turn) {
    const double along = std::cos(turn), across = std::sin(turn);
    for (int board = 0; board < 7; ++board) {
      const double y = 0.1 + 0.35 * board;
      modeller.Box({x - 0.8, y, z - 0.15}, {x + 0.8, y + 0.03, z + 0.15}, turn);
      for (double s = -0.75; s < 0.72 && board < 6;) {
        const double width = random.Uniform(0.012, 0.045), height = random.Uniform(0.17, 0.3);
        const dvec3 foot(x + s * along, y + 0.03, z + s * across);
        modeller.Box(foot + dvec3(-width / 2, 0, -0.1), foot + dvec3(width / 2, height, 0.1),
                     turn + random.Uniform(-0.05, 0.05));
        s += width * 1.15;
      }
    }
  };
  for (const double x : {-3.6, -1.8, 0.0, 1.8, 3.6}) shelf(x, -3.8, 0);
  for (const double z : {-2.0, 0.2}) shelf(-4.8, z, Pi / 2);

  // Desks, each with chairs, a lamp, a vase and fruit
  for (int i = 0; i < 10; ++i) {
    const double x = -3 + 2.0 * (i % 4) + random.Uniform(-0.2, 0.2);
    const double z = -2 + 2.0 * (i / 4) + random.Uniform(-0.2, 0.2);
    const double turn = random.Uniform(-0.5, 0.5);
    modeller.Box({x - 0.6, 0.72, z - 0.4}, {x + 0.6, 0.76, z + 0.4}, turn);
    for (const double sx : {-0.5, 0.5}) {
      for (const double sz : {-0.3, 0.3}) {
        const dvec3 foot(x + sx * std::cos(turn) - sz * std::sin(turn), 0,
                         z + sx * std::sin(turn) + sz * std::cos(turn));
        modeller.Tube(foot, 0.02, 0.035, 0.72, 16, rows(8));
      }
    }
    for (const double side : {-0.75, 0.75}) {
      modeller.Box({x - 0.22, 0.42, z + side - 0.2}, {x + 0.22, 0.46, z + side + 0.2}, turn);
      modeller.Box({x - 0.22, 0.46, z + side * 1.25 - 0.02},
                   {x + 0.22, 0.95, z + side * 1.25 + 0.02}, turn);
      for (const double sx : {-0.2, 0.2})
        modeller.Tube({x + sx, 0, z + side}, 0.015, 0.02, 0.42, 12, rows(6));
    }
    modeller.Tube({x - 0.3, 0.76, z}, 0.07, 0.07, 0.02, rows(32));
    modeller.Tube({x - 0.3, 0.76, z}, 0.012, 0.012, 0.4, 12, rows(10));
    modeller.Tube({x - 0.3, 1.1, z}, 0.16, 0.07, 0.2, rows(96), rows(24));
    modeller.Sphere({x - 0.3, 1.17, z}, 0.045, rows(48), rows(24));
    const double swell = random.Uniform(0.4, 0.9);
    modeller.Grid(rows(128), rows(96), [&](double u, double v) {
      const double r = 0.05 + 0.05 * swell * std::sin(v * 5), phi = 2 * Pi * u;
      return dvec3(x + 0.35 + r * std::cos(phi), 0.76 + 0.3 * v, z - 0.15 + r * std::sin(phi));
    });
    for (int fruit = 0; fruit < 6; ++fruit)
      modeller.Sphere({x + random.Uniform(-0.15, 0.25), 0.8, z + random.Uniform(0, 0.3)}, 0.04,
                      rows(32), rows(16));
  }

  // The rest is the pile of a rug
  while (scene.triangles.size() + 6 < triangles) {
    const dvec3 foot(random.Uniform(-2.5, 2.5), 0, random.Uniform(1.6, 3.6));
    const double phase = random.Uniform(0, 6), lean = random.Uniform(0, 0.02);
    modeller.Grid(3, 1, [&](double u, double v) {
      const double r = 0.002 * (1 - 0.8 * v), phi = 2 * Pi * u;
      return foot + dvec3(r * std::cos(phi) + lean * v * std::cos(phase), 0.03 * v,
                          r * std::sin(phi) + lean * v * std::sin(phase));
    });
  }
  return scene;
}

// A hundred by a hundred pebbles, each turned and stretched otherwise.
Scene Instances(std::uint64_t triangles) {
  Scene scene;
  scene.eye = {-9, 9, 52};
  scene.target = {0, -6, 0};
  scene.light = {-40, 30, 10};
  const int n = std::max(2, int(std::lround(std::sqrt(double(triangles) / 2))));
  Modeller(scene).Grid(n, n, [](double u, double v) {
    const double theta = v * Pi, phi = 2 * Pi * u;
    const dvec3 d(std::sin(theta) * std::cos(phi), std::cos(theta),
                  std::sin(theta) * std::sin(phi));
    return d * (0.45 + 0.05 * std::sin(7 * d.x + 3 * d.y) * std::sin(9 * d.z) +
                0.006 * std::sin(60 * d.x) * std::sin(50 * d.y + 40 * d.z));
  });
  Random random(304);
  for (int i = 0; i < 10000; ++i) {
    const dvec3 place(i % 100 - 49.5, random.Uniform(-0.3, 0.3), i / 100 - 49.5);
    glm::dmat4 map = glm::translate(glm::dmat4(1.0), place);
    map = glm::rotate(map, 2 * Pi * random.Uniform(), random.Direction());
    map = glm::scale(
        map, dvec3(random.Uniform(0.7, 1.2), random.Uniform(0.7, 1.2), random.Uniform(0.7, 1.2)));
    scene.placements.push_back(test::ToKernel(map));
  }
  return scene;
}

// Embree reads sixteen bytes at every position, also at the last.
void PadPositions(Scene& scene) { scene.positions.reserve(scene.positions.size() + 1); }

struct Entry {
  std::string_view name;
  std::uint64_t triangles;
  Scene (*make)(std::uint64_t);
};
constexpr Entry Entries[] = {
    {"sphereflake", 1000000, Sphereflake}, {"height field", 2000000, HeightField},
    {"hairball", 1000000, Hairball},       {"interior", 500000, Interior},
    {"instances", 100000, Instances},
};

}  // namespace

const std::vector<std::string_view>& SceneNames() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> list;
    for (const Entry& entry : Entries) list.push_back(entry.name);
    return list;
  }();
  return names;
}

Scene MakeScene(std::string_view name, std::uint64_t triangles) {
  for (const Entry& entry : Entries) {
    if (entry.name != name) continue;
    Scene scene = entry.make(triangles == 0 ? entry.triangles : triangles);
    scene.name = name;
    PadPositions(scene);
    return scene;
  }
  throw Error(
      fmt::format("there is no scene \"{}\"; known are {}", name, fmt::join(SceneNames(), ", ")));
}

Scene ReadScene(const std::string& path) {
  const scene::Mesh mesh = io::ReadMesh(path, {}, {}).front();
  Scene scene;
  scene.name = path.substr(path.find_last_of('/') + 1);
  scene.positions.assign(mesh.positions.begin(), mesh.positions.end());
  for (const auto& t : mesh.triangles) scene.triangles.push_back({t.x, t.y, t.z, 0});
  PadPositions(scene);

  // Look at the middle from the front, a little above
  vec3 lower(kernel::Infinite), upper(-kernel::Infinite);
  for (const vec3& p : scene.positions) {
    for (int axis = 0; axis < 3; ++axis) {
      lower[axis] = std::min(lower[axis], p[axis]);
      upper[axis] = std::max(upper[axis], p[axis]);
    }
  }
  const float size = kernel::Length(upper - lower);
  scene.target = (lower + upper) * 0.5f;
  scene.eye = scene.target + vec3(0.25f, 0.3f, 0.9f) * size;
  scene.light = scene.target + vec3(-0.6f, 0.9f, 0.7f) * size;
  return scene;
}

}  // namespace snell::bench
