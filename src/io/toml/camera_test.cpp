// SPDX-License-Identifier: Apache-2.0
//
// [camera]: lenses in the words of photographers, and what is wrong with cameras.
#include <gtest/gtest.h>

#include <cmath>

#include "io/toml/test_scene.h"

namespace snell::io {
namespace {

scene::Camera CameraOf(const std::string& keys) {
  TestScene scene("[camera]\nposition = [0, 0, 5]\n" + keys);
  const scene::Scene read = scene.Read();
  EXPECT_EQ(read.cameras.size(), 1u) << keys;
  return read.cameras.empty() ? scene::Camera() : read.cameras[0];
}

TEST(TomlCamera, TakesALensByItsFStop) {
  const scene::Camera camera = CameraOf("focal_length = 100\nsensor_height = 36\nf_stop = 4\n");
  EXPECT_FLOAT_EQ(camera.lens.radius, 0.0125f);
  EXPECT_FLOAT_EQ(camera.lens.focusDistance, 5) << "at look_at";
  EXPECT_FLOAT_EQ(camera.fov, 2 * std::atan(18.0f / 100));
  // 35 mm film is 36 mm wide
  const scene::Camera wide = CameraOf("horizontal_fov = 90\nf_stop = 2\n");
  EXPECT_EQ(wide.fovAxis, scene::FovAxis::Horizontal);
  EXPECT_FLOAT_EQ(wide.lens.radius, 0.0045f);
}

TEST(TomlCamera, FocusesOnAPointBesideTheLineOfSight) {
  const scene::Camera camera =
      CameraOf("direction = [0, 0, -3]\naperture_radius = 0.1\nfocus_at = [7, -2, 1]\n");
  EXPECT_FLOAT_EQ(camera.lens.focusDistance, 4);
  EXPECT_FLOAT_EQ(CameraOf("aperture_radius = 0.1\nfocus_distance = 3").lens.focusDistance, 3);
}

TEST(TomlCamera, ExplainsMistakes) {
  const struct {
    const char* text;
    const char* error;
  } mistakes[] = {
      {"[camera]\ndirection = [0, 0, -1]\nf_stop = 4",
       "1:1: nothing tells where the lens is in focus in [camera] (pinhole); give "
       "'focus_distance' or 'focus_at'"},
      {"[camera]\nf_stop = 4\nfocus_at = [0, 0, 9]",
       "3:12: 'focus_at' is not in front of the camera in [camera] (pinhole)"},
      {"[camera]\naperture_radius = 1\nblades = 2",
       "3:10: an aperture has 3 blades or more, or is round (0) in [camera] (pinhole)"},
      {"[camera]\nfov = 40\nfocal_length = 50",
       "3:1: 'fov' and 'focal_length' exclude each other in [camera] (pinhole)"},
      {"[camera]\ntype = \"panorama\"\nlongitude = [0, 400]",
       "3:13: 'longitude' needs two different angles, at most 360 degrees apart, in [camera] "
       "(panorama)"},
      {"[camera]\ntype = \"panorama\"\nlatitude = [30, 0]",
       "3:12: the first angle of 'latitude' must be the smaller one in [camera] (panorama)"},
      {"[camera]\ntype = \"fisheye\"\nprojection = \"stereographic\"\nfov = 360",
       "4:7: a stereographic fisheye sees less than 359 degrees in [camera] (fisheye)"}};
  for (const auto& [text, error] : mistakes)
    EXPECT_EQ(TestScene(text).Errors(),
              std::vector<std::string>{std::string("scene.toml:") + error})
        << text;
}

}  // namespace
}  // namespace snell::io
