// SPDX-License-Identifier: Apache-2.0
//
// Pictures as the kernel sees them: bits kept, levels of detail that keep the mean, a distant checker that
// shows its mean in one sample.
#include "cpu/flatten_texture.h"

#include <gtest/gtest.h>

#include <bit>
#include <glm/gtc/matrix_transform.hpp>

#include "bvh/bvh.h"
#include "cpu/kernel.h"

namespace snell::cpu {
namespace {

// A checker of black and white texels.
scene::Scene CheckerScene(int width, int height, bool srgb) {
  scene::Scene scene;
  scene::Image image;
  image.width = width;
  image.height = height;
  image.srgb = srgb;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::uint8_t code = (x + y) % 2 == 0 ? 255 : 0;
      image.bytes.insert(image.bytes.end(), {code, code, code, 255});
    }
  }
  scene.images.push_back(image);
  scene::Texture texture;
  texture.kind = scene::TextureKind::Image;
  texture.image = 0;
  scene.textures.push_back(texture);
  return scene;
}

vec4 Evaluate(const FlatScene& flat, vec2 uv, float footprint) {
  const bvh::Bvh bvh(bvh::Geometry{});
  return BindKernel(flat, bvh).EvalImage(flat.textures[0], uv, footprint);
}

TEST(FlattenTextures, KeepsTexelsAndTheirPlaces) {
  FlatScene flat = {};
  FlattenTextures(CheckerScene(4, 2, false), flat);
  ASSERT_EQ(flat.images.size(), 1u);
  EXPECT_EQ(flat.images[0].levels, 3u);
  // Texel (0, 0) is the upper left one and white
  EXPECT_NEAR(Evaluate(flat, vec2(0.125f, 0.75f), 0).x, 1.0f, 1e-6f);
  EXPECT_NEAR(Evaluate(flat, vec2(0.375f, 0.75f), 0).x, 0.0f, 1e-6f);
  EXPECT_NEAR(Evaluate(flat, vec2(0.125f, 0.25f), 0).x, 0.0f, 1e-6f);
  EXPECT_NEAR(Evaluate(flat, vec2(0.25f, 0.75f), 0).x, 0.5f, 1e-6f);
}

TEST(FlattenTextures, LevelsKeepTheMeanInLinearLight) {
  for (const bool srgb : {false, true}) {
    for (const int width : {2, 6, 16, 31}) {
      FlatScene flat = {};
      FlattenTextures(CheckerScene(width, 16, srgb), flat);
      // The last level; codes round it
      const float mean = Evaluate(flat, vec2(0.3f, 0.6f), 1.0f).x;
      EXPECT_NEAR(mean, 0.5f, 0.01f) << width << (srgb ? " sRGB" : "");
    }
  }
}

TEST(FlattenTextures, DistantCheckersDoNotShimmer) {
  FlatScene flat = {};
  FlattenTextures(CheckerScene(64, 64, true), flat);
  // The spread of samples at random places, of a footprint of so many texels
  float lastSpread = 1;
  for (const float texels : {1.0f, 2.0f, 4.0f, 8.0f}) {
    float least = 1, most = 0;
    for (int i = 0; i < 1000; ++i) {
      const vec2 uv(float(i) * 0.6180339f, float(i) * 0.7548776f);
      const float shade = Evaluate(flat, uv, texels / 64).x;
      least = std::min(least, shade);
      most = std::max(most, shade);
    }
    EXPECT_LE(most - least, lastSpread);
    lastSpread = most - least;
  }
  EXPECT_LT(lastSpread, 0.01f);
}

TEST(FlattenTextures, FloatsKeepTheirBits) {
  scene::Scene scene = CheckerScene(1, 1, false);
  scene.images[0].bytes.clear();
  scene.images[0].floats = {1e-20f, 12345.678f, 0.1f, 0.5f};
  FlatScene flat = {};
  FlattenTextures(scene, flat);
  const vec4 texel = Evaluate(flat, vec2(0.5f, 0.5f), 0);
  EXPECT_EQ(texel.y, 12345.678f);
  EXPECT_EQ(texel.z, 0.1f);
}

TEST(FlattenTextures, PatternsHaveTexelsForBumps) {
  scene::Scene scene;
  scene.textures.resize(1);
  scene.textures[0].placement = glm::scale(scene::Affine(1.0), glm::dvec3(0.25));
  FlatScene flat;
  FlattenTextures(scene, flat);
  EXPECT_FLOAT_EQ(flat.textures[0].texelDensity, 4 * 64);
}

}  // namespace
}  // namespace snell::cpu
