// SPDX-License-Identifier: Apache-2.0
#include "scene/deformation.h"

#include <gtest/gtest.h>

#include <numbers>
#include <tuple>
#include <utility>

namespace snell::scene {
namespace {

// A triangle whose first corner is at x = 0, 4 and 5 at the times 1, 3 and 4.
Mesh Triangle() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.tangents.assign(3, vec4(1, 0, 0, -1));
  mesh.triangles = {{0, 1, 2}};
  mesh.time = 1;
  for (const auto& [time, x] : {std::pair(3.0, 4.0f), {4.0, 5.0f}}) {
    mesh.keys.push_back({time, mesh.positions, {}, mesh.tangents});
    mesh.keys.back().positions[0].x = x;
  }
  return mesh;
}

TEST(Deformation, HasKeysAtEvenStepsOfTheShutter) {
  const Mesh shape = ShapeDuring(Triangle(), 0, 4);
  EXPECT_EQ(shape.positions[0].x, 0);
  ASSERT_EQ(shape.keys.size(), 4u) << "cuts at 1 and 3 of 4 seconds";
  for (const auto& [key, x] : {std::pair(0, 0.0f), {1, 2.0f}, {2, 4.0f}, {3, 5.0f}})
    EXPECT_EQ(shape.keys[std::size_t(key)].positions[0].x, x);
  EXPECT_EQ(shape.keys[1].tangents[2], vec4(1, 0, 0, -1));
  // Within one pair of keys two moments suffice
  const Mesh part = ShapeDuring(Triangle(), 1.5, 2);
  EXPECT_EQ(part.positions[0].x, 1);
  ASSERT_EQ(part.keys.size(), 1u);
  EXPECT_EQ(part.keys[0].positions[0].x, 2);
}

TEST(Deformation, RestsBeforeAndAfterAndInAMoment) {
  for (const auto& [open, close, x] :
       {std::tuple(0.0, 1.0, 0.0f), {2.0, 2.0, 2.0f}, {4.0, 9.0, 5.0f}, {5.0, 5.0, 5.0f}}) {
    const Mesh shape = ShapeDuring(Triangle(), open, close);
    EXPECT_TRUE(shape.keys.empty());
    EXPECT_EQ(shape.positions[0].x, x);
  }
  Mesh still = Triangle();
  still.keys.clear();
  EXPECT_EQ(ShapeDuring(still, 0, 9).positions, still.positions);
}

TEST(Deformation, TakesManyStepsForOddKeysButNotTooMany) {
  Mesh mesh = Triangle();
  mesh.keys[0].time = 1 + std::numbers::pi / 4;
  EXPECT_EQ(ShapeDuring(mesh, 0, 4).keys.size(), 64u);
}

}  // namespace
}  // namespace snell::scene
