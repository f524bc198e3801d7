// SPDX-License-Identifier: Apache-2.0
//
// Sessions: their finished picture is that of a render, bit for bit, whatever happened before; other views begin anew.
#include "api/session.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "api/render.h"

namespace snell {
namespace {

const std::string Gallery = SNELL_SOURCE_DIR "/scenes/gallery/";

RenderOptions SmallPicture(int spp) {
  RenderOptions options;
  options.width = 64;
  options.height = 48;
  options.spp = spp;
  options.device = "cpu";
  return options;
}

// Wait for the finished picture of a view; the pictures before it are put into `before`.
SessionPicture Finished(RenderSession& session, std::uint64_t view,
                        std::vector<SessionPicture>* before = nullptr) {
  for (int i = 0; i < 60000; ++i) {
    if (std::optional<SessionPicture> picture = session.Snapshot()) {
      if (picture->finished && picture->view == view) return *std::move(picture);
      if (before) before->push_back(*std::move(picture));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ADD_FAILURE() << "the session does not come to an end";
  return {};
}

class Sessions : public testing::TestWithParam<std::string> {};

TEST_P(Sessions, ShowWhatARenderGives) {
  const Scene scene = LoadScene(Gallery + GetParam());
  const RenderOptions options = SmallPicture(5);
  RenderSession session(scene, options);
  std::vector<SessionPicture> before;
  const SessionPicture picture = Finished(session, 0, &before);
  EXPECT_EQ(picture.samples, 5);
  EXPECT_EQ(picture.picture.width, 64);
  EXPECT_EQ(picture.picture.rgb, Render(scene, options).picture.rgb);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(before[i].picture.width < 64, before[i].samples == 0);
    if (i > 0) {
      EXPECT_TRUE(before[i - 1].samples < before[i].samples ||
                  before[i - 1].picture.width < before[i].picture.width);
    }
  }
}

TEST_P(Sessions, GoToAnotherViewAndBack) {
  const Scene scene = LoadScene(Gallery + GetParam());
  RenderOptions options = SmallPicture(2);
  RenderSession session(scene, options);
  CameraView view = session.view();
  view.position[0] += 0.5;
  view.fovDegrees *= 0.75;
  EXPECT_EQ(session.SetView(view), 1u);
  const SessionPicture picture = Finished(session, 1);
  options.cameraView = view;
  EXPECT_EQ(picture.picture.rgb, Render(scene, options).picture.rgb);
  EXPECT_NEAR(session.view().fovDegrees, view.fovDegrees, 1e-4);

  session.SetSize(50, 40);
  options.width = 50, options.height = 40;
  EXPECT_EQ(Finished(session, 2).picture.rgb, Render(scene, options).picture.rgb);
  EXPECT_EQ(session.fault(), "");
}

INSTANTIATE_TEST_SUITE_P(OfScenes, Sessions,
                         testing::Values("refraction.toml", "metals.toml", "motion_blur.toml"),
                         [](const auto& name) {
                           return name.param.substr(0, name.param.find('.'));
                         });

TEST(Session, RestsWhilePausedAndGoesOn) {
  RenderSession session(LoadScene(Gallery + "sphere.toml"), SmallPicture(100000));
  while (!session.Snapshot()) std::this_thread::yield();
  session.SetPaused(true);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  session.Snapshot();
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_FALSE(session.Snapshot());
  session.SetPaused(false);
  while (!session.Snapshot()) std::this_thread::yield();
}

TEST(Session, KnowsWhatTheEyeMeets) {
  const RenderSession session(LoadScene(Gallery + "sphere.toml"), SmallPicture(1));
  const CameraView view = session.view();
  const auto p = session.PointAt(0.5, 0.5);
  ASSERT_TRUE(p);
  // On the line of sight
  double along = 0, sight = 0, length = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double a = (*p)[i] - view.position[i], b = view.lookAt[i] - view.position[i];
    along += a * b, sight += b * b, length += a * a;
  }
  EXPECT_NEAR(along, std::sqrt(sight * length), 1e-4 * sight);
}

TEST(Session, RefusesWhatCannotBeSeen) {
  const Scene scene = LoadScene(Gallery + "sphere.toml");
  RenderOptions options = SmallPicture(1);
  options.camera = "none of this name";
  EXPECT_THROW(RenderSession(scene, options), Error);

  RenderSession session(scene, SmallPicture(1));
  CameraView view = session.view();
  view.lookAt = view.position;
  EXPECT_THROW(session.SetView(view), Error);
  EXPECT_THROW(session.SetSize(0, 5), Error);
  Finished(session, 0);  // and goes on
}

}  // namespace
}  // namespace snell
