// SPDX-License-Identifier: Apache-2.0
#include "viewer/view_control.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace snell::viewer {
namespace {

using Point = std::array<double, 3>;

CameraView Start() {
  CameraView view;
  view.position = {0, 0, 5};
  view.lookAt = {0, 0, 1};
  view.fovDegrees = 90;
  return view;
}

void ExpectNear(const Point& a, const Point& b) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-9) << "axis " << i;
}

double Distance(const CameraView& view) {
  double squares = 0;
  for (std::size_t i = 0; i < 3; ++i)
    squares += (view.position[i] - view.lookAt[i]) * (view.position[i] - view.lookAt[i]);
  return std::sqrt(squares);
}

TEST(ViewControl, OrbitsAroundWhatIsLookedAt) {
  const CameraView right = Orbit(Start(), std::numbers::pi / 2, 0);
  ExpectNear(right.position, {4, 0, 1});
  ExpectNear(right.lookAt, Start().lookAt);
  const CameraView up = Orbit(Start(), 0, std::numbers::pi / 6);
  ExpectNear(up.position, {0, 2, 1 + std::sqrt(12.0)});
}

TEST(ViewControl, OrbitsBackTheWayItCame) {
  CameraView view = Orbit(Start(), 0.3, 0.4);
  view = Orbit(Orbit(view, 1, -0.2), -1, 0.2);
  ExpectNear(view.position, Orbit(Start(), 0.3, 0.4).position);
}

TEST(ViewControl, StaysOffThePoles) {
  for (const double up : {10.0, -10.0}) {
    const CameraView view = Orbit(Start(), 0.5, up);
    EXPECT_NEAR(Distance(view), 4, 1e-9);
    EXPECT_GT(std::hypot(view.position[0], view.position[2] - 1), 0.03);
    EXPECT_EQ(view.position[1] > 0, up > 0);
    // And comes back
    EXPECT_LT(std::abs(Orbit(view, 0, -up / 10).position[1]), 3);
  }
}

TEST(ViewControl, LooksAroundInPlace) {
  const CameraView right = Look(Start(), std::numbers::pi / 2, 0);
  ExpectNear(right.position, Start().position);
  ExpectNear(right.lookAt, {4, 0, 5});
  EXPECT_GT(Look(Start(), 0, 0.2).lookAt[1], 0);
}

TEST(ViewControl, PansByThePicturesHeight) {
  const CameraView view = Pan(Start(), 0.5, 1);  // the height is 8 at 4 metres
  ExpectNear(view.position, {4, 8, 5});
  ExpectNear(view.lookAt, {4, 8, 1});
}

TEST(ViewControl, DolliesToAndFro) {
  ExpectNear(Dolly(Start(), 0.5).position, {0, 0, 3});
  ExpectNear(Dolly(Dolly(Start(), 0.5), 2).position, Start().position);
}

TEST(ViewControl, FliesByItsDistance) {
  const CameraView view = Fly(Start(), 0.25, 0.5, 1);
  ExpectNear(view.position, {1, 2, 1});
  ExpectNear(view.lookAt, {1, 2, -3});
}

TEST(ViewControl, FocusesWhatItCan) {
  ExpectNear(Focus(Start(), {1, 1, 1}).lookAt, {1, 1, 1});
  ExpectNear(Focus(Start(), {1, 1, 1}).position, Start().position);
  ExpectNear(Focus(Start(), {0, 7, 5}).lookAt, Start().lookAt);  // straight above
  ExpectNear(Focus(Start(), {0, 0, 5}).lookAt, Start().lookAt);  // the eye itself
}

}  // namespace
}  // namespace snell::viewer
