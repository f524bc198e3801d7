// SPDX-License-Identifier: Apache-2.0
//
// Media whose density comes from a file, against closed forms: all grids here have the density 1 + x/2 + y/4 from −2 to
// 2, which interpolation keeps, and fill a box of half that size. Paths go through by delta tracking, shadows by ratio
// tracking.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nanovdb/util/GridBuilder.h>
#include <nanovdb/util/IO.h>

#include <cmath>
#include <numbers>

#include "render/scene_text.h"
#include "support/numeric.h"
#include "support/scratch_folder.h"

namespace snell::test {
namespace {

constexpr double Pi = std::numbers::pi;

class Grids : public testing::Test {
 protected:
  Grids() {
    nanovdb::GridBuilder<float> builder(0.0f, nanovdb::GridClass::FogVolume);
    auto accessor = builder.getAccessor();
    for (int x = -10; x <= 10; ++x) {
      for (int y = -10; y <= 10; ++y) {
        for (int z = -10; z <= 10; ++z)
          accessor.setValue(nanovdb::Coord(x, y, z), 1 + 0.1f * float(x) + 0.05f * float(y));
      }
    }
    nanovdb::io::writeGrid(folder_.Path("ramp.nvdb"),
                           builder.getHandle(0.2, nanovdb::Vec3d(0), "density"));
  }

  Picture PictureWith(const std::string& scene, int spp, int volumeDepth,
                      const std::string& placed = "") const {
    folder_.Write("scene.toml", fmt::format("[render]\nintegrator = 'path'\nfilter = 'box'\nsize = "
                                            "[16, 16]\nspp = {}\nmax_volume_depth = {}\n{}"
                                            "[[object]]\nshape = 'box'\nmaterial = 'smoke'\n{}",
                                            spp, volumeDepth, scene, placed));
    return Render(LoadScene(folder_.Path("scene.toml")), {}).picture;
  }

 private:
  ScratchFolder folder_;
};

std::string Smoke(const char* medium) {
  return fmt::format("[material.smoke]\ntype = 'volume'\ngrid = 'ramp.nvdb'\n{}\n", medium);
}

// A narrow view against z.
std::string View(double x, double y, const char* more = "") {
  return fmt::format("[camera]\nposition = [{0}, {1}, 5]\nlook_at = [{0}, {1}, 0]\nfov = 0.01\n{2}",
                     x, y, more);
}

const std::string Sky = "[environment]\ncolor = 1\n";
const std::string Dim = Smoke("absorption = [0.1, 0.3, 0.5]\nscattering = [0.1, 0.2, 0.3]");

TEST_F(Grids, AreAsDenseAsTheirFilesSay) {
  const Picture picture = PictureWith(View(0.4, 0.3) + Sky + Dim, 256, 0);
  const double density = 1 + 0.4 / 2 + 0.3 / 4;
  for (int channel = 0; channel < 3; ++channel)
    EXPECT_NEAR(MeanOf(picture, channel), std::exp(-2 * density * (0.2 + 0.3 * channel)), 6e-3);
}

TEST_F(Grids, AreMovedAndStretchedWithTheirObject) {
  const Picture picture = PictureWith(
      View(0.8, 2.1) + Sky + Dim, 256, 0,
      "scale = [2, 2, 3]\nrotate = { axis = 'y', angle = 180 }\ntranslate = [0, 1.5, -7]\n");
  const double density = 1 - 0.4 / 2 + 0.3 / 4;
  for (int channel = 0; channel < 3; ++channel)
    EXPECT_NEAR(MeanOf(picture, channel), std::exp(-6 * density * (0.2 + 0.3 * channel)), 6e-3);
}

TEST_F(Grids, MoveWhileTheShutterIsOpen) {
  const Picture picture =
      PictureWith(View(0.4, 0, "shutter = [0, 1]\n") + Sky + Dim, 256, 0,
                  "motion = [{ time = 0 }, { time = 1, translate = [1, 0, 0] }]");
  for (int channel = 0; channel < 3; ++channel) {
    const double sigma = 0.2 + 0.3 * channel;
    const double expected =
        Integrate(0, 1, 20, [&](double x) { return std::exp(-2 * sigma * (1 + (0.4 - x) / 2)); });
    EXPECT_NEAR(MeanOf(picture, channel), expected, 6e-3);
  }
}

// Below the light's way through a box cut off at the height of 1/2.
TEST_F(Grids, WeakenShadowRaysOnTheWay) {
  const std::string floor =
      "[camera]\nposition = [0, -1.1, 4]\nlook_at = [0, -1.5, 0]\nfov = 0.01\n"
      "[[light]]\ntype = 'point'\nposition = [0, 3, 0]\nintensity = 10\n"
      "[[object]]\nshape = 'plane'\npoint = [0, -1.5, 0]\nmaterial = { type = 'diffuse' }\n";
  const std::string cut = "max = [1, 0.5, 1]\n";
  const Picture open = PictureWith(floor + Smoke("absorption = 0"), 16, 0, cut);
  const Picture dark = PictureWith(floor + Dim, 256, 0, cut);
  const double density = 1.5 + (0.25 - 1) / 8;
  for (int channel = 0; channel < 3; ++channel)
    EXPECT_NEAR(MeanOf(dark, channel) / MeanOf(open, channel),
                std::exp(-density * (0.2 + 0.3 * channel)), 6e-3);
}

// Along a ray of even density, by light that gets in through the top.
TEST_F(Grids, ScatterOnceAsTheIntegralSays) {
  constexpr double G = 0.4, Scattering[3] = {0.4, 0.8, 1.2}, Extinction[3] = {0.5, 1.2, 2};
  const Picture picture = PictureWith(
      View(0.4, 0.3) + "[[light]]\ntype = 'point'\nposition = [0.4, 3, 0]\nintensity = 10\n" +
          Smoke("scattering = [0.4, 0.8, 1.2]\nabsorption = [0.1, 0.4, 0.8]\n"
                "anisotropy = 0.4"),
      1024, 1);
  constexpr double Density = 1 + 0.4 / 2 + 0.3 / 4, Above = 1 + 0.4 / 2 + 0.65 / 4;
  for (int channel = 0; channel < 3; ++channel) {
    const double expected = Integrate(-1, 1, 200, [&](double z) {
      const double r = std::hypot(2.7, z);
      const double d = 1 + G * G - 2 * G * (z / r);
      const double phase = (1 - G * G) / (4 * Pi * d * std::sqrt(d));
      return Scattering[channel] * Density * phase * 10 / (r * r) *
             std::exp(-Extinction[channel] * (Density * (1 - z) + Above * r * 0.7 / 2.7));
    });
    EXPECT_NEAR(MeanOf(picture, channel), expected, 0.012 * expected) << channel;
  }
}

// Also where nothing is absorbed on the way.
TEST_F(Grids, GlowAddsUpAlongTheWay) {
  const std::string glow = "glow = [0.5, 0.2, 0.1]\n";
  constexpr double Depth = 2 * (1 + 0.4 / 2 + 0.3 / 4);
  const Picture clear = PictureWith(View(0.4, 0.3) + Smoke(glow.c_str()), 256, 8);
  EXPECT_NEAR(MeanOf(clear, 0), 0.5 * Depth, 0.01);
  const Picture dark =
      PictureWith(View(0.4, 0.3) + Smoke((glow + "absorption = [0.1, 0.5, 3]").c_str()), 256, 8);
  EXPECT_NEAR(MeanOf(dark, 0), 5 * (1 - std::exp(-0.1 * Depth)), 0.01);
  EXPECT_NEAR(MeanOf(dark, 1), 0.4 * (1 - std::exp(-0.5 * Depth)), 0.004);
  EXPECT_NEAR(MeanOf(dark, 2), 0.1 / 3 * (1 - std::exp(-3 * Depth)), 0.0005);
}

TEST_F(Grids, LoseNothingInTheFurnace) {
  const Picture white =
      PictureWith(View(0.4, 0.3) + Sky + Smoke("scattering = 4\nanisotropy = 0.5"), 256, 10000);
  EXPECT_NEAR(MeanOf(white), 1, 1e-4);
  const Picture colored =
      PictureWith(View(0.4, 0.3) + Sky + Smoke("scattering = [0.3, 2, 6]"), 256, 10000);
  for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(MeanOf(colored, channel), 1, 0.01);
}

}  // namespace
}  // namespace snell::test
