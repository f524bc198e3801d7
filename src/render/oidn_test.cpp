// SPDX-License-Identifier: Apache-2.0
//
// How Open Image Denoise is called, with a library in its place (fake_oidn.cpp), which is loaded before anyone looks for
// the true one under the same name.
#include "render/oidn.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include "util/error.h"

namespace snell::render {
namespace {

DenoiseInput InputOf(int width, int height) {
  DenoiseInput input{width, height, {}, {}, {}, {}, {}};
  const std::size_t pixels = input.Pixels();
  for (std::size_t half = 0; half < 2; ++half) {
    input.color[half].assign(pixels, vec3(half == 0 ? 1.0f : 3.0f, 0.5f, 0.25f));
    input.albedo[half].assign(pixels, vec3(0.0f, 0.125f, 0.0f));
    input.normal[half].assign(pixels, vec3(0.0f, 0.0f, half == 0 ? 1.0f : 0.0f));
    input.nearness[half].assign(pixels, 1.0f);
  }
  input.variance.assign(pixels, vec3(0.0f));
  return input;
}

TEST(Oidn, IsGivenBothHalvesAndTheFeatures) {
  ASSERT_TRUE(::dlopen(SNELL_FAKE_OIDN, RTLD_NOW)) << ::dlerror();
  ASSERT_TRUE(HasOidn());
  const image::Image result = DenoiseByOidn(InputOf(3, 2));
  ASSERT_EQ(result.pixels.size(), 6u);
  for (const vec3& pixel : result.pixels) EXPECT_EQ(pixel, vec3(2.0f, 0.625f, 0.75f));

  // What the library reports is an error
  EXPECT_THROW(DenoiseByOidn(InputOf(1, 1)), Error);
  EXPECT_EQ(DenoiseByOidn(InputOf(1, 2)).height, 2);
}

}  // namespace
}  // namespace snell::render
