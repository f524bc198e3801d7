// SPDX-License-Identifier: Apache-2.0
//
// The limits of paths by kind of bend, against series that end early; and caustics that are blurred or left out.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "render/scene_text.h"

namespace snell::test {
namespace {

std::string Settings(int size, int spp, const std::string& more) {
  return fmt::format(
      "[render]\nintegrator = 'path'\nfilter = 'box'\nsize = [{}, {}]\nspp = {}\n{}\n", size, size,
      spp, more);
}

// L (1 + a + a² + … + a^N)
double Series(double L, double a, int n) {
  double sum = 0;
  for (int i = n; i >= 0; --i) sum = L + a * sum;
  return sum;
}

TEST(PathLimits, MattRoomsAddUpSoManyReflections) {
  for (const int depth : {0, 1, 3}) {
    const Picture picture = PictureOf(
        Settings(12, 400, fmt::format("max_diffuse_depth = {}", depth)) +
        "[camera]\nposition = [0.3, 0.1, 0]\nlook_at = [1, 0, 0]\nfov = 80\n[[object]]\nshape = "
        "'sphere'\nmaterial = { type = 'openpbr', base_color = 0.7, specular_weight = 0, emission "
        "= 0.2 }\n");
    EXPECT_NEAR(MeanOf(picture), Series(0.2, 0.7, depth), 0.004) << depth;
  }
}

TEST(PathLimits, MirrorsThatFaceEachOtherAddUpSoManyReflections) {
  for (const int depth : {0, 1, 3}) {
    const Picture picture = PictureOf(
        Settings(4, 4, fmt::format("max_specular_depth = {}", depth)) +
        "[camera]\nposition = [0, 0, 0]\nlook_at = [0, 0, -1]\nfov = 1\n[[object]]\nshape = "
        "'rectangle'\ncorner = [-1, -1, -1]\nedge_u = [2, 0, 0]\nedge_v = [0, 2, 0]\nmaterial = "
        "'mirror'\n[[object]]\nshape = 'rectangle'\ncorner = [-1, -1, 1]\nedge_u = [2, 0, 0]\n"
        "edge_v = [0, 2, 0]\nmaterial = 'mirror'\n[material.mirror]\ntype = 'openpbr'\n"
        "base_metalness = 1\nbase_color = 0.8\nspecular_roughness = 0\nemission = 0.2\n");
    EXPECT_NEAR(MeanOf(picture), Series(0.2, 0.8, depth), 1e-3) << depth;
  }
}

// Under an even sky, with F reflected at each side of the slab.
TEST(PathLimits, GlassShowsWhatSoFewBendsBring) {
  const double F = 0.04, T = 1 - F;
  const std::pair<const char*, double> limits[] = {
      {"max_transmission_depth = 0", F},
      {"max_transmission_depth = 1", F},
      {"max_transmission_depth = 2", 1},
      {"max_specular_depth = 0", T * T},
      {"max_specular_depth = 1", F + T * T * (1 + F)},
      {"max_transmission_depth = 2\nmax_specular_depth = 0", T * T},
      {"caustics = 'none'", 1}};
  for (const auto& [limit, expected] : limits) {
    const Picture picture = PictureOf(
        Settings(8, 256, limit) +
        "[camera]\nposition = [0, 0, 4]\nlook_at = [0, 0, 0]\nfov = 1\n[environment]\ncolor = 1\n"
        "[[object]]\nshape = 'box'\nmin = [-3, -3, -0.2]\nmax = [3, 3, 0.2]\nmaterial = { type = "
        "'openpbr', transmission_weight = 1, specular_roughness = 0 }\n");
    EXPECT_NEAR(MeanOf(picture), expected, 4e-3) << limit;
  }
}

// A ball under an even sky shows of its lobes those that are allowed.
TEST(PathLimits, LeaveOutTheLobesOfTheirKind) {
  const auto render = [](const char* settings, const char* material) {
    return MeanOf(PictureOf(
        Settings(16, 100, settings) +
        "[camera]\nposition = [0, 0, 10]\nlook_at = [0, 0, 0]\nfov = 9\n[environment]\ncolor = 1\n"
        "[[object]]\nshape = 'sphere'\nmaterial = { type = 'openpbr', specular_roughness = 0.4, " +
        material + " }\n"));
  };
  EXPECT_NEAR(render("max_diffuse_depth = 0", "base_color = 0.8"), render("", "base_color = 0"),
              4e-3);
  EXPECT_NEAR(render("max_specular_depth = 0", "base_metalness = 1"),
              render("",
                     "base_metalness "
                     "= 1, "
                     "base_color = 0, "
                     "specular_weight "
                     "= 0"),
              4e-3);
  EXPECT_NEAR(render("max_diffuse_depth = 0", "base_metalness = 1, base_color = 0.9"),
              render("", "base_metalness = 1, base_color = 0.9"), 4e-3);
  EXPECT_NEAR(render("max_diffuse_depth = 0", "base_color = 0, fuzz_weight = 1, coat_weight = 1"),
              render("max_diffuse_depth = 0\nmax_transmission_depth = 0",
                     "base_color = 0.5, subsurface_weight = 0.3, coat_weight = 1, fuzz_weight = 1"),
              4e-3);
}

// A floor, a ball over it and a small lamp; the picture shows the floor alone.
std::string Ball(int spp, const std::string& settings, const std::string& material,
                 const std::string& lamp = "radius = 0.25\nradiance = 40") {
  return Settings(32, spp, settings) +
         "[camera]\nposition = [0, 5, 0]\nlook_at = [0, 0, 0]\nup = [0, 0, 1]\nfov = 40\n"
         "[[light]]\ntype = 'sphere'\ncenter = [0, 4, 1]\n" +
         lamp +
         "\n"
         "[[object]]\nshape = 'plane'\nmaterial = { type = 'diffuse', color = 0.6 }\n[[object]]\n"
         "shape = 'sphere'\ncenter = [0, 0.8, 0]\nradius = 0.6\nvisible_to_camera = false\n"
         "material = { type = 'openpbr', " +
         material + " }\n";
}

double Deviation(const Picture& a, const Picture& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i)
    sum += std::pow(double(a.rgb[i]) - double(b.rgb[i]), 2);
  return std::sqrt(sum / double(a.rgb.size()));
}

TEST(Caustics, RegularizedTheyAreOfAboutTheSameLightAndLessNoise) {
  const std::pair<std::string, std::string> balls[] = {
      {"transmission_weight = 1, specular_roughness = 0", "radius = 0.08\nradiance = 400"},
      {"base_metalness = 1, base_color = 0.9, specular_roughness = 0.1",
       "radius = 0.25\nradiance = 40"}};
  for (const auto& ball : balls) {
    const std::string &material = ball.first, &lamp = ball.second;
    const auto render = [&](const char* caustics, std::uint32_t first, std::uint32_t count) {
      RenderOptions options;
      options.caustics = caustics;
      options.samples = {{first, first + count}};
      return PictureOf(Ball(64, "", material, lamp), options);
    };
    const Picture full = render("full", 0, 64), truth = render("full", 1048576, 1024);
    const Picture blurred = render("regularized", 0, 64);
    const Picture expected = render("regularized", 1048576, 1024);
    const double noise = Deviation(full, truth), less = Deviation(blurred, expected);
    RecordProperty("noise", std::to_string(noise) + " " + std::to_string(less));
    RecordProperty("mean", std::to_string(MeanOf(truth)) + " " + std::to_string(MeanOf(expected)));
    EXPECT_LT(less, 0.6 * noise) << material;
    EXPECT_NEAR(MeanOf(expected), MeanOf(truth), 0.03 * MeanOf(truth)) << material;
    EXPECT_LT(Deviation(blurred, truth), noise) << material;
  }
}

TEST(Caustics, OthersArePicturesAsBefore) {
  for (const char* material :
       {"specular_weight = 0, base_color = 0.5", "base_metalness = 1, specular_roughness = 0.6"}) {
    const std::string regularized = Ball(8, "caustics = 'regularized'", material);
    EXPECT_EQ(LargestDifference(PictureOf(Ball(8, "", material)), PictureOf(regularized)), 0)
        << material;
  }
}

TEST(Caustics, WithoutThemGlassThrowsAShadow) {
  const Picture none =
      PictureOf(Ball(256, "caustics = 'none'", "transmission_weight = 1, specular_roughness = 0"));
  const Picture black = PictureOf(Ball(256, "", "base_color = 0, specular_weight = 0"));
  EXPECT_NEAR(MeanOf(none), MeanOf(black), 2e-3 * MeanOf(black));
}

}  // namespace
}  // namespace snell::test
