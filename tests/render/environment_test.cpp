// SPDX-License-Identifier: Apache-2.0
//
// Light from all around: maps, skies and the discs of directional lights, seen where they are and gathered as closed
// forms have it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "render/scene_text.h"
#include "support/scratch_folder.h"

namespace snell::test {
namespace {

constexpr double Pi = std::numbers::pi;

using Rgb = std::array<int, 3>;

// A map as a flat Radiance HDR file: each channel of a texel is code · 2^scale / 256.
class Map {
 public:
  Map(int width, int height, Rgb all, int scale = 0)
      : width_(width), height_(height), scale_(scale), texels_(std::size_t(width * height), all) {}
  Rgb& At(int x, int y) { return texels_[std::size_t(y * width_ + x)]; }

  std::string File() const {
    std::string file =
        fmt::format("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", height_, width_);
    for (const Rgb& texel : texels_)
      for (const int code : {texel[0], texel[1], texel[2], 128 + scale_}) file += char(code);
    return file;
  }

 private:
  int width_, height_, scale_;
  std::vector<Rgb> texels_;
};

// A scene under a map, rendered.
Picture Under(const Map& map, const std::string& text, const RenderOptions& options = {}) {
  const ScratchFolder folder;
  folder.Write("map.hdr", map.File());
  folder.Write("scene.toml", text);
  LoadOptions load;
  load.warn = [](const Diagnostic& warning) {
    if (warning.message != "the scene has no objects") ADD_FAILURE() << ToString(warning);
  };
  return Render(LoadScene(folder.Path("scene.toml"), load), options).picture;
}

std::string Settings(int size, int spp, int depth) {
  return fmt::format(
      "[render]\nintegrator = 'path'\nfilter = 'box'\nsize = [{}, {}]\nspp = {}\nmax_depth = {}\n",
      size, size, spp, depth);
}

// A white matt floor from close above.
const std::string Floor =
    "[camera]\ntype = 'orthographic'\nposition = [0, 1, 0]\nlook_at = [0, 0, 0]\nup = [0, 0, -1]\n"
    "height = 0.1\n[[object]]\nshape = 'plane'\nmaterial = { type = 'openpbr', base_color = 1, "
    "specular_weight = 0 }\n";

// Four quarters: red behind on the left, green ahead on the left, blue ahead on the right, white behind; the lower
// half is dim.
TEST(EnvironmentMap, IsSeenWhereItBelongs) {
  Map map(64, 32, {0, 0, 0});
  const Rgb colors[4] = {{128, 0, 0}, {0, 128, 0}, {0, 0, 128}, {128, 128, 128}};
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 64; ++x) {
      map.At(x, y) = colors[x / 16];
      if (y >= 16)
        for (int& code : map.At(x, y)) code /= 4;
    }
  }
  const auto seen = [&](const char* target, const char* more = "") {
    return PixelAt(Under(map, fmt::format("[render]\nsize = [1, 1]\nspp = 1\n[camera]\nfov = 1\n"
                                          "position = [0, 0, 0]\nlook_at = {}\n[environment]\n"
                                          "map = 'map.hdr'\n{}",
                                          target, more)),
                   0, 0);
  };
  const auto expect = [&](const dvec3& found, const dvec3& expected) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 2e-3 * expected[c]);
  };
  expect(seen("[-1, 0.5, -1]"), dvec3(0, 0.5, 0));
  expect(seen("[1, 0.5, -1]"), dvec3(0, 0, 0.5));
  expect(seen("[1, 0.5, 1]"), dvec3(0.5));
  expect(seen("[-1, 0.5, 1]"), dvec3(0.5, 0, 0));
  expect(seen("[-1, -0.5, 1]"), dvec3(0.125, 0, 0));
  // What lies ahead on the right turns to ahead on the left
  expect(seen("[-1, 0.5, -1]", "rotation = 90"), dvec3(0, 0, 0.5));
  expect(seen("[-1, 0.5, -1]", "strength = 3"), dvec3(0, 1.5, 0));
  expect(seen("[-1, 0.5, -1]", "visible = false"), dvec3(0));
}

// The irradiance is known: of an even sky, of one whose upper half alone shines, of one small sun.
TEST(EnvironmentMap, LightsAFloorByItsClosedForm) {
  const std::string scene =
      Settings(8, 144, 2) + Floor + "[environment]\nmap = 'map.hdr'\nrotation = 30\n";
  EXPECT_NEAR(MeanOf(Under(Map(16, 8, {64, 64, 64}), scene)), 0.25, 1e-3);

  Map half(256, 128, {0, 0, 0});
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 256; ++x) half.At(x, y) = {128, 128, 128};
  EXPECT_NEAR(MeanOf(Under(half, scene)), 0.5, 0.006);

  // 2^15 from a texel at 45°
  Map sun(64, 32, {0, 0, 0}, 16);
  sun.At(11, 8) = {128, 128, 128};
  double expected = 0;
  constexpr int Steps = 400;
  for (int i = 0; i < Steps; ++i) {
    const double row = 7.5 + 2 * (i + 0.5) / Steps, theta = Pi * row / 32;
    expected += (1 - std::abs(row - 8.5)) * std::cos(theta) * std::sin(theta) * 2 / Steps;
  }
  expected *= 32768 * 2 * Pi * Pi / (64 * 32) / Pi;
  EXPECT_NEAR(MeanOf(Under(sun, scene)), expected, 0.01 * expected);
}

// Light is gathered in two ways, whose weights add up to 1: with any roughness, and beside other lights.
TEST(EnvironmentMap, IsTheSameAlongsideOtherLights) {
  Map map(32, 16, {26, 26, 26}, 6);
  map.At(20, 5) = {255, 200, 100};
  for (const char* material : {"base_color = 0.6, specular_roughness = 0.2",
                               "base_metalness = 1, specular_roughness = 0.4",
                               "base_color = 0.9, transmission_weight = 0.5, thin = true"}) {
    const std::string scene =
        Settings(12, 400, 3) +
        fmt::format(
            "[camera]\nposition = [0, 2, 3]\nlook_at = [0, 0, 0]\nfov = 40\n[[object]]\n"
            "shape = 'plane'\nmaterial = {{ type = 'openpbr', {} }}\n[[object]]\nshape = 'sphere'\n"
            "radius = 0.3\ncenter = [0.2, 0.4, 0.3]\nmaterial = {{ type = 'diffuse', color = 0.5 "
            "}}\n",
            material);
    const std::string surroundings = "[environment]\nmap = 'map.hdr'\n";
    const std::string light = "[[light]]\ntype = 'point'\nposition = [1, 2, 1]\nintensity = 300\n";
    const double alone = MeanOf(Under(map, scene + surroundings));
    const double other = MeanOf(PictureOf(scene + light));
    const double both = MeanOf(Under(map, scene + surroundings + light));
    EXPECT_NEAR(both, alone + other, 0.02 * both) << material;
    EXPECT_GT(alone, 0.1) << material;
  }
}

// The classic integrator lights surfaces by the map's mean.
TEST(EnvironmentMap, IsAmbientLightToTheClassicIntegrator) {
  Map map(16, 8, {0, 0, 0});
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 16; ++x) map.At(x, y) = {128, 64, 0};
  const std::string text =
      "[render]\nsize = [4, 4]\nspp = 1\n[camera]\nposition = [0, 1, 0]\nlook_at = [0, 0, 0]\n"
      "up = [0, 0, -1]\n[environment]\nmap = 'map.hdr'\nstrength = 2\n[[object]]\nshape = 'plane'\n"
      "material = { type = 'phong', ambient = 0.5, diffuse = 0.5 }\n";
  const Picture picture = Under(map, text);
  EXPECT_NEAR(MeanOf(picture, 0), 0.25, 1e-3);
  EXPECT_NEAR(MeanOf(picture, 1), 0.125, 1e-3);
}

// A sun of 10 degrees: its disc's radiance is the irradiance over its solid angle; mirrors show it, too.
TEST(DirectionalLight, HasADisc) {
  const double solidAngle = 2 * Pi * (1 - std::cos(5 * Pi / 180));
  const std::string sun =
      "[[light]]\ntype = 'directional'\ndirection = [0, -1, 0]\nirradiance = 2\nangular_size = "
      "10\n";
  const auto up = [&](double degrees) {
    return Settings(1, 1, 3) +
           fmt::format(
               "[camera]\nposition = [0, 1, 0]\ndirection = [0, {}, {}]\nup = [1, 0, 0]\n"
               "fov = 0.1\n",
               std::cos(degrees * Pi / 180), std::sin(degrees * Pi / 180));
  };
  EXPECT_NEAR(MeanOf(PictureOf(up(4.9) + sun)), 2 / solidAngle, 1e-3);
  EXPECT_EQ(MeanOf(PictureOf(up(5.1) + sun)), 0);
  EXPECT_EQ(MeanOf(PictureOf(up(4.9) + sun + "visible = false\n")), 0);
  const std::string mirror =
      "[[object]]\nshape = 'plane'\nmaterial = { type = 'openpbr', base_color = 1, base_metalness "
      "= "
      "1, specular_roughness = 0 }\n";
  EXPECT_NEAR(MeanOf(PictureOf(up(176) + sun + mirror)), 2 / solidAngle, 0.01 / solidAngle);
}

// Whether samples or chance find the sun, rough metal shows the same.
TEST(DirectionalLight, IsWeightedAgainstChance) {
  for (const double roughness : {0.25, 0.4, 0.7}) {
    const std::string scene =
        Settings(8, 900, 2) +
        fmt::format(
            "[camera]\nposition = [0, 2, 3]\nlook_at = [0, 0, 0]\nfov = 30\n[[object]]\nshape = "
            "'plane'\nmaterial = {{ type = 'openpbr', base_color = 1, base_metalness = 1, "
            "specular_roughness = {} }}\n[[light]]\ntype = 'directional'\ndirection = [0, -2, "
            "3]\nangular_size = 20\n",
            roughness);
    const double sampled = MeanOf(PictureOf(scene + "visible = false\n"));
    EXPECT_NEAR(MeanOf(PictureOf(scene)), sampled, 0.015 * sampled) << roughness;
  }
}

// A floor under a clear sky: with the sun some 120 klx, without it an eighth to a quarter of that.
TEST(Sky, LightsAFloor) {
  const auto floor = [](const char* sun) {
    const Picture picture = PictureOf(
        Settings(6, 256, 2) + Floor +
        fmt::format("[environment]\nsky = {{ elevation = 70, turbidity = 2, sun = {} }}\n", sun));
    return 683 * Pi *
           (0.2126 * MeanOf(picture, 0) + 0.7152 * MeanOf(picture, 1) +
            0.0722 * MeanOf(picture, 2));
  };
  const double sky = floor("false"), both = floor("true");
  EXPECT_GT(both, 95e3);
  EXPECT_LT(both, 130e3);
  EXPECT_GT(sky, 0.1 * both);
  EXPECT_LT(sky, 0.25 * both);
}

}  // namespace
}  // namespace snell::test
