// SPDX-License-Identifier: Apache-2.0
//
// Sources of light that the path tracer chooses among: what glows lights a floor as the area light of the same shape
// does, all sources together bring as much as each alone, and the light tree only changes the noise.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "render/scene_text.h"
#include "support/random.h"
#include "support/statistics.h"

namespace snell::test {
namespace {

std::string Settings(int size, int spp, const char* more = "") {
  return fmt::format(
      "[render]\nintegrator = 'path'\nsize = [{}, {}]\nspp = {}\nmax_depth = 2\n{}\n", size, size,
      spp, more);
}

const std::string Floor =
    "[camera]\nposition = [0, 2, 3]\nlook_at = [0, 0, 0]\nfov = 40\n[[object]]\nshape = 'plane'\n"
    "material = { type = 'diffuse', color = 0.6 }\n";

// Of all pixels: how far they are from those of a picture without noise, as a root of the mean square.
double NoiseOf(const Picture& picture, const Picture& reference) {
  Moments moments;
  for (std::size_t i = 0; i < picture.rgb.size(); ++i)
    moments.Add(double(picture.rgb[i]) - double(reference.rgb[i]));
  return std::sqrt(moments.squares / moments.count);
}

// Flat shapes shine from both of their sides; small ones would hardly be met by chance.
TEST(PathLights, GlowingShapesAreLights) {
  const std::string glow = "material = { type = 'diffuse', color = 0, emission = 500 }\n";
  const std::string light = "[[light]]\nradiance = 500\nvisible = false\n";
  const std::string disk = "center = [0.2, 1.5, -1]\nradius = 0.04\n";
  const std::string corner = "corner = [-0.5, 1, -2]\n";
  const std::pair<std::string, std::string> pairs[] = {
      {light + "type = 'sphere'\ncenter = [0, 1, -2]\nradius = 0.05\n",
       "shape = 'sphere'\ncenter = [0, 1, -2]\nradius = 0.05\n"},
      {light + "type = 'disk'\nnormal = [0, -1, 1]\n" + disk + light +
           "type = 'disk'\nnormal = [0, 1, -1]\n" + disk,
       "shape = 'disk'\nnormal = [0, -1, 1]\n" + disk},
      {light + "type = 'rectangle'\nedge_u = [0.1, 0, 0]\nedge_v = [0, 0.1, 0]\n" + corner + light +
           "type = 'rectangle'\nedge_u = [0, 0.1, 0]\nedge_v = [0.1, 0, 0]\n" + corner,
       "shape = 'rectangle'\nedge_u = [0.1, 0, 0]\nedge_v = [0, 0.1, 0]\n" + corner}};
  for (const auto& [lights, shape] : pairs) {
    const Picture expected = PictureOf(Settings(12, 256) + Floor + lights);
    const std::string text = Floor + "[[object]]\n" + shape + "visible_to_camera = false\n" + glow;
    const Picture glowing = PictureOf(Settings(12, 256) + text);
    const double mean = MeanOf(expected);
    EXPECT_NEAR(MeanOf(glowing), mean, 4e-3 * mean) << shape;
    EXPECT_LT(NoiseOf(glowing, expected), 0.05 * mean) << shape;
  }
}

// A sphere that glows lights its own inside by its own samples, too.
TEST(PathLights, AGlowingSphereHoldsAnEvenLight) {
  const Picture picture = PictureOf(
      Settings(8, 400) +
      "[camera]\nposition = [0.3, 0.1, 0]\nlook_at = [1, 0, 0]\nfov = 80\n[[object]]\nshape = "
      "'sphere'\nmaterial = { type = 'diffuse', color = 0.5, emission = 0.2 }\n");
  // Light that is sent out, and light that is reflected once
  for (const float value : picture.rgb) EXPECT_NEAR(value, 0.3f, 0.015f);
}

// A ring of a picture on a square brings what the square would bring whole, times the picture's mean.
TEST(PathLights, TexturesOfEmissionCount) {
  const std::string square =
      "[[object]]\nshape = 'rectangle'\ncorner = [-0.2, 1, -1]\nedge_u = [0.4, 0, 0]\nedge_v = [0, "
      "0, "
      "-0.4]\nvisible_to_camera = false\nmaterial = { type = 'diffuse', color = 0, emission = ";
  const std::string tiles =
      "[texture.tiles]\ntype = 'checker'\ncolor_a = 0\ncolor_b = 1\nscale = 0.05\n";
  const double whole = MeanOf(PictureOf(Settings(12, 256) + Floor + square + "20 }\n"));
  const double half = MeanOf(PictureOf(Settings(12, 256) + tiles + Floor + square +
                                       "{ texture = 'tiles', tint = 20 } }\n"));
  EXPECT_NEAR(half, whole / 2, 0.01 * whole);
}

// A hall of a thousand lamps: the same picture whichever way a lamp is chosen, by the tree with less noise though with a
// sixteenth of the samples.
TEST(PathLights, TheTreeChangesOnlyTheNoise) {
  Random random(401);
  std::string lamps;
  for (int i = 0; i < 1000; ++i) {
    const double x = random.Uniform(-20, 20), z = random.Uniform(-30, 2);
    const double power = random.LogUniform(0.05, 2);
    lamps += fmt::format("[[light]]\ntype = 'point'\nposition = [{}, {}, {}]\nintensity = {}\n", x,
                         random.Uniform(0.3, 1), z, power);
  }
  RenderOptions classic;
  classic.integrator = "whitted";
  const Picture exact = PictureOf(Settings(16, 16) + Floor + lamps, classic);
  const Picture tree = PictureOf(Settings(16, 64) + Floor + lamps);
  const Picture power = PictureOf(Settings(16, 1024, "light_sampling = 'power'") + Floor + lamps);
  const double mean = MeanOf(exact);
  EXPECT_NEAR(MeanOf(tree), mean, 0.04 * mean);
  EXPECT_NEAR(MeanOf(power), mean, 0.15 * mean);
  EXPECT_LT(NoiseOf(tree, exact), NoiseOf(power, exact));
}

// Suns beside lamps, one of them below the horizon.
TEST(PathLights, DirectionalLightsStandBesideTheTree) {
  const std::string lights =
      "[[light]]\ntype = 'point'\nposition = [1, 2, 0]\nintensity = 4\n"
      "[[light]]\ntype = 'directional'\ndirection = [1, -2, 0]\nirradiance = 0.7\n"
      "[[light]]\ntype = 'directional'\ndirection = [0, 1, 0]\n"
      "[[light]]\ntype = 'directional'\ndirection = [0, -1, 2]\nirradiance = 0.3\n"
      "[[light]]\ntype = 'disk'\ncenter = [0, 2, 0]\nnormal = [0, -1, 0]\nradius = 0.7\n";
  RenderOptions classic;
  classic.integrator = "whitted";
  const double expected = MeanOf(PictureOf(Settings(16, 64) + Floor + lights, classic));
  EXPECT_NEAR(MeanOf(PictureOf(Settings(16, 256) + Floor + lights)), expected, 0.015 * expected);
}

}  // namespace
}  // namespace snell::test
