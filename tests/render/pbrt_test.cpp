// SPDX-License-Identifier: Apache-2.0
//
// Pictures of pbrt scenes: nothing is mirrored, and light has the strength that pbrt gives it.
#include <gtest/gtest.h>

#include <numbers>

#include "render/scene_text.h"
#include "support/scratch_folder.h"

namespace snell::test {
namespace {

Picture PictureOfPbrt(const std::string& text) {
  const ScratchFolder folder;
  folder.Write("scene.pbrt",
               "Film \"rgb\" \"integer xresolution\" 30 \"integer yresolution\" 20\n"
               "Sampler \"independent\" \"integer pixelsamples\" 4\n" +
                   text);
  return Render(LoadScene(folder.Path("scene.pbrt")), {}).picture;
}

// A red ball at +x, a green one at +y, a blue one at +z, which all glow.
const std::string Balls =
    "Camera \"orthographic\" \"float screenwindow\" [ -3 3 -2 2 ] WorldBegin\n"
    "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [ 1 0 0 ]\n"
    "Translate 1.5 0 0 Shape \"sphere\" \"float radius\" 0.5 AttributeEnd\n"
    "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [ 0 1 0 ]\n"
    "Translate 0 1.5 0 Shape \"sphere\" \"float radius\" 0.5 AttributeEnd\n"
    "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [ 0 0 1 ]\n"
    "Translate 0 0 1.5 Shape \"sphere\" \"float radius\" 0.5 AttributeEnd\n";

constexpr int Right = 22, Left = 7, Middle = 15;  // of 30 pixels
constexpr int Top = 2, Center = 10;               // of 20

// In pbrt's left-handed world, x is to the right and y up for who looks along z.
TEST(Pbrt, WhoLooksAlongZHasXOnTheRight) {
  const Picture picture = PictureOfPbrt("LookAt 0 0 -9  0 0 0  0 1 0\n" + Balls);
  EXPECT_NEAR(PixelAt(picture, Right, Center).x, 1, 1e-4);
  EXPECT_EQ(PixelAt(picture, Left, Center).x, 0);
  EXPECT_NEAR(PixelAt(picture, Middle, Top).y, 1, 1e-4);
}

TEST(Pbrt, WhoLooksAlongXHasZOnTheLeft) {
  const Picture picture = PictureOfPbrt("LookAt -9 0 0  0 0 0  0 1 0\n" + Balls);
  EXPECT_NEAR(PixelAt(picture, Left, Center).z, 1, 1e-4);
  EXPECT_EQ(PixelAt(picture, Right, Center).z, 0);
}

TEST(Pbrt, AMirrorBeforeTheCameraMirrorsThePicture) {
  const Picture picture = PictureOfPbrt("Scale -1 1 1 LookAt 0 0 -9  0 0 0  0 1 0\n" + Balls);
  EXPECT_NEAR(PixelAt(picture, Left, Center).x, 1, 1e-4);
  EXPECT_EQ(PixelAt(picture, Right, Center).x, 0);
}

// What a white floor sends back right below a light.
double Floor(const std::string& light) {
  const Picture picture = PictureOfPbrt(
      "LookAt 0 0 -2  0 0 0  0 1 0 Camera \"orthographic\" \"float screenwindow\" "
      "[ -0.03 0.03 -0.02 0.02 ] WorldBegin Material \"diffuse\" \"rgb reflectance\" [ 1 1 1 ]\n"
      "Shape \"trianglemesh\" \"integer indices\" [ 0 1 2 0 2 3 ] "
      "\"point3 P\" [ -9 -9 0  -9 9 0  9 9 0  9 -9 0 ]\n" +
      light);
  return PixelAt(picture, Middle, Center).x;
}

TEST(Pbrt, LightHasItsUnits) {
  constexpr double Pi = std::numbers::pi;
  EXPECT_NEAR(Floor("LightSource \"distant\" \"rgb L\" [ 2 2 2 ]"), 2 / Pi, 1e-3);
  EXPECT_NEAR(Floor("Translate 0 0 -4 LightSource \"point\" \"rgb I\" [ 8 8 8 ]"), 0.5 / Pi, 1e-3);
  EXPECT_NEAR(Floor("LightSource \"infinite\" \"rgb L\" [ 0.5 0.5 0.5 ]"), 0.5, 1e-3);
  // A small disk of radiance L and area A at distance d: L A / (π d²)
  EXPECT_NEAR(Floor("AreaLightSource \"diffuse\" \"rgb L\" [ 100 100 100 ] Translate 0 0 -4 "
                    "Shape \"disk\" \"float radius\" 0.1"),
              100 * 0.01 / 16, 1e-3);
  // It shines to one side
  EXPECT_EQ(Floor("AreaLightSource \"diffuse\" \"rgb L\" [ 100 100 100 ] Translate 0 0 -4 "
                  "ReverseOrientation Shape \"disk\" \"float radius\" 0.1"),
            0);
}

}  // namespace
}  // namespace snell::test
