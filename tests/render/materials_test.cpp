// SPDX-License-Identifier: Apache-2.0
//
// Physical materials in whole pictures: the layers' energy, the spectrum of a prism, and what is below a coat.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "image/spectrum.h"
#include "kernel/fresnel.h"
#include "render/scene_text.h"

namespace snell::test {
namespace {

std::string Settings(int size, int spp, int depth) {
  return fmt::format(
      "[render]\nintegrator = 'path'\nfilter = 'box'\nsize = [{}, {}]\nspp = {}\n"
      "max_depth = {}\n",
      size, size, spp, depth);
}

Picture InFurnace(const std::string& material) {
  return PictureOf(
      Settings(20, 144, 200) +
      "[camera]\nposition = [0, 0, 10]\nlook_at = [0, 0, 0]\nfov = 9\n[environment]\ncolor = "
      "0.5\n[[object]]\nshape = 'sphere'\nradius = 0.7\nmaterial = { type = 'openpbr', " +
      material + " }\n");
}

// Layers that absorb nothing do not show under an even sky; what the approximations miss is bounded.
TEST(Materials, LayersKeepTheLight) {
  const std::pair<const char*, double> materials[] = {
      {"base_color = 1, thin_film_weight = 1, thin_film_thickness = 0.4, specular_roughness = 0.1",
       6e-3},
      {"base_color = 1, thin_film_weight = 1, thin_film_thickness = 0.3, specular_roughness = 0.7",
       8e-3},
      {"base_color = 1, thin_film_weight = 1, thin_film_ior = 2, base_metalness = 1, "
       "specular_roughness = 0.3",
       8e-3},
      {"transmission_weight = 1, thin_film_weight = 1, specular_roughness = 0", 2e-3},
      {"transmission_weight = 1, thin_film_weight = 1, specular_roughness = 0.5", 1e-2},
      {"transmission_weight = 1, thin_film_weight = 1, thin = true, specular_roughness = 0", 2e-3},
      {"transmission_weight = 1, transmission_dispersion_scale = 1, specular_roughness = 0", 4e-3},
      {"transmission_weight = 1, transmission_dispersion_scale = 1, specular_roughness = 0.4",
       8e-3},
      {"base_color = 1, base_diffuse_roughness = 1, specular_weight = 0", 4e-3},
      {"base_color = 1, base_metalness = 1, specular_roughness = 0.4, "
       "specular_roughness_anisotropy = 0.8",
       1.5e-2},
      {"base_color = 1, specular_weight = 0, coat_weight = 1", 8e-3},
      {"base_color = 1, coat_weight = 1, coat_roughness = 0.5", 1.5e-2},
      {"base_color = 1, base_metalness = 1, specular_roughness = 0.2, coat_weight = 1", 1e-2},
  };
  for (const auto& [material, tolerance] : materials) {
    const Picture picture = InFurnace(material);
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(MeanOf(picture, channel), 0.5, tolerance) << material << ", " << channel;
  }
}

// Nothing gives back more than it gets, at the edges either.
TEST(Materials, NoLayersMakeLight) {
  for (const char* material :
       {"base_color = 1, fuzz_weight = 1, coat_weight = 1, coat_roughness = 0.3",
        "base_color = 0.9, thin_film_weight = 1, coat_weight = 0.5, specular_roughness = 0.9",
        "base_color = 1, base_metalness = 0.5, transmission_weight = 0.5, fuzz_weight = 0.5",
        "base_color = 1, specular_weight = 3, coat_weight = 1, coat_ior = 2.5"}) {
    const Picture picture = InFurnace(material);
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_LT(MeanOf(picture, channel), 0.51) << material;
  }
}

// Coats take what they let through twice; fuzz covers whatever its colour.
TEST(Materials, CoatsAndFuzzCoverTheBase) {
  const Picture coat = InFurnace(
      "base_color = 1, specular_weight = 0, coat_weight = 1, coat_ior = 1.001, coat_color = [1, "
      "0.5, 0.25]");
  // A matt ball's light leaves at all angles, on ways through the coat that are longer than straight ones
  EXPECT_NEAR(MeanOf(coat, 0), 0.5, 5e-3);
  EXPECT_LT(MeanOf(coat, 1), 0.44);
  EXPECT_LT(MeanOf(coat, 2), MeanOf(coat, 1));
  const double bare = MeanOf(InFurnace("base_color = 0.8"));
  EXPECT_LT(MeanOf(InFurnace("base_color = 0.8, fuzz_weight = 1, fuzz_color = 0")), bare - 0.01);
  // What glows below a coloured coat is seen through it, once
  const std::string glow =
      "[camera]\nposition = [0, 0, 5]\nlook_at = [0, 0, 0]\nfov = 1\n[[object]]\nshape = 'plane'\n"
      "normal = [0, 0, 1]\nmaterial = { type = 'openpbr', base_color = 0, emission = 1, "
      "coat_weight = 1, coat_ior = 1.6, coat_color = [1, 0.25, 0.81] }\n";
  const Picture below = PictureOf(Settings(2, 1, 1) + glow);
  const double passed = 1 - std::pow(0.6 / 2.6, 2);
  EXPECT_NEAR(MeanOf(below, 0), passed, 2e-3);
  EXPECT_NEAR(MeanOf(below, 1), passed * 0.5, 2e-3);
  EXPECT_NEAR(MeanOf(below, 2), passed * 0.9, 2e-3);
}

// --- Dispersion ---------------------------------------------------------------------------------------------

constexpr double Apex = 40 * 0.017453292519943295;
constexpr double Ior = 1.6, Abbe = 20;

double IorAt(double nanometres) {
  const auto inverse = [](double nm) { return 1e6 / (nm * nm); };
  const double b = (Ior - 1) / (Abbe * (inverse(486.1) - inverse(656.3)));
  return Ior + b * (inverse(nanometres) - inverse(587.6));
}

double Reflectance(double cosine, double eta) {
  const float c = float(cosine), e = float(eta);
  return double(kernel::FrDielectric(c, kernel::RefractedCosine(c, e), e));
}

// The radiance of the sky in a direction: a ramp over the sine of the elevation.
const double Low = std::sin(-45 * 0.017453292519943295),
             High = std::sin(-10 * 0.017453292519943295);
double Sky(const dvec3& d) { return glm::clamp((d.y - Low) / (High - Low), 0.0, 1.0); }

// What comes along +x out of the prism of one wavelength: reflected at its first face, and passed by both.
double ThroughPrism(double nanometres) {
  const double n = IorAt(nanometres);
  const dvec3 along(1, 0, 0);
  const dvec3 first(-std::cos(Apex / 2), std::sin(Apex / 2), 0);
  const dvec3 second(std::cos(Apex / 2), std::sin(Apex / 2), 0);
  const double r1 = Reflectance(-glm::dot(along, first), n);
  const dvec3 inside = glm::refract(along, first, 1 / n);
  const double r2 = Reflectance(glm::dot(inside, second), 1 / n);
  const dvec3 out = glm::refract(inside, -second, n);
  return r1 * Sky(glm::reflect(along, first)) + (1 - r1) * (1 - r2) * Sky(out);
}

// Each wavelength leaves by Snell's law; each channel shows the mean over those that it sees.
TEST(Dispersion, APrismBendsEachWavelengthByItsIndex) {
  dvec3 expected(0.0), sum(0.0);
  for (int nanometres = 380; nanometres <= 780; ++nanometres) {
    const dvec3 seen = glm::max(image::DaylightResponse(nanometres), dvec3(0.0));
    sum += seen;
    expected += seen * ThroughPrism(nanometres);
  }
  expected /= sum;
  const std::string height = fmt::format("{:.9f}", 1 / std::tan(Apex / 2));
  const std::string scene =
      "[camera]\ntype = 'orthographic'\nheight = 0.01\nposition = [-5, 1, 0]\nlook_at = [0, 1, "
      "0]\n[environment]\nbottom = 0\ntop = 1\nbottom_elevation = -45\ntop_elevation = -10\n"
      "[[object]]\nmesh = { positions = [[-1, 0, -1], [1, 0, -1], [0, " +
      height + ", -1], [-1, 0, 1], [1, 0, 1], [0, " + height +
      ", 1]], polygons = [[0, 3, 5, 2], [1, 2, 5, 4], [0, 1, 4, 3], [3, 4, 5], [0, 2, 1]] }\n" +
      fmt::format(
          "material = {{ type = 'openpbr', transmission_weight = 1, ior = {}, "
          "specular_roughness = 0, transmission_dispersion_scale = 1, "
          "transmission_dispersion_abbe_number = {} }}\n",
          Ior, Abbe);
  const Picture picture = PictureOf(Settings(8, 1024, 3) + scene);
  for (int channel = 0; channel < 3; ++channel)
    EXPECT_NEAR(MeanOf(picture, channel), expected[channel], 3e-3) << channel;
  // Blue is bent the most, down where the sky is dark
  EXPECT_GT(expected.x, expected.y + 0.01);
  EXPECT_GT(expected.y, expected.z + 0.02);
}

// --- Names --------------------------------------------------------------------------------------------------

// A mirror of a named metal shows the sky in its colour.
TEST(Materials, NamedMetalsReflectTheirColour) {
  const Picture picture = PictureOf(
      Settings(2, 16, 2) +
      "[camera]\nposition = [0, 0, 5]\nlook_at = [0, 0, 0]\nfov = 1\n[environment]\ncolor = 1\n"
      "[[object]]\nshape = 'plane'\nnormal = [0, 0, 1]\nmaterial = { metal = 'gold', "
      "specular_roughness = 0 }\n");
  EXPECT_NEAR(MeanOf(picture, 0), 1, 0.03);
  EXPECT_NEAR(MeanOf(picture, 1), 0.77, 0.05);
  EXPECT_NEAR(MeanOf(picture, 2), 0.34, 0.06);
}

// Without a word about the integrator, a physical material is path traced: light from a glowing panel arrives.
TEST(Materials, PhysicalOnesAskForPaths) {
  const std::string scene =
      "[render]\nsize = [4, 4]\nspp = 16\n[camera]\nposition = [0, 2, 3]\nlook_at = [0, 0, 0]\n"
      "[[object]]\nshape = 'sphere'\ncenter = [0, 8, 0]\nmaterial = { type = 'diffuse', emission = "
      "50 }\n[[object]]\nshape = 'plane'\nmaterial = ";
  EXPECT_GT(MeanOf(PictureOf(scene + "{ type = 'openpbr' }\n")), 0.01);
  EXPECT_EQ(MeanOf(PictureOf(scene + "{ type = 'diffuse' }\n")), 0);
}

}  // namespace
}  // namespace snell::test
