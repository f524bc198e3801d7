// SPDX-License-Identifier: Apache-2.0
//
// Named metals and glasses against what others publish of them.
#include "scene/measured.h"

#include <gtest/gtest.h>

namespace snell::scene {
namespace {

// Reflectances in linear Rec.709 that are widely used (Palmqvist, "Physically Based" database; Hoffman 2020, "Physics and
// math of shading", SIGGRAPH course).
TEST(MeasuredMetals, HaveThePublishedColours) {
  const std::pair<const char*, Spectrum> published[] = {
      {"gold", {1.00f, 0.77f, 0.34f}},   {"silver", {0.99f, 0.98f, 0.97f}},
      {"copper", {0.95f, 0.64f, 0.54f}}, {"aluminium", {0.91f, 0.92f, 0.92f}},
      {"iron", {0.53f, 0.51f, 0.49f}},   {"titanium", {0.62f, 0.58f, 0.54f}},
      {"nickel", {0.66f, 0.61f, 0.53f}}, {"platinum", {0.67f, 0.64f, 0.59f}}};
  for (const auto& [name, color] : published) {
    const MeasuredMetal* metal = FindMetal(name);
    ASSERT_NE(metal, nullptr) << name;
    OpenPbr material;
    SetMetal(*metal, material);
    EXPECT_EQ(material.baseMetalness.value, 1);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(material.baseColor.value[c], color[c], 0.06f) << name << " " << c;
  }
}

// At grazing incidence metals fall behind Schlick's curve, silver less than iron.
TEST(MeasuredMetals, AreTintedTowardsTheEdge) {
  for (const MeasuredMetal& metal : MeasuredMetals()) {
    OpenPbr material;
    SetMetal(metal, material);
    for (int c = 0; c < 3; ++c) {
      EXPECT_GT(material.specularColor.value[c], 0.7f) << metal.name;
      EXPECT_LE(material.specularColor.value[c], 1.0f) << metal.name;
    }
  }
  OpenPbr silver, iron;
  SetMetal(*FindMetal("silver"), silver);
  SetMetal(*FindMetal("iron"), iron);
  EXPECT_GT(silver.specularColor.value.y, 0.98f);
  EXPECT_LT(iron.specularColor.value.y, 0.9f);
}

// n_d and Abbe's number as the catalogues have them.
TEST(MeasuredGlasses, HaveThePublishedIndices) {
  const std::tuple<const char*, double, double> published[] = {
      {"BK7", 1.51680, 64.17},    {"F5", 1.60342, 38.03},     {"SF10", 1.72825, 28.41},
      {"SF11", 1.78472, 25.76},   {"LASF9", 1.85025, 32.17},  {"fused silica", 1.45846, 67.82},
      {"water", 1.33336, 55.75},  {"acrylic", 1.4906, 53.2},  {"polycarbonate", 1.5848, 27.9},
      {"sapphire", 1.7681, 72.3}, {"zirconia", 2.1585, 33.5}, {"diamond", 2.4175, 55.3}};
  EXPECT_EQ(std::size(published), MeasuredGlasses().size());
  for (const auto& [name, ior, abbe] : published) {
    const MeasuredGlass* glass = FindGlass(name);
    ASSERT_NE(glass, nullptr) << name;
    EXPECT_NEAR(glass->Ior(587.6), ior, 4e-4) << name;
    EXPECT_NEAR(glass->Abbe(), abbe, 0.01 * abbe) << name;
  }
}

TEST(Measured, UnknownNamesAreNone) {
  EXPECT_EQ(FindMetal("unobtainium"), nullptr);
  EXPECT_EQ(FindGlass(""), nullptr);
}

}  // namespace
}  // namespace snell::scene
