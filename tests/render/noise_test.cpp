// SPDX-License-Identifier: Apache-2.0
//
// Renders that end by noise: the error that is told is the error there is, against a picture of many more samples; and
// what the limit of indirect light removes is told, too.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "render/scene_text.h"

namespace snell::test {
namespace {

// A room with red and green walls, a lamp under the ceiling and a metal ball.
std::string Room(int size) {
  const std::string pixels = std::to_string(size);
  std::string text = "[render]\nintegrator = 'path'\nmax_depth = 6\nfilter = 'box'\nsize = [" +
                     pixels + ", " + pixels +
                     "]\n[camera]\nposition = [0, 1, 3.6]\nlook_at = [0, 1, 0]\nfov = 38\n"
                     "[[light]]\ntype = 'rectangle'\ncorner = [-0.3, 1.99, -0.3]\nedge_u = "
                     "[0.6, 0, 0]\nedge_v = [0, 0, 0.6]\nradiance = 12\n";
  const auto wall = [&](const char* corner, const char* u, const char* v, const char* color) {
    text += std::string("[[object]]\nshape = 'rectangle'\ncorner = ") + corner + "\nedge_u = " + u +
            "\nedge_v = " + v +
            "\nmaterial = { type = 'openpbr', specular_weight = 0, base_color = " + color + " }\n";
  };
  wall("[-1, 0, 1]", "[2, 0, 0]", "[0, 0, -2]", "0.7");
  wall("[-1, 2, -1]", "[2, 0, 0]", "[0, 0, 2]", "0.7");
  wall("[-1, 0, -1]", "[2, 0, 0]", "[0, 2, 0]", "0.7");
  wall("[-1, 0, 1]", "[0, 0, -2]", "[0, 2, 0]", "[0.6, 0.05, 0.05]");
  wall("[1, 0, -1]", "[0, 0, 2]", "[0, 2, 0]", "[0.1, 0.5, 0.1]");
  return text +
         "[[object]]\nshape = 'sphere'\ncenter = [0.35, 0.4, 0]\nradius = 0.4\n"
         "material = { type = 'openpbr', base_metalness = 1, specular_roughness = 0.3 }\n";
}

// The display's curve as noise counts it.
double Shown(double radiance) { return std::sqrt(std::max(radiance, 0.0) + 0.0015); }

double DisplayRmse(const Picture& a, const Picture& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
    const auto brightness = [i](const Picture& picture) {
      return (double(picture.rgb[i]) + double(picture.rgb[i + 1]) + double(picture.rgb[i + 2])) / 3;
    };
    sum += std::pow(Shown(brightness(a)) - Shown(brightness(b)), 2);
  }
  return std::sqrt(sum / (double(a.rgb.size()) / 3));
}

TEST(Noise, IsWhatIsTold) {
  const std::string room = Room(16);
  RenderOptions reference;
  reference.spp = 4096;
  reference.samples = {{1048576, 1052672}};
  const Picture truth = PictureOf(room, reference);
  for (const float target : {0.05f, 0.03f}) {
    RenderOptions options;
    options.noise = target;
    const RenderResult result = RenderText(room, options);
    EXPECT_EQ(result.report.end, RenderEnd::Noise);
    ASSERT_TRUE(result.report.noise);
    EXPECT_LE(result.report.noise->largest, double(target));
    const double error = DisplayRmse(result.picture, truth);
    RecordProperty("error at " + std::to_string(target), std::to_string(error));
    RecordProperty("told at " + std::to_string(target), std::to_string(result.report.noise->rms));
    // Never better than it is, and not much worse
    EXPECT_LT(error, 1.15 * result.report.noise->rms) << target;
    EXPECT_GT(error, 0.4 * result.report.noise->rms) << target;
  }
}

TEST(ClampIndirect, TellsWhatItRemoves) {
  RenderOptions options;
  options.spp = 64;
  const RenderResult whole = RenderText(Room(16), options);
  options.clampIndirect = 0.05f;
  const RenderResult held = RenderText(Room(16), options);
  const double lost =
      1 - (MeanOf(held.picture, 0) + MeanOf(held.picture, 1) + MeanOf(held.picture, 2)) /
              (MeanOf(whole.picture, 0) + MeanOf(whole.picture, 1) + MeanOf(whole.picture, 2));
  EXPECT_GT(lost, 0.01);
  EXPECT_NEAR(held.report.heldBack, lost, 0.05 * lost);
  EXPECT_EQ(whole.report.heldBack, 0);
  // What comes straight from a lamp is none of its business
  options.maxDepth = 2;
  const RenderResult direct = RenderText(Room(16), options);
  options.clampIndirect = {};
  EXPECT_EQ(LargestDifference(direct.picture, RenderText(Room(16), options).picture), 0);
}

}  // namespace
}  // namespace snell::test
