// SPDX-License-Identifier: Apache-2.0
//
// Motion between keys against turns and moves that are known.
#include "scene/motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <numbers>

namespace snell::scene {
namespace {

constexpr double Pi = std::numbers::pi;

Affine Turned(double degrees, glm::dvec3 axis, glm::dvec3 origin, glm::dvec3 scale) {
  const Affine moved = glm::translate(Affine(1.0), origin);
  return glm::scale(glm::rotate(moved, degrees * Pi / 180, glm::normalize(axis)), scale);
}

void ExpectNear(const Affine& a, const Affine& b) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) EXPECT_NEAR(a[column][row], b[column][row], 1e-12);
}

TEST(Motion, TurnsMovesAndStretchesEvenly) {
  const glm::dvec3 axis(1, 2, -0.5);
  for (const double mirrored : {1.0, -1.0}) {
    const glm::dvec3 scale(2 * mirrored, 0.5, 1);
    const Motion motion = {{1, Turned(20, axis, {1, 0, 0}, scale)},
                           {3, Turned(120, axis, {5, 2, 0}, scale * 3.0)}};
    ExpectNear(PlaceAt(motion, 1.5), Turned(45, axis, {2, 0.5, 0}, scale * 1.5));
    ExpectNear(PlaceAt(motion, 3), motion[1].place);
    ExpectNear(PlaceAt(motion, 0), motion[0].place);
    ExpectNear(PlaceAt(motion, 9), motion[1].place);
    EXPECT_TRUE(KeepsHandedness(motion));
  }
  EXPECT_FALSE(KeepsHandedness({{0, Affine(1.0)}, {1, glm::scale(Affine(1.0), {-1, 1, 1})}}));
}

TEST(Motion, IsCutWhereItTurns) {
  const glm::dvec3 y(0, 1, 0), one(1.0);
  const Motion turn = {{0, Turned(0, y, {0, 0, 0}, one)}, {1, Turned(90, y, {0, 0, 0}, one)}};
  EXPECT_EQ(StepsOf(turn, 0, 1), 45);
  EXPECT_EQ(StepsOf(turn, 0, 0.1), 5);
  EXPECT_EQ(StepsOf(turn, 0.9, 3), 5);
  const Motion move = {{0, Turned(0, y, {0, 0, 0}, one)}, {1, Turned(0, y, {1, 0, 0}, one)}};
  EXPECT_EQ(StepsOf(move, 0, 1), 1);
  // A corner after three tenths of the time
  EXPECT_EQ(StepsOf({move[0], {0.3, move[1].place}, {1, move[0].place}}, 0, 1), 10);
  EXPECT_TRUE(IsMoving(move, 0.2, 0.3));
  EXPECT_FALSE(IsMoving(move, 1, 2));
  EXPECT_FALSE(IsMoving(move, 0.5, 0.5));
  EXPECT_TRUE(IsMoving({move[0], {0.5, move[1].place}, {1, move[0].place}}, 0, 1))
      << "there and back";
}

TEST(Motion, ComposesWithWhatIsAround) {
  const Affine still = glm::translate(Affine(1.0), {0, 7, 0});
  const Motion outer = {{0, Affine(1.0)}, {2, glm::translate(Affine(1.0), {4, 0, 0})}};
  const Motion inner = {{1, still}, {3, glm::translate(still, {0, 0, 6})}};
  const Motion both = Compose(Affine(1.0), outer, still, inner);
  ASSERT_EQ(both.size(), 4u);
  ExpectNear(PlaceAt(both, 2), glm::translate(Affine(1.0), {4, 7, 3}));
  const Motion carried = Compose(Affine(1.0), outer, still, {});
  ExpectNear(PlaceAt(carried, 1), glm::translate(Affine(1.0), {2, 7, 0}));
}

TEST(Motion, ACamerasFrameLooksBack) {
  Camera camera;
  camera.position = {1, 2, 3};
  camera.lookAt = {1, 2, -5};
  ExpectNear(FrameOf(camera), glm::translate(Affine(1.0), {1, 2, 3}));
  camera.motion = {{0, FrameOf(camera)}, {1, glm::translate(Affine(1.0), {3, 2, 3})}};
  ExpectNear(FrameAt(camera, 0.5), glm::translate(Affine(1.0), {2, 2, 3}));
}

}  // namespace
}  // namespace snell::scene
