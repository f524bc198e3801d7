// SPDX-License-Identifier: Apache-2.0
//
// The path tracer against closed forms: a furnace in which no lossless surface may be seen, an integrating sphere,
// and light that two ways of sampling, or two integrators, must find alike.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "render/scene_text.h"

namespace snell::test {
namespace {

std::string Settings(int size, int spp, int depth) {
  return fmt::format("[render]\nintegrator = 'path'\nsize = [{}, {}]\nspp = {}\nmax_depth = {}\n",
                     size, size, spp, depth);
}

// Under an even sky a body that absorbs nothing is as bright as the sky behind it.
TEST(Path, NothingIsLostInTheFurnace) {
  const std::pair<const char*, double> materials[] = {
      {"specular_weight = 0", 1e-3},
      {"specular_roughness = 0.3", 4e-3},
      {"specular_roughness = 0.9", 4e-3},
      {"base_metalness = 1, specular_roughness = 0.1", 4e-3},
      {"base_metalness = 1, specular_roughness = 0.7", 4e-3},
      {"base_metalness = 1, specular_roughness = 1", 4e-3},
      {"transmission_weight = 1, specular_roughness = 0", 1e-3},
      {"transmission_weight = 1, specular_roughness = 0.5", 6e-3},
      {"transmission_weight = 1, ior = 1.33, specular_roughness = 0.2", 6e-3},
      {"transmission_weight = 0.5, specular_roughness = 0.4", 6e-3},
      {"transmission_weight = 1, thin = true, specular_roughness = 0", 1e-3},
      {"fuzz_weight = 1, fuzz_roughness = 0.4", 4e-3},
  };
  for (const auto& [material, tolerance] : materials) {
    const Picture picture = PictureOf(fmt::format(
        "{}filter = 'box'\n[camera]\nposition = [0, 0, 10]\nlook_at = [0, 0, 0]\nfov = 9\n"
        "[environment]\ncolor = 0.5\n[[object]]\nshape = 'sphere'\nradius = 0.7\n"
        "material = {{ type = 'openpbr', base_color = 1, {} }}\n",
        Settings(20, 144, 200), material));
    EXPECT_NEAR(MeanOf(picture), 0.5, tolerance) << material;
  }
}

// Inside a matt sphere of albedo a that glows with L, all directions bring L / (1 − a).
TEST(Path, AnIntegratingSphereAddsUpAllReflections) {
  for (const double albedo : {0.3, 0.8}) {
    const Picture picture = PictureOf(fmt::format(
        "{}[camera]\nposition = [0.3, 0.1, 0]\nlook_at = [1, 0, 0]\nfov = 80\n[[object]]\nshape = "
        "'sphere'\nmaterial = {{ type = 'openpbr', base_color = {}, specular_weight = 0, emission "
        "= "
        "0.2 }}\n",
        Settings(12, 400, 300), albedo));
    EXPECT_NEAR(MeanOf(picture), 0.2 / (1 - albedo), 0.004 / (1 - albedo)) << albedo;
  }
}

// A matt floor under one light: what both integrators show, and what a light shows that rays may meet.
TEST(Path, LightsLikeTheClassicIntegrator) {
  const std::string floor =
      "[camera]\nposition = [0, 2, 3]\nlook_at = [0, 0, 0]\nfov = 40\n[[object]]\nshape = 'plane'\n"
      "material = { type = 'diffuse', color = 0.6 }\n";
  const std::string lights[] = {
      "type = 'point'\nposition = [1, 2, 0]\nintensity = 10\n",
      "type = 'spot'\nposition = [0, 3, 0]\nlook_at = [0, 0, 0]\nintensity = 20\nouter_angle = "
      "25\n",
      "type = 'directional'\ndirection = [1, -2, 0]\n",
      "type = 'rectangle'\ncorner = [-0.5, 1, -2]\nedge_u = [1, 0, 0]\nedge_v = [0, 1, "
      "0]\nradiance = 5\nvisible = false\n",
      "type = 'rectangle'\ncorner = [-0.5, 1, -2]\nedge_u = [1, 0, 0]\nedge_v = [0, 1, "
      "0]\nradiance = 5\n",
      "type = 'sphere'\ncenter = [0, 1, -3]\nradius = 0.5\nradiance = 5\n",
      "type = 'disk'\ncenter = [0, 2, 0]\nnormal = [0, -1, 0]\nradius = 0.7\nradiance = 5\n"};
  for (const std::string& light : lights) {
    const std::string text = floor + "[[light]]\n" + light;
    RenderOptions classic;
    classic.integrator = "whitted";
    const std::string settings = Settings(16, 196, 2);
    const double expected = MeanOf(PictureOf(settings + text, classic));
    EXPECT_NEAR(MeanOf(PictureOf(settings + text)), expected, 0.012 * expected) << light;
  }
}

// With many lights each counts as much as alone.
TEST(Path, ManyLightsAddUp) {
  std::string text =
      Settings(16, 400, 2) +
      "[camera]\nposition = [0, 4, 6]\nlook_at = [0, 0, 0]\nfov = 50\n[[object]]\nshape = 'plane'\n"
      "material = { type = 'diffuse', color = 0.6 }\n";
  for (int i = 0; i < 12; ++i)
    text += fmt::format("[[light]]\ntype = 'point'\nposition = [{}, {}, {}]\ncolor = [{}, 1, 2]\n",
                        i % 4 - 2, 1 + i % 3, i / 4 - 1, i + 1);
  RenderOptions classic;
  classic.integrator = "whitted";
  const Picture a = PictureOf(text, classic), b = PictureOf(text);
  for (const int channel : {0, 2})
    EXPECT_NEAR(MeanOf(b, channel), MeanOf(a, channel), 0.01 * MeanOf(a, channel));
}

// A mesh that glows lights a floor as the area light of the same shape does, alone and beside others, and also where
// it is an instance that is turned and stretched.
TEST(Path, GlowingMeshesAreLights) {
  const std::string floor =
      "[camera]\nposition = [0, 2, 3]\nlook_at = [0, 0, 0]\nfov = 40\n[[object]]\nshape = 'plane'\n"
      "material = { type = 'diffuse', color = 0.6 }\n";
  // The mesh shines from both of its sides
  const std::string front =
      "type = 'rectangle'\nradiance = 5\nvisible = false\ncorner = [-0.5, 1, -2]\n";
  const std::string light = "[[light]]\n" + front + "edge_u = [1, 0, 0]\nedge_v = [0, 1, 0]\n" +
                            "[[light]]\n" + front + "edge_u = [0, 1, 0]\nedge_v = [1, 0, 0]\n";
  const std::string quad =
      "{ positions = [[-0.5, 1, -2], [0.5, 1, -2], [0.5, 2, -2], [-0.5, 2, -2]], polygons = [[0, "
      "1, "
      "2, "
      "3]] }\nmaterial = { type = 'diffuse', color = 0, emission = 5 }\n";
  const std::string lamp = "[[light]]\ntype = 'point'\nposition = [1, 2, 0]\nintensity = 4\n";
  const std::string settings = Settings(16, 256, 2);
  const double one = MeanOf(PictureOf(settings + floor + light));
  EXPECT_NEAR(MeanOf(PictureOf(settings + floor + "[[object]]\nmesh = " + quad)), one, 0.012 * one);
  const double both = MeanOf(PictureOf(settings + floor + light + lamp));
  EXPECT_NEAR(MeanOf(PictureOf(settings + floor + lamp + "[[object]]\nmesh = " + quad)), both,
              0.012 * both);
  // Two instances of half the height are one of the whole
  const std::string group = "[[group.half.object]]\nmesh = " + quad;
  const std::string instances =
      group +
      "[[object]]\ngroup = 'half'\nscale = [1, 0.5, 1]\ntranslate = [0, 0.5, 0]\n"
      "[[object]]\ngroup = 'half'\nscale = [1, 0.5, 1]\ntranslate = [0, 1, 0]\n";
  EXPECT_NEAR(MeanOf(PictureOf(settings + floor + instances)), one, 0.012 * one);
}

// Each pixel depends on the scene and its number alone.
TEST(Path, IsTheSameOnAnyNumberOfThreads) {
  const std::string text =
      Settings(24, 4, 8) +
      "[environment]\ncolor = 0.3\n[[light]]\ntype = 'sphere'\ncenter = [2, 3, 2]\nradius = 0.3\n"
      "radiance = 30\n[[object]]\nshape = 'sphere'\nmaterial = 'glass'\n[[object]]\nshape = "
      "'plane'\n"
      "material = { type = 'phong', diffuse = 'checker', reflectivity = 0.2 }\n";
  RenderOptions one, all;
  one.threads = 1;
  EXPECT_EQ(LargestDifference(PictureOf(text, one), PictureOf(text, all)), 0);
}

TEST(Path, DepthOneShowsWhatGlows) {
  const Picture picture = PictureOf(
      Settings(4, 1, 1) +
      "[camera]\nposition = [0, 0, 5]\nlook_at = [0, 0, 0]\nfov = 10\n[environment]\ncolor = 3\n"
      "[[object]]\nshape = 'sphere'\nradius = 2\nmaterial = { type = 'diffuse', emission = 0.25 "
      "}\n");
  for (const float value : picture.rgb) EXPECT_EQ(value, 0.25f);
}

// What errors a picture has differ from pixel to pixel: means over squares of 16 have far less than the quarter
// that independent errors would leave.
TEST(Path, NoiseIsBlue) {
  const auto render = [](int spp) {
    return PictureOf(
        Settings(64, spp, 2) +
        "filter = 'box'\n[camera]\nposition = [0, 3, 0]\nlook_at = [0, 0, 0]\nup = [0, 0, "
        "1]\nfov = 30\n[[light]]\ntype = 'rectangle'\ncorner = [-2, 2, 2]\nedge_u = [3, 0, "
        "0]\nedge_v = [0, 0, 3]\nradiance = 1\n[[object]]\nshape = 'plane'\nmaterial = { "
        "type = 'diffuse', color = 0.5 }\n[[object]]\nshape = 'sphere'\ncenter = [0, 1.2, "
        "0.4]\nradius = 0.3\nvisible_to_camera = false\n");
  };
  const Picture noisy = render(4), reference = render(1024);
  double error = 0, errorOfMeans = 0;
  for (int y = 0; y < 64; y += 4)
    for (int x = 0; x < 64; x += 4) {
      double sum = 0;
      for (int i = 0; i < 16; ++i) {
        const std::size_t at = std::size_t((y + i / 4) * 64 + x + i % 4) * 3;
        const double difference = double(noisy.rgb[at]) - double(reference.rgb[at]);
        error += difference * difference / 16;
        sum += difference / 16;
      }
      errorOfMeans += sum * sum;
    }
  EXPECT_LT(std::sqrt(errorOfMeans / error), 0.15);
}

}  // namespace
}  // namespace snell::test
