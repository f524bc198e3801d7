// SPDX-License-Identifier: Apache-2.0
//
// Places between keys, their inverses, and the bounds of what these lose.
#include "kernel/motion.h"

#include <gtest/gtest.h>

#include <glm/matrix.hpp>

#include "support/random.h"

namespace snell::kernel {
namespace {

MotionKey RandomKey(test::Random& random, float size) {
  MotionKey key;
  key.x = vec3(random.Direction()) * size;
  key.y = vec3(random.Direction()) * size;
  key.z = Normalize(Cross(key.x, key.y)) * size;
  key.origin = vec3(random.InCube()) * 100.0f;
  return key;
}

TEST(MomentOf, KeepsWithinTheKeys) {
  for (const uint steps : {1u, 3u, 7u, 256u}) {
    for (float time = 0; time < 1; time += 0.01f) {
      const MotionMoment moment = MomentOf(time, steps);
      EXPECT_LT(moment.step, steps);
      EXPECT_NEAR((float(moment.step) + moment.share) / float(steps), time, 1e-6f);
      EXPECT_GE(moment.share, 0);
      EXPECT_LT(moment.share, 1);
    }
    EXPECT_EQ(MomentOf(0.99999994f, steps).step, steps - 1);
    EXPECT_EQ(MomentOf(1, steps).share, 1);
  }
}

TEST(PlaceBetween, MovesPointsStraight) {
  test::Random random(11);
  for (int i = 0; i < 1000; ++i) {
    const MotionKey a = RandomKey(random, 1), b = RandomKey(random, 2);
    const float share = random.UniformFloat();
    const Transform place = PlaceBetween(a, b, share), from = PlaceBetween(a, a, 0),
                    to = PlaceBetween(b, b, 0);
    const vec3 p(random.InCube());
    const vec3 expected = Lerp(share, ToWorldPoint(from, p), ToWorldPoint(to, p));
    EXPECT_NEAR(Length(ToWorldPoint(place, p) - expected), 0, 1e-4f);
  }
}

TEST(PlaceBetween, KnowsWhatItsInverseLoses) {
  test::Random random(12);
  for (int i = 0; i < 20000; ++i) {
    const MotionKey key = RandomKey(random, random.UniformFloat() + 0.01f);
    const Transform m = PlaceBetween(key, key, 0.5f);
    const vec3 world = m.origin + vec3(random.InCube()) * 10.0f;
    // Exactly back to the world, after the kernel's way into the local space
    const glm::dmat3 linear{glm::dvec3(m.x), glm::dvec3(m.y), glm::dvec3(m.z)};
    const vec3 q = world - m.origin;
    const glm::dvec3 off = linear * glm::dvec3(ToLocalVector(m, q)) - glm::dvec3(q);
    EXPECT_LE(glm::length(off), double(InverseError(m, world).x)) << i;
  }
}

}  // namespace
}  // namespace snell::kernel
