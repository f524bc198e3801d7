// SPDX-License-Identifier: Apache-2.0
//
// From the text of a scene to its picture, through the public interface alone, and the numbers in it.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>

#include "api/snell.h"

namespace snell::test {

using glm::dvec3;

// The scene of a text in the native language. A warning fails the test, unless it is that of an empty scene.
Scene SceneOf(std::string_view text);

// Its picture, and what was counted on the way.
RenderResult RenderText(std::string_view text, const RenderOptions& options = {});
Picture PictureOf(std::string_view text, const RenderOptions& options = {});

inline dvec3 PixelAt(const Picture& picture, int x, int y) {
  const float* rgb =
      &picture.rgb[3 * (std::size_t(y) * std::size_t(picture.width) + std::size_t(x))];
  return {double(rgb[0]), double(rgb[1]), double(rgb[2])};
}

// The mean of one channel over the whole picture.
double MeanOf(const Picture& picture, int channel = 0);

// The largest difference of two pictures of the same size in any channel of any pixel.
double LargestDifference(const Picture& a, const Picture& b);

// A vector as scenes write it: "[1, 2, 3]".
std::string Toml(dvec3 v);

// A camera in double precision, and as a scene writes it.
struct View {
  int width = 32;
  int height = 32;
  bool orthographic = true;
  double extent = 2;  // the height of the view in metres, or the vertical angle in degrees
  dvec3 position{0, 0, 10};
  dvec3 direction{0, 0, -1};
  dvec3 up{0, 1, 0};

  // [render] and [camera]: one sample in the middle of each pixel, nothing cut off but by the depth.
  std::string Exact(int maxDepth) const;
  // The same with so many samples in each pixel's square.
  std::string Sampled(int spp, int maxDepth) const;

  // The ray through a point of the picture in pixels; the direction has unit length.
  dvec3 RayOrigin(double x, double y) const;
  dvec3 RayDirection(double x, double y) const;

  double PixelSize() const { return extent / height; }  // metres, orthographic

 private:
  std::string Write(int spp, int maxDepth, std::string_view filter) const;
  dvec3 InPlane(double x, double y) const;
};

// A view of the floor from above: x to the right and −z up in the picture, its middle at the origin.
View FromAbove(int width, int height, double extent);

}  // namespace snell::test
