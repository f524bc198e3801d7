// SPDX-License-Identifier: Apache-2.0
//
// What pictures hold besides their colours, against closed forms: what the camera sees, what a denoiser is told, and
// that light by its ways and by its sources adds up to the picture.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

#include "render/cryptomatte.h"
#include "render/scene_text.h"

namespace snell::test {
namespace {

const char* const Integrators[] = {"whitted", "path"};

RenderOptions WithAovs(const char* integrator, std::vector<std::string> aovs = {"all"}) {
  RenderOptions options;
  options.integrator = integrator;
  options.aovs = std::move(aovs);
  return options;
}

const PictureLayer& LayerOf(const Picture& picture, const std::string& name) {
  for (const PictureLayer& layer : picture.layers) {
    if (layer.name == name) return layer;
  }
  throw Error("there is no layer " + name);
}

// The channels of a pixel, at most three; the others are 0.
dvec3 ValueAt(const Picture& picture, const std::string& name, int x, int y) {
  const PictureLayer& layer = LayerOf(picture, name);
  const std::size_t channels = layer.channels.size();
  const std::size_t first = std::size_t(y * picture.width + x) * channels;
  dvec3 value(0.0);
  for (std::size_t c = 0; c < std::min<std::size_t>(channels, 3); ++c)
    value[int(c)] = double(layer.values.at(first + c));
  return value;
}

void ExpectNear(dvec3 a, dvec3 b, double tolerance) {
  EXPECT_LE(glm::length(a - b), tolerance) << Toml(a) << " and " << Toml(b);
}

constexpr const char* Ball =
    "[[light]]\ntype = 'directional'\ndirection = [0, 0, -1]\n[[object]]\nshape = 'sphere'\nradius "
    "= 0.8\nmaterial = { type = 'diffuse', color = [0.7, 0.5, 0.1] }\n";

TEST(Aovs, TellWhereTheSurfaceIsAndWhatItIs) {
  const View view;
  for (const char* integrator : Integrators) {
    const Picture picture = PictureOf(view.Exact(3) + Ball, WithAovs(integrator));
    for (int y = 0; y < 32; y += 3) {
      for (int x = 0; x < 32; x += 3) {
        dvec3 p = view.RayOrigin(x + 0.5, y + 0.5);
        const double z2 = 0.64 - p.x * p.x - p.y * p.y;
        if (z2 < 0) {
          EXPECT_FLOAT_EQ(float(ValueAt(picture, "depth", x, y).x), 1e10f);
          ExpectNear(ValueAt(picture, "normal", x, y), dvec3(0.0), 0);
          continue;
        }
        p.z = std::sqrt(z2);
        ExpectNear(ValueAt(picture, "depth", x, y), {10 - p.z, 0, 0}, 1e-5);
        ExpectNear(ValueAt(picture, "position", x, y), p, 1e-5);
        ExpectNear(ValueAt(picture, "normal", x, y), p / 0.8, 1e-5);
        ExpectNear(ValueAt(picture, "albedo", x, y), {0.7, 0.5, 0.1}, 1e-6);
      }
    }
  }
}

TEST(Aovs, UvAreTheSurfaces) {
  const View view = FromAbove(8, 8, 1);
  const Picture picture = PictureOf(
      view.Exact(1) +
          "[[light]]\ntype = 'point'\nposition = [0, 5, 0]\n"
          "[[object]]\nmesh = { positions = [[-1, 0, 1], [1, 0, 1], [1, 0, -1], [-1, 0, -1]], "
          "polygons = [[0, 1, 2, 3]], uvs = [[0, 0], [1, 0], [1, 1], [0, 1]] }\n",
      WithAovs("path", {"uv"}));
  for (int i = 0; i < 8; ++i) {
    const dvec3 p = view.RayOrigin(i + 0.5, 3.5);
    ExpectNear(ValueAt(picture, "uv", i, 3), {(p.x + 1) / 2, (1 - p.z) / 2, 0}, 1e-6);
  }
}

// The contract of Open Image Denoise: a perfect mirror tells what is seen in it, by its own colour.
TEST(Aovs, DenoisersSeeThroughMirrors) {
  const std::string scene =
      "[[light]]\ntype = 'point'\nposition = [3, 0, 3]\n"
      "[[object]]\nshape = 'rectangle'\ncorner = [-5, -5, -5]\nedge_u = [10, 0, 10]\nedge_v = [0, "
      "10, 0]\n"
      "material = { type = 'mirror', color = [0.9, 0.8, 0.5] }\n"
      "[[object]]\nshape = 'plane'\npoint = [7, 0, 0]\nnormal = [-1, 0, 0]\n"
      "material = { type = 'diffuse', color = [0.6, 0.3, 0.2] }\n"
      "[[object]]\nshape = 'plane'\npoint = [-7, 0, 0]\nnormal = [1, 0, 0]\n"
      "material = { type = 'diffuse', color = [0.6, 0.3, 0.2] }\n";
  View view;
  view.height = view.width = 4;
  for (const char* integrator : Integrators) {
    const Picture picture = PictureOf(view.Exact(8) + scene, WithAovs(integrator));
    const dvec3 normal = ValueAt(picture, "normal", 1, 1);
    const double tint = std::string(integrator) == "path" ? 1 : glm::length(normal);
    ExpectNear(ValueAt(picture, "albedo", 1, 1), {0.54, 0.24, 0.1}, 5e-3);
    EXPECT_NEAR(std::abs(normal.x), tint, 1e-5) << integrator;
    // The camera sees the mirror itself
    EXPECT_NEAR(ValueAt(picture, "depth", 1, 1).x, 10 - view.RayOrigin(1.5, 1.5).x, 1e-4);
  }
}

// Glass lets through what it does not reflect: here nothing but the wall can be seen in either way.
TEST(Aovs, DenoisersSeeThroughGlass) {
  const std::string scene =
      "[environment]\ncolor = 0\n[[light]]\ntype = 'point'\nposition = [3, 0, 3]\n"
      "[[object]]\nshape = 'box'\nmin = [-5, -5, -1]\nmax = [5, 5, 1]\nmaterial = { type = "
      "'dielectric', ior = 1.5 }\n"
      "[[object]]\nshape = 'plane'\npoint = [0, 0, -4]\nnormal = [0, 0, 1]\n"
      "material = { type = 'diffuse', color = [0.6, 0.3, 0.2] }\n";
  View view;
  view.height = view.width = 2;
  // All reflections within the slab added: 2F / (1 + F) comes back
  const double through = 1 - 2 * 0.04 / 1.04;
  for (const char* integrator : Integrators) {
    const Picture picture = PictureOf(view.Sampled(1024, 12) + scene, WithAovs(integrator));
    const bool isPath = std::string(integrator) == "path";
    ExpectNear(ValueAt(picture, "albedo", 0, 0), dvec3(0.6, 0.3, 0.2) * through,
               isPath ? 0.02 : 1e-3);
    ExpectNear(ValueAt(picture, "normal", 0, 0), dvec3(0, 0, 1) * through, isPath ? 0.03 : 1e-3);
  }
}

constexpr const char* Room =
    "[environment]\nbottom = 0.2\ntop = [0.1, 0.2, 0.4]\nlight_group = 'sky'\n"
    "[camera]\nposition = [0, 1.5, 5]\nlook_at = [0, 0.7, 0]\n"
    "[[light]]\ntype = 'ambient'\nradiance = 0.1\nlight_group = 'fill'\n"
    "[[light]]\ntype = 'sphere'\ncenter = [2, 3, 2]\nradius = 0.3\nradiance = 30\nlight_group = "
    "'key'\n"
    "[[light]]\ntype = 'point'\nposition = [-3, 2, 2]\nintensity = 6\n"
    "[[object]]\nname = 'floor'\nshape = 'plane'\nmaterial = { type = 'phong', diffuse = 0.6, "
    "reflectivity = 0.2 }\n"
    "[[object]]\nname = 'ball'\nshape = 'sphere'\ncenter = [-0.8, 0.7, 0]\nradius = 0.7\nmaterial "
    "= "
    "'glass'\n"
    "[[object]]\nshape = 'sphere'\ncenter = [0.9, 0.5, 0]\nradius = 0.5\nmaterial = { type = "
    "'diffuse', color = 0.4, emission = [1, 0.6, 0.2], light_group = 'lamp' }\n"
    "[[object]]\nmesh = { positions = [[-0.2, 0, 1], [0.2, 0, 1], [0, 0.5, 1]], triangles = [[0, "
    "1, 2]] }\nmaterial = { type = 'diffuse', color = 0.5, emission = 3, light_group = 'lamp' }\n";

std::string RoomText(int spp) {
  return fmt::format("[render]\nsize = [24, 18]\nspp = {}\nmax_depth = 6\n", spp) + Room;
}

TEST(Aovs, LightAddsUp) {
  for (const char* integrator : Integrators) {
    const Picture picture = PictureOf(RoomText(8), WithAovs(integrator));
    double indirect = 0;
    for (int y = 0; y < 18; ++y) {
      for (int x = 0; x < 24; ++x) {
        const dvec3 whole = PixelAt(picture, x, y);
        const double tolerance = 1e-5 * (glm::length(whole) + 0.01);
        ExpectNear(ValueAt(picture, "direct", x, y) + ValueAt(picture, "indirect", x, y), whole,
                   tolerance);
        dvec3 sum(0.0);
        for (const char* group : {"other", "sky", "fill", "key", "lamp"})
          sum += ValueAt(picture, fmt::format("light_{}", group), x, y);
        ExpectNear(sum, whole, tolerance);
        indirect += ValueAt(picture, "indirect", x, y).x;
      }
    }
    EXPECT_GT(indirect, 1) << integrator;
  }
}

// A group's light is what the picture would be without the other sources.
TEST(Aovs, AGroupIsWhatItsLightsShow) {
  const std::string start =
      "[render]\nsize = [12, 9]\nspp = 256\nmax_depth = 4\n[camera]\nposition = [0, 2, 4]\nlook_at "
      "= [0, 0, 0]\n[[object]]\nshape = 'plane'\nmaterial = { type = 'phong', diffuse = 0.6, "
      "reflectivity = 0.3 }\n[[object]]\nshape = 'box'\nmin = [-1, 0, -1]\nmax = [0, 1, 0]\n";
  const std::string key =
      "[[light]]\ntype = 'sphere'\ncenter = [2, 3, 1]\nradius = 0.3\nradiance = "
      "30\nlight_group = 'key'\n";
  const std::string other = "[[light]]\ntype = 'point'\nposition = [-2, 3, 1]\nintensity = 8\n";
  for (const char* integrator : Integrators) {
    const Picture both = PictureOf(start + key + other, WithAovs(integrator, {"light_groups"}));
    const Picture alone = PictureOf(start + key, WithAovs(integrator, {"depth"}));
    double sumOfBoth = 0, sumAlone = 0;
    for (int y = 0; y < 9; ++y) {
      for (int x = 0; x < 12; ++x) {
        sumOfBoth += ValueAt(both, "light_key", x, y).y;
        sumAlone += PixelAt(alone, x, y).y;
      }
    }
    EXPECT_NEAR(sumOfBoth, sumAlone, 0.02 * sumAlone) << integrator;
  }
}

TEST(Aovs, LeaveThePictureAsItIs) {
  for (const char* integrator : Integrators) {
    RenderOptions plain;
    plain.integrator = integrator;
    EXPECT_EQ(LargestDifference(PictureOf(RoomText(2), plain),
                                PictureOf(RoomText(2), WithAovs(integrator))),
              0)
        << integrator;
  }
}

TEST(Aovs, AreTheSameOnAnyNumberOfThreads) {
  RenderOptions one = WithAovs("path"), all = WithAovs("path");
  one.threads = 1;
  const Picture a = PictureOf(RoomText(4), one), b = PictureOf(RoomText(4), all);
  ASSERT_EQ(a.layers.size(), b.layers.size());
  for (std::size_t i = 0; i < a.layers.size(); ++i) {
    const auto& x = a.layers[i].values;
    const auto& y = b.layers[i].values;
    ASSERT_EQ(x.size(), y.size());
    EXPECT_EQ(std::memcmp(x.data(), y.data(), x.size() * sizeof(float)), 0) << a.layers[i].name;
  }
}

// How much of a pixel an object covers, from the layers of Cryptomatte.
double CoverageOf(const Picture& picture, const std::string& layer, const std::string& name, int x,
                  int y) {
  double coverage = 0;
  for (int i = 0; i < 3; ++i) {
    const auto& values = LayerOf(picture, fmt::format("{}0{}", layer, i)).values;
    const float* const pixel = &values[std::size_t(y * picture.width + x) * 4];
    for (int pair = 0; pair < 4; pair += 2) {
      if (std::bit_cast<std::uint32_t>(pixel[pair]) == render::CryptomatteId(name))
        coverage += double(pixel[pair + 1]);
    }
  }
  return coverage;
}

TEST(Aovs, CryptomatteCoversAsMuchAsTheObjects) {
  View view;
  view.width = view.height = 4;
  // The edge runs through the middle of a column and three quarters of it are left
  const std::string scene =
      "[[light]]\ntype = 'point'\nposition = [0, 0, 5]\n[material.red]\ntype = 'diffuse'\n"
      "[[object]]\nname = 'left'\nshape = 'rectangle'\ncorner = [-9, -9, 0]\nedge_u = [9.125, 0, "
      "0]\nedge_v = [0, 18, 0]\nmaterial = 'red'\n"
      "[[object]]\nname = 'right'\nshape = 'rectangle'\ncorner = [0.125, -9, 0]\nedge_u = [9, 0, "
      "0]\nedge_v = [0, 18, 0]\nmaterial = 'red'\n";
  for (const char* integrator : Integrators) {
    const Picture picture = PictureOf(view.Sampled(256, 2) + scene, WithAovs(integrator));
    EXPECT_EQ(CoverageOf(picture, "crypto_object", "left", 0, 1), 1);
    EXPECT_EQ(CoverageOf(picture, "crypto_object", "right", 3, 1), 1);
    const double left = CoverageOf(picture, "crypto_object", "left", 2, 2);
    const double right = CoverageOf(picture, "crypto_object", "right", 2, 2);
    EXPECT_NEAR(left, 0.25, 0.01);
    EXPECT_DOUBLE_EQ(left + right, 1);
    EXPECT_EQ(CoverageOf(picture, "crypto_material", "red", 2, 2), 1);
  }
}

TEST(Aovs, CountsAndVarianceAreThoseOfTheSamples) {
  View view;
  view.width = view.height = 4;
  // Samples are 0 or 1, so that the mean of their squares is their mean
  const Picture picture = PictureOf(
      view.Sampled(64, 1) +
          "[[object]]\nshape = 'sphere'\nradius = 0.6\nmaterial = { type = 'classic', emission = 1 "
          "}\n",
      WithAovs("whitted"));
  int mixed = 0;
  for (int i = 0; i < 16; ++i) {
    const double mean = PixelAt(picture, i % 4, i / 4).x;
    EXPECT_NEAR(ValueAt(picture, "variance", i % 4, i / 4).x, (mean - mean * mean) / 63, 1e-9);
    EXPECT_EQ(ValueAt(picture, "sample_count", i % 4, i / 4).x, 64);
    if (mean > 0 && mean < 1) ++mixed;
  }
  EXPECT_GT(mixed, 3);
}

TEST(Aovs, UnknownNamesAreRefused) {
  EXPECT_THROW(PictureOf(RoomText(1), WithAovs("path", {"albido"})), Error);
  EXPECT_THROW(SceneOf("[render]\naovs = ['albido']\n"), Error);
  EXPECT_THROW(SceneOf("[environment]\nlight_group = 'a.b'\n"), Error);
}

}  // namespace
}  // namespace snell::test
