// SPDX-License-Identifier: Apache-2.0
//
// Cameras, transforms and handedness: where points of pbrt's world come out in the picture.
#include <gtest/gtest.h>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "io/pbrt/test_scene.h"
#include "scene/motion.h"

namespace snell::io {
namespace {

constexpr double Degree = std::numbers::pi / 180;

// Where the camera shows a point: right and up, in halves of the picture's height.
glm::dvec2 Shown(const scene::Scene& scene, const glm::dvec3& point) {
  const scene::Camera& camera = scene.cameras.at(0);
  const glm::dvec3 forward =
      glm::normalize(glm::dvec3(camera.lookAt) - glm::dvec3(camera.position));
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(camera.up)));
  const glm::dvec3 up = glm::cross(right, forward);
  const glm::dvec3 d = point - glm::dvec3(camera.position);
  if (camera.kind == scene::CameraKind::Orthographic)
    return glm::dvec2(glm::dot(d, right), glm::dot(d, up)) * (2 / double(camera.height));
  return glm::dvec2(glm::dot(d, right), glm::dot(d, up)) /
         (glm::dot(d, forward) * std::tan(double(camera.fov) / 2));
}

// What pbrt shows of a point, by the transform from its world to the camera, whose x is right, y up, z forward.
glm::dvec2 Expected(const scene::Affine& cameraFromWorld, const glm::dvec3& point, double fov) {
  const glm::dvec3 p(cameraFromWorld * glm::dvec4(point, 1));
  return glm::dvec2(p) / (p.z * std::tan(fov / 2));
}

TEST(PbrtView, PicturesAreNotMirrored) {
  // Seen from -z, +x is to the right; mirrored by hand, to the left
  const scene::Affine eye = glm::translate(scene::Affine(1.0), {0, 0, 10});
  const scene::Affine flip = glm::scale(scene::Affine(1.0), {-1, 1, 1});
  const scene::Affine turn = glm::rotate(scene::Affine(1.0), 0.7, glm::dvec3(0.6, 0.8, 0));
  const struct {
    const char* text;
    scene::Affine cameraFromWorld;
  } cases[] = {{"LookAt 0 0 -10  0 0 0  0 1 0", eye},
               {"Scale -1 1 1 LookAt 0 0 -10  0 0 0  0 1 0", flip * eye},
               {"LookAt 0 0 -10  0 0 0  0 1 0 Scale -1 1 1", eye * flip},
               {"Translate 0 0 10 Rotate 40.10704565915762 0.6 0.8 0", eye * turn},
               {"Transform [ -1 0 0 0  0 1 0 0  0 0 1 0  0 0 10 1 ]", eye * flip}};
  for (const auto& [text, cameraFromWorld] : cases) {
    PbrtTestScene file;
    const scene::Scene scene = file.Read(
        std::string(text) +
        " Camera \"perspective\" \"float fov\" 40 Film \"rgb\" \"integer xresolution\" 300 "
        "\"integer yresolution\" 200 WorldBegin LightSource \"point\" \"point3 from\" [ 1 2 0.5 ] "
        "Translate 1 2 0.5 Shape \"sphere\" \"float radius\" 0.1");
    ASSERT_EQ(scene.objects.size(), 1u) << file.error;
    const glm::dvec2 expected = Expected(cameraFromWorld, {1, 2, 0.5}, 40 * Degree);
    const glm::dvec2 shown = Shown(scene, glm::dvec3(scene.objects[0].toWorld[3]));
    EXPECT_NEAR(shown.x, expected.x, 1e-5) << text;
    EXPECT_NEAR(shown.y, expected.y, 1e-5) << text;
    EXPECT_EQ(glm::dvec3(scene.lights[0].position), glm::dvec3(scene.objects[0].toWorld[3]));
  }
  EXPECT_GT(Expected(eye, {1, 2, 0.5}, 1).x, 0);
}

scene::Camera CameraOf(const std::string& text, int width, int height) {
  PbrtTestScene file;
  const scene::Scene scene =
      file.Read("Film \"rgb\" \"integer xresolution\" " + std::to_string(width) +
                " \"integer yresolution\" " + std::to_string(height) + "\n" + text +
                "\nWorldBegin LightSource \"point\" Shape \"sphere\"");
  EXPECT_EQ(file.error, "");
  EXPECT_EQ(scene.settings.width, width);
  EXPECT_EQ(scene.settings.height, height);
  return scene.cameras.empty() ? scene::Camera() : scene.cameras[0];
}

TEST(PbrtView, TheFieldOfViewSpansTheShorterSide) {
  const double half = std::tan(20 * Degree);
  const std::string camera = "Camera \"perspective\" \"float fov\" 40";
  EXPECT_NEAR(std::tan(CameraOf(camera, 400, 200).fov / 2), half, 1e-5);
  EXPECT_NEAR(std::tan(CameraOf(camera, 200, 400).fov / 2), 2 * half, 1e-5);
  const std::string window = camera + " \"float screenwindow\" [ -1 1 -0.75 0.75 ]";
  EXPECT_NEAR(std::tan(CameraOf(window, 320, 240).fov / 2), 0.75 * half, 1e-5);
}

TEST(PbrtView, OrthographicCamerasShowTheirWindow) {
  const scene::Camera camera = CameraOf("Camera \"orthographic\"", 200, 400);
  EXPECT_EQ(camera.kind, scene::CameraKind::Orthographic);
  EXPECT_NEAR(camera.height, 4, 1e-5);
  EXPECT_NEAR(CameraOf("Scale 0.5 0.5 0.5 Camera \"orthographic\"", 200, 200).height, 4, 1e-5);
}

TEST(PbrtView, LensesKeepTheirSizeInTheWorld) {
  const std::string lens = " \"float lensradius\" 0.5 \"float focaldistance\" 7";
  const scene::Camera plain = CameraOf("Camera \"perspective\"" + lens, 200, 200);
  EXPECT_FLOAT_EQ(plain.lens.radius, 0.5f);
  EXPECT_FLOAT_EQ(plain.lens.focusDistance, 7);
  // The world is twice the camera's
  const scene::Camera scaled =
      CameraOf("Scale 0.5 0.5 0.5 Camera \"orthographic\"" + lens, 200, 200);
  EXPECT_FLOAT_EQ(scaled.lens.radius, 1);
  EXPECT_FLOAT_EQ(scaled.lens.focusDistance, 14);
}

TEST(PbrtView, WindowsOffTheLineOfSightAreShifts) {
  const scene::Camera camera =
      CameraOf("Camera \"perspective\" \"float screenwindow\" [ 0 2 -0.5 1.5 ]", 300, 300);
  EXPECT_FLOAT_EQ(camera.shift.x, 0.5f);
  EXPECT_FLOAT_EQ(camera.shift.y, 0.25f);
}

TEST(PbrtView, SphericalCamerasLookAllAround) {
  // pbrt begins on the camera's right and goes by its front to the left
  const scene::Camera camera =
      CameraOf("Camera \"spherical\" \"string mapping\" \"equirectangular\"", 400, 200);
  EXPECT_EQ(camera.kind, scene::CameraKind::Panorama);
  EXPECT_NEAR(camera.longitude.x, 90 * Degree, 1e-6);
  EXPECT_NEAR(camera.longitude.y, -270 * Degree, 1e-6);
}

TEST(PbrtView, MovementIsFromStartToEnd) {
  PbrtTestScene file;
  const scene::Scene scene = file.Read(
      "TransformTimes 1 3 LookAt 0 0 -5 0 0 0 0 1 0 ActiveTransform EndTime Translate -2 0 0 "
      "ActiveTransform All Camera \"perspective\" \"float shutteropen\" 1 \"float shutterclose\" 2 "
      "WorldBegin LightSource \"point\" ObjectBegin \"a\" Shape \"sphere\" ObjectEnd "
      "AttributeBegin ActiveTransform EndTime Translate 0 4 0 Shape \"sphere\" ActiveTransform All "
      "Translate 0 0 1 ObjectInstance \"a\" AttributeEnd Shape \"sphere\"");
  EXPECT_EQ(file.error, "");
  ASSERT_EQ(scene.cameras.size(), 1u);
  const scene::Camera& camera = scene.cameras[0];
  EXPECT_EQ(camera.shutterOpen, 1);
  EXPECT_EQ(camera.shutterClose, 2);
  ASSERT_EQ(camera.motion.size(), 2u);
  // The frame at the start is the camera's own; the world moves left, so the camera moves right
  const scene::Affine own = scene::FrameOf(camera);
  for (int i = 0; i < 4; ++i) EXPECT_LT(glm::length(camera.motion[0].place[i] - own[i]), 1e-6) << i;
  EXPECT_LT(glm::length(camera.motion[1].place[3] - own[3] - glm::dvec4(2, 0, 0, 0)), 1e-6);
  ASSERT_EQ(scene.objects.size(), 3u);
  for (int i = 0; i < 2; ++i) {
    const scene::Motion& motion = scene.objects[std::size_t(i)].motion;
    ASSERT_EQ(motion.size(), 2u);
    EXPECT_EQ(motion[0].time, 1);
    EXPECT_EQ(motion[1].time, 3);
    EXPECT_EQ(motion[0].place, scene.objects[std::size_t(i)].toWorld);
    EXPECT_EQ(motion[1].place[3] - motion[0].place[3], glm::dvec4(0, 4, 0, 0));
  }
  EXPECT_TRUE(scene.objects[2].motion.empty());
}

TEST(PbrtView, OtherCamerasAreApproximated) {
  PbrtTestScene file;
  file.Read("Camera \"realistic\" WorldBegin LightSource \"point\" Shape \"sphere\"");
  EXPECT_TRUE(file.Warned("'realistic' camera approximated by a perspective one"));
  file.Read("Camera \"spherical\" WorldBegin LightSource \"point\" Shape \"sphere\"");
  EXPECT_TRUE(file.Warned("equal-area camera approximated by an equirectangular one"));
}

TEST(PbrtView, SettingsAreRead) {
  PbrtTestScene file;
  const scene::Scene scene = file.Read(
      "Sampler \"stratified\" \"integer xsamples\" 3 \"integer ysamples\" 5\n"
      "PixelFilter \"triangle\" \"float xradius\" 2 \"float yradius\" 2\n"
      "Integrator \"volpath\" \"integer maxdepth\" 7 Option \"seed\" 12\n"
      "Film \"rgb\" \"float iso\" 400 WorldBegin LightSource \"point\" Shape \"sphere\"");
  EXPECT_EQ(file.error, "");
  EXPECT_EQ(scene.settings.spp, 15);
  EXPECT_EQ(scene.settings.maxDepth, 8);
  EXPECT_EQ(scene.settings.seed, 12u);
  EXPECT_EQ(scene.settings.filter, scene::PixelFilter::Tent);
  EXPECT_EQ(scene.settings.filterRadius, 2);
  EXPECT_FLOAT_EQ(scene.settings.exposure, 2);
  EXPECT_TRUE(scene.cameras.empty());
}

// Where a point (1, 2, 3) of a shape comes to lie in pbrt's world.
glm::dvec3 Moved(const std::string& statements) {
  PbrtTestScene file;
  const scene::Scene scene = file.Read("WorldBegin " + statements +
                                       " LightSource \"point\" Shape \"trianglemesh\" "
                                       "\"point3 P\" [ 1 2 3  2 2 3  1 3 3 ]");
  EXPECT_EQ(file.error, "");
  if (scene.objects.empty()) return glm::dvec3(0.0);
  const glm::dvec3 p(scene.objects[0].toWorld *
                     glm::dvec4(glm::dvec3(scene.meshes[0].positions[0]), 1));
  return {p.x, p.y, -p.z};
}

void ExpectNear(const glm::dvec3& value, const glm::dvec3& expected) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(value[i], expected[i], 1e-9);
}

TEST(PbrtView, TransformsMultiplyFromTheRight) {
  ExpectNear(Moved("Translate 1 0 0 Scale 2 2 2"), {3, 4, 6});
  ExpectNear(Moved("Scale 2 2 2 Translate 1 0 0"), {4, 4, 6});
  ExpectNear(Moved("Rotate 90 0 0 1"), {-2, 1, 3});
  ExpectNear(Moved("Translate 5 5 5 Identity"), {1, 2, 3});
  ExpectNear(Moved("Transform [ 1 0 0 0  0 1 0 0  0 0 1 0  7 8 9 1 ]"), {8, 10, 12});
  ExpectNear(Moved("Scale 2 2 2 ConcatTransform [ 1 0 0 0 0 1 0 0 0 0 1 0 7 8 9 1 ]"),
             {16, 20, 24});
  ExpectNear(Moved("Translate 1 0 0 CoordinateSystem \"a\" Identity CoordSysTransform \"a\""),
             {2, 2, 3});
  ExpectNear(Moved("AttributeBegin Scale 3 3 3 AttributeEnd"), {1, 2, 3});
  ExpectNear(Moved("TransformBegin Scale 3 3 3 TransformEnd"), {1, 2, 3});
  ExpectNear(Moved("ActiveTransform EndTime Translate 9 9 9 ActiveTransform All Translate 1 0 0"),
             {2, 2, 3});
  ExpectNear(Moved("LookAt 0 0 -5 0 0 0 0 1 0"), {1, 2, 8});
}

}  // namespace
}  // namespace snell::io
