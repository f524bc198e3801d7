// SPDX-License-Identifier: Apache-2.0
//
// Lamps that shine as a photometric file says, against closed forms, by both integrators.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "render/scene_text.h"
#include "support/scratch_folder.h"

namespace snell::test {
namespace {

constexpr double Pi = std::numbers::pi;

class Profiles : public testing::TestWithParam<const char*> {
 protected:
  Profiles() {
    // 1000 cd · cos θ, every degree
    std::string lambert = "IESNA:LM-63-2002\nTILT=NONE\n1 -1 10 91 1 1 2 0 0 0\n1 1 9\n";
    for (int i = 0; i <= 90; ++i) lambert += fmt::format("{} ", i);
    lambert += "\n0\n";
    for (int i = 0; i <= 90; ++i) lambert += fmt::format("{:.6f}\n", 100 * std::cos(i * Pi / 180));
    folder_.Write("lambert.ies", lambert);
    folder_.Write("planes.ies",
                  "IESNA:LM-63-1995\nTILT=NONE\n1 -1 1 2 5 1 2 0 0 0\n1 1 9\n0 180\n0 90 180 270 "
                  "360\n100 100 200 200 300 300 400 400 100 100\n");
  }

  dvec3 Middle(const std::string& scene, int spp = 1, const char* integrator = GetParam()) const {
    folder_.Write("scene.toml",
                  fmt::format("[render]\nintegrator = '{}'\nfilter = 'box'\nsize = [1, 1]\nspp = "
                              "{}\nmax_depth = 2\n{}",
                              integrator, spp, scene));
    return PixelAt(Render(LoadScene(folder_.Path("scene.toml")), {}).picture, 0, 0);
  }

 private:
  ScratchFolder folder_;
};

// From 2 m above, at 1.5 m beside: cos θ at the lamp, and once more on the floor.
TEST_P(Profiles, LightAPlaneAsTheFileSays) {
  for (const char* kind : {"point", "spot"}) {
    const dvec3 seen = Middle(fmt::format(
        "[camera]\nposition = [0, 3, 3]\nlook_at = [1.5, 0, 0]\nfov = 0.001\n[[light]]\ntype = "
        "'{}'\n{}position = [0, 2, 0]\ndirection = [0, -1, 0]\nies = 'lambert.ies'\n[[object]]\n"
        "shape = 'plane'\nmaterial = {{ type = 'diffuse', color = 0.5 }}\n",
        kind, std::string(kind) == "spot" ? "outer_angle = 80\ninner_angle = 70\n" : ""));
    const double cosine = 2 / 2.5;
    EXPECT_NEAR(seen.x, 0.5 / Pi * 1000 / 683 * cosine * cosine / (2.5 * 2.5), 2e-5) << kind;
  }
}

// Seen from the lamp's place, a ball around it is as bright as the lamp's intensity to that side.
double ToThe(const dvec3& middle) { return middle.x * Pi * 100; }

TEST_P(Profiles, TurnWithTheirLamp) {
  const auto towards = [&](const char* side, const char* lamp) {
    return ToThe(Middle(fmt::format(
        "[camera]\nposition = [0, 0, 0]\nlook_at = {}\nup = [1, 1, 1]\nfov = 0.001\n[[light]]\n"
        "type = 'point'\nies = 'planes.ies'\nposition = [0, 0, 0]\n{}[[object]]\nshape = "
        "'sphere'\nradius = 10\nmaterial = {{ type = 'diffuse', color = 1 }}\n",
        side, lamp)));
  };
  // Hanging down
  EXPECT_NEAR(towards("[1, 0, 0]", ""), 100.0 / 683, 1e-5);
  EXPECT_NEAR(towards("[0, 0, -1]", ""), 200.0 / 683, 1e-5);
  EXPECT_NEAR(towards("[-1, 0, 0]", "intensity = 2\n"), 1.5, 1e-5);
  EXPECT_NEAR(towards("[0, 0, 1]", "intensity = 2\ncolor = 0.5\n"), 1, 1e-5);
  EXPECT_NEAR(towards("[1, -0.5, -1]", "intensity = 4\n"), 1.5, 1e-5);
  // Tilted, turned, and upside down
  const std::string tilted = "intensity = 4\ndirection = [1, 0, 0]\n";
  EXPECT_NEAR(towards("[0, 1, 0]", tilted.c_str()), 1, 1e-5);
  EXPECT_NEAR(towards("[0, 0, -1]", tilted.c_str()), 2, 1e-5);
  EXPECT_NEAR(towards("[0, 0, -1]", (tilted + "ies_rotation = 90\n").c_str()), 1, 1e-5);
  EXPECT_NEAR(towards("[0, 0, 1]", "intensity = 4\nlook_at = [0, 5, 0]\n"), 2, 1e-5);
}

// One of many lamps is chosen in proportion to what it may bring; the mean is that of every lamp in turn.
TEST_P(Profiles, AreChosenAmongWithoutBias) {
  const auto row = [&](const char* integrator, int spp) {
    std::string text = "[camera]\nposition = [0, 3, 3]\nlook_at = [0.5, 0, 0]\nfov = 0.001\n";
    for (int i = 0; i < 8; ++i)
      text += fmt::format(
          "[[light]]\ntype = 'point'\nposition = [{}, 1.5, {}]\nies = '{}'\nintensity = "
          "{}\ndirection = [0.5, -1, {}]\n",
          i - 4, i % 3 - 1, i % 2 == 0 ? "lambert.ies" : "planes.ies", i + 1, 0.2 * i - 1);
    return Middle(text + "[[object]]\nshape = 'plane'\nmaterial = { type = 'diffuse' }\n", spp,
                  integrator)
        .x;
  };
  // The classic integrator goes through all of them
  const double all = row("whitted", 1);
  EXPECT_NEAR(row(GetParam(), 4096), all, 0.005 * all);
}

INSTANTIATE_TEST_SUITE_P(By, Profiles, testing::Values("whitted", "path"),
                         [](const auto& integrator) { return std::string(integrator.param); });

}  // namespace
}  // namespace snell::test
