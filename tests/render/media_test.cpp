// SPDX-License-Identifier: Apache-2.0
//
// Media and what wanders below surfaces, against closed forms: Beer and Lambert's law, single scattering by quadrature,
// Chandrasekhar's H-function, and a furnace in which nothing that absorbs nothing may be seen.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "render/scene_text.h"
#include "support/numeric.h"

namespace snell::test {
namespace {

constexpr double Pi = std::numbers::pi;

std::string Settings(int size, int spp, int volumeDepth, int depth = 200) {
  return fmt::format(
      "[render]\nintegrator = 'path'\nfilter = 'box'\nsize = [{}, {}]\nspp = {}\nmax_depth = {}\n"
      "max_volume_depth = {}\n",
      size, size, spp, depth, volumeDepth);
}

// A narrow view along +x from the origin.
const std::string Along = "[camera]\nposition = [0, 0, 0]\nlook_at = [1, 0, 0]\nfov = 0.01\n";

// What is neither absorbed nor scattered goes straight through a slab, by e^(−σd).
TEST(Media, SlabsLetThroughWhatBeersLawSays) {
  for (const char* medium : {"absorption = [0.5, 1, 2]", "scattering = [0.5, 1, 2]",
                             "absorption = [0.1, 0.5, 1.5], scattering = [0.4, 0.5, 0.5]",
                             "absorption = [0.25, 0.5, 1], density = 2"}) {
    const Picture picture = PictureOf(fmt::format(
        "{}{}[environment]\ncolor = 1\n[[object]]\nshape = 'box'\nmin = [2, -1, -1]\nmax = [2.7, "
        "1, 1]\nmaterial = {{ type = 'volume', {} }}\n",
        Settings(16, 256, 0), Along, medium));
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(MeanOf(picture, channel), std::exp(-0.7 * 0.5 * (1 << channel)), 4e-3)
          << medium << ", channel " << channel;
  }
}

// Shadows through a medium are as dark as its transmittance says, wherever the boundary lies.
TEST(Media, ShadowRaysAreWeakenedOnTheWay) {
  const auto floor = [](const std::string& between) {
    return PixelAt(PictureOf(Settings(1, 16, 0, 2) +
                             "[camera]\nposition = [0, 1, 4]\nlook_at = [0, 0, 0]\nfov = 0.01\n"
                             "[[light]]\ntype = 'point'\nposition = [0, 3, 0]\nintensity = 10\n"
                             "[[object]]\nshape = 'plane'\nmaterial = { type = 'diffuse' }\n" +
                             between),
                   0, 0);
  };
  const dvec3 open = floor("");
  const dvec3 box = floor(
      "[[object]]\nshape = 'box'\nmin = [-0.2, 1, -0.2]\nmax = [0.2, 1.5, 0.2]\n"
      "material = { type = 'volume', absorption = [1, 2, 3], scattering = 1 }\n");
  const dvec3 around = floor(
      "[[object]]\nshape = 'sphere'\ncenter = [0, 3, 0]\nradius = 0.5\n"
      "material = { type = 'volume', absorption = [1, 2, 3], scattering = 1 }\n");
  for (int channel = 0; channel < 3; ++channel) {
    const double expected = open[channel] * std::exp(-0.5 * (channel + 2));
    EXPECT_NEAR(box[channel], expected, 1e-4 * expected);
    EXPECT_NEAR(around[channel], expected, 1e-4 * expected);
  }
}

// A point light beside the line of sight, in a medium without end: ∫ σs p(θ) I/r² e^(−σ(t + r)) dt.
TEST(Media, LightIsScatteredOnceAsTheIntegralSays) {
  constexpr double Scattering[3] = {0.1, 0.3, 0.2};
  constexpr double Extinction[3] = {0.15, 0.5, 1.0};
  for (const double g : {-0.5, 0.0, 0.7}) {
    const Picture picture = PictureOf(
        Settings(16, 1024, 1) + Along +
        fmt::format("[[light]]\ntype = 'point'\nposition = [2, 1.5, 0]\nintensity = 10\n"
                    "[environment]\nmedium = {{ scattering = [0.1, 0.3, 0.2], absorption = "
                    "[0.05, 0.2, 0.8], anisotropy = {} }}\n",
                    g));
    for (int channel = 0; channel < 3; ++channel) {
      const double expected = Integrate(0, 60, 2000, [&](double t) {
        const double r = std::hypot(2 - t, 1.5);
        const double cosine =
            (t - 2) / r;  // of the deflection: the light travels from it to the ray
        const double forward = -cosine;
        const double d = 1 + g * g - 2 * g * forward;
        const double phase = (1 - g * g) / (4 * Pi * d * std::sqrt(d));
        return Scattering[channel] * phase * 10 / (r * r) *
               std::exp(-Extinction[channel] * (t + r));
      });
      EXPECT_NEAR(MeanOf(picture, channel), expected, 0.012 * expected) << g << ' ' << channel;
    }
  }
}

// Light that the phase function finds, and light that is sampled, are the same light.
TEST(Media, BothWaysToALightAgree) {
  const auto fog = [](const char* visible) {
    return MeanOf(PictureOf(
        Settings(16, 512, 1) + Along +
        "[environment]\nmedium = { scattering = 0.2, absorption = 0.1, anisotropy = 0.8 }\n" +
        fmt::format("[[light]]\ntype = 'sphere'\ncenter = [5, 1.5, 0]\nradius = 1\nradiance = "
                    "3\nvisible = {}\n",
                    visible)));
  };
  const double sampled = fog("false");
  EXPECT_NEAR(fog("true"), sampled, 0.012 * sampled);
}

// Under an even sky a medium that absorbs nothing is as bright as the sky, at any thickness, in any body.
TEST(Media, NothingIsLostInTheFurnace) {
  const std::pair<const char*, double> materials[] = {
      {"type = 'volume', scattering = 0.5", 1e-6},
      {"type = 'volume', scattering = 10, anisotropy = 0.8", 1e-6},
      {"type = 'volume', scattering = 6, anisotropy = -0.5", 1e-6},
      {"type = 'volume', scattering = [0.3, 2, 9], anisotropy = 0.3", 4e-3},
      {"type = 'openpbr', transmission_weight = 1, base_color = 1, specular_roughness = 0, "
       "transmission_depth = 1, transmission_scatter = 8, transmission_scatter_anisotropy "
       "= 0.5",
       6e-3},
      {"type = 'openpbr', transmission_weight = 1, base_color = 1, specular_roughness = 0.4, "
       "transmission_depth = 1, transmission_scatter = 3",
       8e-3},
      {"type = 'openpbr', specular_weight = 0, subsurface_weight = 1, subsurface_color = 1, "
       "subsurface_radius = 0.1",
       4e-3},
      {"type = 'openpbr', specular_roughness = 0.2, subsurface_weight = 0.7, base_color = 1, "
       "subsurface_color = 1, subsurface_radius = 0.2, subsurface_scatter_anisotropy = 0.6",
       4e-3},
      {"type = 'openpbr', thin = true, subsurface_weight = 1, subsurface_color = 1, "
       "subsurface_scatter_anisotropy = 0.3",
       4e-3},
  };
  for (const auto& [material, tolerance] : materials) {
    const Picture picture = PictureOf(fmt::format(
        "{}[camera]\nposition = [0, 0, 10]\nlook_at = [0, 0, 0]\nfov = 9\n[environment]\ncolor = "
        "0.5\n[[object]]\nshape = 'sphere'\nradius = 0.7\nmaterial = {{ {} }}\n",
        Settings(20, 64, 100000), material));
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(MeanOf(picture, channel), 0.5, tolerance) << material << ' ' << channel;
  }
}

// Chandrasekhar's H-function of isotropic scattering with this albedo, by its integral equation (1960, "Radiative
// transfer", chapter V): 1/H(μ) = √(1 − ω) + ω/2 ∫ x H(x) / (μ + x) dx.
double HFunction(double albedo, double mu) {
  constexpr int Nodes = 400;
  std::vector<double> h(Nodes, 1);
  const auto next = [&](double at) {
    double sum = 0;
    for (int i = 0; i < Nodes; ++i) {
      const double x = (i + 0.5) / Nodes;
      sum += x * h[std::size_t(i)] / (at + x) / Nodes;
    }
    return 1 / (std::sqrt(1 - albedo) + albedo / 2 * sum);
  };
  for (int round = 0; round < 200; ++round) {
    std::vector<double> better(Nodes);
    // The geometric mean damps the iteration, which else swings
    for (std::size_t i = 0; i < Nodes; ++i)
      better[i] = std::sqrt(h[i] * next((double(i) + 0.5) / Nodes));
    h = better;
  }
  return next(mu);
}

TEST(Media, HalfSpacesHaveChandrasekharsAlbedo) {
  // His table's end for light that is never absorbed
  EXPECT_NEAR(HFunction(1 - 1e-9, 1), 2.9078, 0.001);
  for (const double albedo : {0.5, 0.9, 0.98}) {
    for (const double mu : {1.0, 0.5, 0.2}) {
      const double sine = std::sqrt(1 - mu * mu);
      const Picture picture = PictureOf(fmt::format(
          "{}[camera]\ntype = 'orthographic'\nheight = 0.001\nposition = [{}, {}, 0]\nlook_at = "
          "[0, 0, 0]\nup = [0, 0, 1]\n[environment]\ncolor = 1\n[[object]]\nshape = 'box'\nmin = "
          "[-500, -100, -500]\nmax = [500, 0, 500]\nmaterial = {{ type = 'volume', scattering = "
          "{}, absorption = {} }}\n",
          Settings(16, 64, 100000), sine * 5, mu * 5, albedo, 1 - albedo));
      EXPECT_NEAR(MeanOf(picture), 1 - HFunction(albedo, mu) * std::sqrt(1 - albedo), 5e-3)
          << albedo << ' ' << mu;
    }
  }
}

// A thick body under an even sky shows the colour that it was given, whatever the anisotropy; van de Hulst's fit is
// good to about a hundredth.
TEST(Media, SubsurfaceColourIsWhatComesBack) {
  for (const double color : {0.1, 0.5, 0.8, 0.95}) {
    for (const double g : {0.0, 0.7}) {
      const Picture picture = PictureOf(fmt::format(
          "{}[camera]\nposition = [0, 5, 0]\nlook_at = [0, 0, 0]\nup = [0, 0, 1]\nfov = "
          "1\n[environment]\ncolor = 1\n[[object]]\nshape = 'box'\nmin = [-900, -900, -900]\nmax = "
          "[900, 0, 900]\nmaterial = {{ type = 'openpbr', specular_weight = 0, subsurface_weight = "
          "1, subsurface_color = {}, subsurface_radius = 1, subsurface_radius_scale = 1, "
          "subsurface_scatter_anisotropy = {} }}\n",
          Settings(16, 32, 100000), color, g));
      EXPECT_NEAR(MeanOf(picture), color, 0.012) << color << ' ' << g;
    }
  }
}

// A glow of E per metre along a chord of length d is E (1 − e^(−σd)) / σ.
TEST(Media, GlowAddsUpAlongTheWay) {
  const Picture picture = PictureOf(
      Settings(2, 1, 0) + Along +
      "[[object]]\nshape = 'sphere'\ncenter = [3, 0, 0]\nmaterial = { type = 'volume', glow = "
      "[0.5, 0.2, 0.1], absorption = [0, 0.5, 3] }\n");
  EXPECT_NEAR(MeanOf(picture, 0), 1, 1e-5);
  EXPECT_NEAR(MeanOf(picture, 1), 0.4 * (1 - std::exp(-1.0)), 1e-5);
  EXPECT_NEAR(MeanOf(picture, 2), 0.1 / 3 * (1 - std::exp(-6.0)), 1e-5);
}

// A boundary that is not seen changes nothing where both of its sides are the same.
TEST(Media, FogInABodyIsFogAround) {
  const std::string things =
      "[[light]]\ntype = 'point'\nposition = [2, 2, 1]\nintensity = 20\n[[object]]\nshape = "
      "'sphere'\ncenter = [4, 0, 0]\nradius = 0.5\nmaterial = { type = 'diffuse' }\n[camera]\n"
      "position = [0, 0, 0]\nlook_at = [1, 0, 0]\nfov = 30\n";
  const std::string medium = "scattering = [0.1, 0.2, 0.3], absorption = 0.1, anisotropy = 0.4";
  const std::string settings = Settings(16, 400, 8);
  const Picture around =
      PictureOf(settings + things + "[environment]\nmedium = { " + medium + " }\n");
  const Picture inside = PictureOf(settings + things +
                                   "[[object]]\nshape = 'sphere'\nradius = 60\nmaterial = { type "
                                   "= 'volume', " +
                                   medium + " }\n");
  for (int channel = 0; channel < 3; ++channel)
    EXPECT_NEAR(MeanOf(inside, channel), MeanOf(around, channel), 0.012 * MeanOf(around, channel));
}

}  // namespace
}  // namespace snell::test
