// SPDX-License-Identifier: Apache-2.0
//
// What clear bodies keep of the light: nothing (a white furnace), or what Beer and Lambert's law says; what
// cannot be seen because its index of refraction is that of its surroundings; and how deep rays go.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "render/optics.h"
#include "render/scene_text.h"

namespace snell::test {
namespace {

const std::string White = "[environment]\ncolor = 1\n";

View Facing(int size, double extent) {
  View view{size, size};
  view.extent = extent;
  return view;
}

TEST(Energy, NothingIsLostInTheFurnace) {
  // Under a white sky whatever absorbs nothing is as white, from all sides. (In bodies that overlap some
  // light goes round for very long.)
  const std::string glass = "material = { type = 'dielectric', ior = 1.5 }\n";
  const std::tuple<const char*, std::string, double> objects[] = {
      {"glass ball", "[[object]]\nshape = 'sphere'\n" + glass, 1e-4},
      {"diamond", "[[object]]\nshape = 'sphere'\nmaterial = { preset = 'diamond' }\n", 1e-4},
      {"bubble in water",
       "[[object]]\nshape = 'box'\nmaterial = { type = 'dielectric', ior = 1.33 }\n"
       "rotate = { axis = [1, 2, 3], angle = 50 }\n"
       "[[object]]\nshape = 'sphere'\nradius = 0.5\nmaterial = { type = 'dielectric', ior = 1 }\n",
       1e-4},
      {"glass torus", "[[object]]\nshape = 'torus'\naxis = [1, 1, 1]\nminor_radius = 0.3\n" + glass,
       1e-4},
      {"glass cone", "[[object]]\nshape = 'cone'\nradius = 0.8\n" + glass, 1e-4},
      {"overlap",
       "[[object]]\nshape = 'sphere'\nradius = 0.7\nmaterial = { type = 'dielectric', ior "
       "= 1.33 }\n[[object]]\nshape = 'sphere'\ncenter = [0.5, 0, 0]\nradius = 0.6\n"
       "material = { type = 'dielectric', ior = 1.5, priority = 1 }\n",
       1e-3},
      {"mirror", "[[object]]\nshape = 'sphere'\nmaterial = { type = 'mirror' }\n", 1e-4},
      {"metal",
       "[[object]]\nshape = 'torus'\naxis = [1, 1, 1]\nmaterial = { type = 'metal', color = "
       "1 }\n",
       1e-4},
      {"window",
       "[[object]]\nshape = 'cylinder'\ncapped = false\nmaterial = { type = 'dielectric', "
       "thin = true }\n",
       1e-4},
      {"everything at once",
       "[[light]]\ntype = 'ambient'\n[[object]]\nshape = 'sphere'\nmaterial = { type = 'classic', "
       "terms = [{ type = 'ambient' }], reflectivity = 0.3, reflection = 'schlick', transparency = "
       "[0.2, 0.5, 0.9], ior = 1.4 }\n",
       1e-4},
  };
  View view = Facing(24, 2.6);
  view.direction = {-0.2, -0.3, -1};
  view.position = -10.0 * view.direction;
  RenderOptions options;
  options.minContribution = 1e-7f;
  for (const auto& [name, object, lost] : objects) {
    const Picture picture = PictureOf(view.Exact(1000) + White + object, options);
    for (const float value : picture.rgb) ASSERT_NEAR(double(value), 1, lost) << name;
  }
}

TEST(Energy, AbsorptionOfASlab) {
  // White sky on both sides: what the front mirrors, and what passes both faces and the way between
  View view = Facing(2, 0.01);
  view.position = {0, 0, 100};
  const dvec3 left(0.9, 0.4, 0.1);
  for (const double degrees : {0.0, 30.0, 60.0, 80.0}) {
    const Picture picture = PictureOf(fmt::format(
        "{}{}[[object]]\nshape = 'box'\nmin = [-50, -50, -1]\nmax = [50, 50, 1]\nrotate = {{ axis "
        "= "
        "'y', angle = {} }}\nmaterial = {{ type = 'dielectric', ior = 1.5, attenuation_color = {}, "
        "attenuation_distance = 3 }}\n",
        view.Exact(3), White, degrees, Toml(left)));
    const double angle = glm::radians(degrees), inside = Refracted(angle, 1.5);
    const double once = Fresnel(std::cos(angle), 1.5);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(PixelAt(picture, 0, 1)[c],
                  once + (1 - once) * (1 - once) * std::pow(left[c], 2 / std::cos(inside) / 3),
                  2e-6)
          << degrees;
    }
  }
}

TEST(Energy, ColorsOfAClearBodyCountAtEachBoundary) {
  const Picture picture =
      PictureOf(Facing(1, 0.01).Exact(3) + White +
                "[[object]]\nshape = 'box'\nmaterial = { type = 'dielectric', ior = 1.5, color = "
                "[1, 0.5, 0.25] }\n");
  const double once = Fresnel(1, 1.5);
  for (int c = 0; c < 3; ++c) {
    // Of a share T of the light, F is mirrored and 1 − F passes; the opaque rest is black
    const double share = std::pow(0.5, c);
    const double expected = share * once + share * share * (1 - once) * (1 - once);
    EXPECT_NEAR(PixelAt(picture, 0, 0)[c], expected, 1e-6);
  }
}

TEST(Energy, TheCameraMayStandInGlass) {
  // In the middle of a ball, every ray goes one radius and leaves straight
  View view = Facing(8, 90);
  view.orthographic = false;
  view.position = {1, 2, 3};
  const std::string body =
      "[[object]]\n{}material = {{ type = 'dielectric', ior = 1.5, attenuation_color = 0.3, "
      "attenuation_distance = 2 }}\n";
  const Picture ball = PictureOf(
      view.Exact(2) + White +
      fmt::format(fmt::runtime(body), "shape = 'sphere'\ncenter = [1, 2, 3]\nradius = 4\n"));
  const double expected = (1 - Fresnel(1, 1 / 1.5)) * 0.09;
  for (const float value : ball.rgb) EXPECT_NEAR(value, expected, 2e-6);

  // Parallel rays that start in a slab, as far from its end as their height says
  View parallel{1, 16};
  parallel.position = {0, 0, 0};
  parallel.direction = {0, -1, -1};
  const Picture slab = PictureOf(
      parallel.Exact(2) + White +
      fmt::format(fmt::runtime(body), "shape = 'box'\nmin = [-9, -9, -2]\nmax = [9, 9, 9]\n"));
  for (int y = 0; y < 16; ++y) {
    // 45° lie beyond the critical angle of 42°: nothing gets out
    EXPECT_EQ(PixelAt(slab, 0, y).x, 0);
  }
  parallel.direction = {0, -0.2, -1};
  const Picture steeper = PictureOf(
      parallel.Exact(2) + White +
      fmt::format(fmt::runtime(body), "shape = 'box'\nmin = [-9, -9, -2]\nmax = [9, 9, 9]\n"));
  for (int y = 0; y < 16; ++y) {
    const dvec3 o = parallel.RayOrigin(0.5, y + 0.5), d = parallel.RayDirection(0.5, y + 0.5);
    const double way = (-2 - o.z) / d.z;
    EXPECT_NEAR(PixelAt(steeper, 0, y).x, (1 - Fresnel(-d.z, 1 / 1.5)) * std::pow(0.3, way / 2),
                2e-6);
  }
}

TEST(Energy, BoundariesBetweenEqualsCannotBeSeen) {
  const View view = Facing(48, 2.4);
  const std::string ball =
      "[[object]]\nshape = 'sphere'\nmaterial = { type = 'dielectric', ior = 1.5 }\n";
  const Picture alone = PictureOf(view.Exact(40) + DirectionMeter + ball);

  // A ball of the same glass within it, and one of another that yields to it
  for (const char* inner : {"ior = 1.5", "ior = 1.5, priority = 3", "ior = 2.4, priority = -1"}) {
    const Picture both = PictureOf(
        view.Exact(80) + DirectionMeter + ball +
        fmt::format(
            "[[object]]\nshape = 'sphere'\ncenter = [0.2, 0.1, 0]\nradius = 0.5\nmaterial = "
            "{{ type = 'dielectric', {} }}\n",
            inner));
    EXPECT_LT(LargestDifference(alone, both), 1e-6) << inner;
  }
}

TEST(Energy, TheSurroundingsHaveAnIndexToo) {
  const std::string view = Facing(32, 2.4).Exact(3);
  const std::string sky = "[environment]\nbottom = 0\ntop = 1\nior = 1.5\n";
  const auto ball = [](double ior) {
    return fmt::format(
        "[[object]]\nshape = 'sphere'\nmaterial = {{ type = 'dielectric', ior = {} }}\n", ior);
  };

  // Glass in oil of its own index vanishes
  for (const float value : PictureOf(view + sky + ball(1.5)).rgb) ASSERT_NEAR(value, 0.5, 1e-6);

  // Only the ratio of the indices counts
  EXPECT_LT(LargestDifference(PictureOf(view + sky + ball(2.25)),
                              PictureOf(view + DirectionMeter + ball(1.5))),
            1e-5);

  // An air bubble in it mirrors totally from 41.8° on: from two thirds of its radius
  const View bubble = Facing(64, 2);
  const Picture mirrored =
      PictureOf(bubble.Exact(2) + "[environment]\ncolor = 1\nior = 1.5\n" + ball(1));
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const dvec3 p = bubble.RayOrigin(x + 0.5, y + 0.5);
      const double h = std::hypot(p.x, p.y);
      if (h > 0.999 || std::abs(h - 1 / 1.5) < 1e-3) continue;
      EXPECT_NEAR(PixelAt(mirrored, x, y).x, Fresnel(std::sqrt(1 - h * h), 1 / 1.5), 5e-5);
    }
  }
}

// Two mirrors that face each other and glow a little, and a view from between them.
std::string FacingMirrors(const std::string& render) {
  const char* mirror =
      "[[object]]\nshape = 'plane'\npoint = [0, 0, {}]\nnormal = [0, 0, {}]\nmaterial = {{ type = "
      "'classic', emission = [0.1, 0.2, 0.3], reflectivity = [0.5, 0.8, 0.9] }}\n";
  return render + fmt::format(fmt::runtime(mirror), -1, 1) +
         fmt::format(fmt::runtime(mirror), 2, -1);
}

TEST(Energy, MirrorsThatFaceEachOtherAddAGeometricSeries) {
  View view = Facing(2, 30);
  view.orthographic = false;
  view.position = {0, 0, 0};
  const dvec3 glow(0.1, 0.2, 0.3), r(0.5, 0.8, 0.9);
  for (const int depth : {1, 2, 3, 10, 100}) {
    const RenderResult result = RenderText(FacingMirrors(view.Exact(depth)));
    for (int c = 0; c < 3; ++c) {
      const double sum = glow[c] * (1 - std::pow(r[c], depth)) / (1 - r[c]);
      EXPECT_NEAR(PixelAt(result.picture, 1, 1)[c], sum, 2e-5 * sum) << depth;
    }
    EXPECT_EQ(result.report.reflectedRays, 4u * unsigned(depth - 1));
  }
}

TEST(Energy, BranchesThatCountForLittleAreCut) {
  // A reflection is followed while its largest channel still counts: 0.9ᵏ ≥ the least contribution
  View view = Facing(1, 30);
  view.orthographic = false;
  view.position = {0, 0, 0};
  for (const double least : {0.002, 0.1, 0.5, 0.95}) {
    RenderOptions options;
    options.minContribution = float(least);
    const RenderResult result = RenderText(FacingMirrors(view.Exact(1000)), options);
    const int followed = int(std::log(least) / std::log(0.9));
    EXPECT_EQ(result.report.reflectedRays, unsigned(followed)) << least;
    EXPECT_NEAR(PixelAt(result.picture, 0, 0).z, 0.3 * (1 - std::pow(0.9, followed + 1)) / 0.1,
                1e-4);
  }
}

}  // namespace
}  // namespace snell::test
