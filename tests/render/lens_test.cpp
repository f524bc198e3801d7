// SPDX-License-Identifier: Apache-2.0
//
// Lenses, shifts, angles of view, panoramas and fisheyes against geometry.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "render/optics.h"
#include "render/scene_text.h"

namespace snell::test {
namespace {

constexpr double Pi = std::numbers::pi;

// A camera at the origin that looks along -z, with more keys, and a picture of one exact sample per pixel.
std::string Camera(int width, int height, std::string_view keys, int spp = 1) {
  return fmt::format(
      "[render]\nsize = [{}, {}]\nspp = {}\nfilter = 'box'\n{}max_depth = 1\n"
      "[camera]\nposition = [0, 0, 0]\n{}\n",
      width, height, spp, spp == 1 ? "filter_radius = 1e-6\n" : "", keys);
}

std::string GlowingDisk(double z, double radius) {
  return fmt::format(
      "[[object]]\nshape = 'disk'\ncenter = [0, 0, {}]\nnormal = [0, 0, 1]\nradius = {}\n"
      "material = {{ type = 'classic', emission = 1 }}\n",
      z, radius);
}

TEST(Lens, BlursAPointIntoItsCircleOfConfusion) {
  // A point at z, through a lens of radius R in focus at f: the shadow of the aperture in the plane at distance 1
  // has the radius R · |1/z − 1/f|
  constexpr int Size = 41;
  const double pixel = 2 * std::tan(15 * Pi / 180) / Size;
  for (const auto& [z, f] : {std::pair{4.0, 2.0}, {2.0, 4.0}, {3.0, 1e6}}) {
    const double lens = 13 * pixel / std::abs(1 / z - 1 / f);
    const double disk = pixel * z;
    for (const char* integrator : {"whitted", "path"}) {
      std::string scene =
          Camera(Size, Size,
                 fmt::format("look_at = [0, 0, -1]\nfov = 30\naperture_radius = {}\n"
                             "focus_distance = {}\n",
                             lens, f),
                 4096) +
          GlowingDisk(-z, disk);
      scene.insert(scene.find("spp"), fmt::format("integrator = '{}'\n", integrator));
      const Picture picture = PictureOf(scene);
      const double whole = Pi;  // pixels of the sharp disk
      EXPECT_NEAR(MeanOf(picture) * Size * Size, whole, 0.03 * whole);
      // Its edge is as soft as the disk is large
      double inner = 0, count = 0;
      for (int y = 0; y < Size; ++y) {
        for (int x = 0; x < Size; ++x) {
          const double r = std::hypot(x - 20, y - 20);
          const double value = PixelAt(picture, x, y).x;
          if (r > 15) {
            EXPECT_EQ(value, 0) << x << ' ' << y << ' ' << z;
          }
          if (r < 11) {
            inner += value;
            ++count;
          }
        }
      }
      EXPECT_NEAR(inner / count, whole / (Pi * 169), 0.04 * whole / (Pi * 169))
          << z << ' ' << integrator;
    }
  }
}

TEST(Lens, ABladedApertureShowsItsShape) {
  // The blur of a point beyond the focus is the aperture as seen from behind: a triangle with a corner on top
  constexpr int Size = 41;
  const double pixel = 2 * std::tan(15 * Pi / 180) / Size;
  const double lens = 18 * pixel / (1 - 0.25);
  const Picture picture = PictureOf(
      Camera(
          Size, Size,
          fmt::format("look_at = [0, 0, -1]\nfov = 30\naperture_radius = {}\nblades = 3\n", lens),
          4096) +
      GlowingDisk(-4, pixel * 4));
  // In the plane at distance 1: the corner is 18 pixels up, the opposite edge 9 down
  for (int y = 0; y < Size; ++y) {
    for (int x = 0; x < Size; ++x) {
      const double up = 20 - y, side = std::abs(x - 20);
      const double outside = std::max(-9 - up, side * std::cos(Pi / 6) - (18 - up) * 0.5);
      const bool isLit = PixelAt(picture, x, y).x > 0;
      if (std::abs(outside) > 2) {
        EXPECT_EQ(isLit, outside < 0) << x << ' ' << y;
      }
    }
  }
}

TEST(Lens, IsSharpInThePlaneOfFocus) {
  // An edge between pixels, in focus at look_at, by a distance, or by a point off the line of sight
  const std::string edge =
      "[[object]]\nshape = 'rectangle'\ncorner = [0, -9, -3]\nedge_u = [9, 0, 0]\nedge_v = [0, 18, "
      "0]\n"
      "material = { type = 'classic', emission = 1 }\n";
  for (const char* focus : {"look_at = [0, 0, -3]", "look_at = [0, 0, -1]\nfocus_distance = 3",
                            "direction = [0, 0, -2]\nfocus_at = [7, 8, -3]"}) {
    const Picture picture =
        PictureOf(Camera(16, 4, fmt::format("aperture_radius = 0.3\n{}\n", focus), 64) + edge);
    for (int x = 0; x < 16; ++x) EXPECT_EQ(PixelAt(picture, x, 1).x, x < 8 ? 0 : 1) << focus;
  }
}

TEST(Lens, AnFStopIsADiameter) {
  // 50 mm at f/2 over a sensor of 24 mm: a radius of 12.5 mm and an angle of 2 atan(12/50)
  const auto picture = [](const std::string& keys) {
    return PictureOf(Camera(24, 24, "look_at = [0, 0, -1]\nfocus_distance = 2\n" + keys, 16) +
                     GlowingDisk(-1, 0.1));
  };
  const double fov = 2 * std::atan(12.0 / 50) * 180 / Pi;
  const Picture wanted = picture(fmt::format("fov = {:.9}\naperture_radius = 0.0125\n", fov));
  EXPECT_GT(MeanOf(wanted), 0.01);
  EXPECT_LT(LargestDifference(picture("focal_length = 50\nf_stop = 2\n"), wanted), 0.07);
  EXPECT_LT(LargestDifference(picture(fmt::format("fov = {:.9}\nf_stop = 2\n", fov)), wanted),
            0.07);
}

TEST(Cameras, AnglesOfViewHaveThreeNames) {
  const auto picture = [](const std::string& keys) {
    return PictureOf(Camera(30, 20, "direction = [0.3, 0.5, -1]\n" + keys) + DirectionMeter);
  };
  const Picture wanted = picture("fov = 50\n");
  const double half = std::tan(25 * Pi / 180);
  const double across = 2 * std::atan(1.5 * half) * 180 / Pi;
  EXPECT_LT(LargestDifference(picture(fmt::format("horizontal_fov = {}\n", across)), wanted), 1e-6);
  EXPECT_LT(LargestDifference(
                picture(fmt::format("focal_length = {}\nsensor_height = 10\n", 5 / half)), wanted),
            1e-6);
}

TEST(Cameras, AShiftShowsAnotherPartOfThePlane) {
  for (const char* kind : {"fov = 50", "type = 'orthographic'\nheight = 3"}) {
    const std::string keys = fmt::format("direction = [0.3, 0.2, -1]\n{}\n", kind);
    const std::string ball =
        "[[object]]\nshape = 'sphere'\ncenter = [0.5, 0, -4]\nradius = 0.9\n"
        "material = { type = 'mirror' }\n";
    const auto picture = [&](const std::string& shift) {
      std::string scene = Camera(32, 20, keys + shift) + DirectionMeter + ball;
      return PictureOf(scene.replace(scene.find("max_depth = 1"), 13, "max_depth = 2"));
    };
    const Picture plain = picture("");
    const Picture shifted = picture("shift = [0.25, 0.1]\n");
    for (int y = 2; y < 20; ++y)
      for (int x = 0; x < 24; ++x)
        EXPECT_NEAR(PixelAt(shifted, x, y).x, PixelAt(plain, x + 8, y - 2).x, 2e-4)
            << x << ' ' << y;
  }
}

TEST(Cameras, APanoramasDirections) {
  const Picture picture =
      PictureOf(Camera(36, 18, "type = 'panorama'\ndirection = [0, 1, 0]\nup = [0, 0, 1]\n") +
                DirectionMeter);
  for (int y = 0; y < 18; ++y) {
    for (int x = 0; x < 36; ++x) {
      // The meter shows the part along the line of sight
      const double azimuth = ((x + 0.5) * 10 - 180) * Pi / 180;
      const double elevation = (90 - (y + 0.5) * 10) * Pi / 180;
      EXPECT_NEAR(PixelAt(picture, x, y).x,
                  MeterReading({0, std::cos(elevation) * std::cos(azimuth), 0}), 1e-6);
    }
  }
  const Picture part = PictureOf(
      Camera(9, 4,
             "type = 'panorama'\ndirection = [0, 1, 0]\nup = [0, 0, 1]\nlongitude = [-90, 0]\n"
             "latitude = [10, 50]\n") +
      DirectionMeter);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 9; ++x)
      EXPECT_NEAR(PixelAt(part, x, y).x, PixelAt(picture, x + 9, y + 4).x, 1e-6);
}

TEST(Cameras, AFisheyesDirections) {
  // Through the picture's corners, 220 degrees; else a circle of 90 degrees in a black picture
  for (const bool full : {false, true}) {
    const double half = (full ? 110 : 45) * Pi / 180;
    const double radius = full ? std::hypot(15, 10) : 10;  // pixels
    const Picture picture = PictureOf(
        Camera(30, 20,
               fmt::format("type = 'fisheye'\nprojection = 'equisolid'\nfov = {}\nframe = '{}'\n"
                           "direction = [0, 1, 0]\nup = [0, 0, 1]\n",
                           full ? 220 : 90, full ? "full" : "circular")) +
        DirectionMeter);
    for (int y = 0; y < 20; ++y) {
      for (int x = 0; x < 30; ++x) {
        const double r = std::hypot(x + 0.5 - 15, y + 0.5 - 10) / radius;
        const double angle = 2 * std::asin(std::min(r * std::sin(half / 2), 1.0));
        EXPECT_NEAR(PixelAt(picture, x, y).x, r > 1 ? 0 : MeterReading({0, std::cos(angle), 0}),
                    2e-6)
            << x << ' ' << y << ' ' << full;
      }
    }
  }
}

}  // namespace
}  // namespace snell::test
