// SPDX-License-Identifier: Apache-2.0
//
// The built-in denoiser on a rendered room against the same room with many samples.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "render/scene_text.h"

namespace snell::test {
namespace {

// A room after Cornell's, with a rough metal ball.
std::string Room(int spp) {
  const std::string white = "material = { type = 'diffuse', color = 0.7 }\n";
  const auto wall = [](const char* corner, const char* u, const char* v) {
    return fmt::format("[[object]]\nshape = 'rectangle'\ncorner = {}\nedge_u = {}\nedge_v = {}\n",
                       corner, u, v);
  };
  return fmt::format(
             "[render]\nintegrator = 'path'\nsize = [48, 48]\nspp = {}\nmax_depth = 5\n"
             "[camera]\nposition = [0, 1, 3.9]\nlook_at = [0, 1, 0]\nfov = 36\n"
             "[[light]]\ntype = 'rectangle'\ncorner = [-0.3, 1.99, -0.3]\nedge_u = [0.6, 0, "
             "0]\nedge_v = [0, 0, 0.6]\nradiance = 10\nvisible = false\n",
             spp) +
         wall("[-1, 0, 1]", "[2, 0, 0]", "[0, 0, -2]") + white +
         wall("[-1, 2, 1]", "[2, 0, 0]", "[0, 0, -2]") + white +
         wall("[-1, 0, -1]", "[2, 0, 0]", "[0, 2, 0]") +
         "material = { type = 'diffuse', color = 'checker' }\n" +
         wall("[-1, 0, -1]", "[0, 0, 2]", "[0, 2, 0]") +
         "material = { type = 'diffuse', color = [0.6, 0.1, 0.1] }\n" +
         wall("[1, 0, -1]", "[0, 0, 2]", "[0, 2, 0]") +
         "material = { type = 'diffuse', color = [0.1, 0.5, 0.1] }\n"
         "[[object]]\nshape = 'sphere'\ncenter = [-0.4, 0.4, 0]\nradius = 0.4\nmaterial = { type = "
         "'openpbr', base_color = 0.8, base_metalness = 1, specular_roughness = 0.4 }\n"
         "[[object]]\nshape = 'box'\nmin = [0.15, 0, -0.3]\nmax = [0.7, 0.9, 0.2]\n" +
         white;
}

TEST(Denoising, TakesMostOfTheErrorFromARoom) {
  RenderOptions options;
  options.denoiser = Denoiser::Nfor;
  const RenderResult noisy = RenderText(Room(16), options);
  const Picture truth = PictureOf(Room(1024));
  const PictureDifference before = ComparePictures(truth, noisy.picture);
  const PictureDifference after = ComparePictures(truth, *noisy.denoised);
  EXPECT_GT(before.relMse, 0.005);
  EXPECT_LT(after.relMse, before.relMse / 3);
  EXPECT_NEAR(MeanOf(*noisy.denoised), MeanOf(truth), 0.02 * MeanOf(truth));
  EXPECT_EQ(noisy.report.denoiser, "nfor");
}

// A render that is kept for a denoiser is the render.
TEST(Denoising, LeavesTheNoisyPictureAsItIs) {
  RenderOptions options;
  options.denoiser = Denoiser::Nfor;
  EXPECT_EQ(LargestDifference(RenderText(Room(2), options).picture, PictureOf(Room(2))), 0);
}

TEST(Denoising, TakesAnyNumberOfSamplesAndEitherIntegrator) {
  for (const char* integrator : {"whitted", "path"}) {
    for (const int spp : {1, 3}) {
      RenderOptions options;
      options.denoiser = Denoiser::Nfor;
      options.integrator = integrator;
      const Picture denoised = *RenderText(Room(spp), options).denoised;
      for (const float value : denoised.rgb) ASSERT_TRUE(std::isfinite(value) && value >= 0);
      EXPECT_GT(MeanOf(denoised), 0.01) << integrator;
    }
  }
}

}  // namespace
}  // namespace snell::test
