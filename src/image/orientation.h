// SPDX-License-Identifier: Apache-2.0
//
// Which way a stored picture is to be turned: the eight orientations of Exif (tag 0x0112, Exif 2.32
// §4.6.4) and of Radiance's resolution line.
#pragma once

#include <string_view>

#include "image/image.h"

namespace snell::image {

// How to get from the stored rows to the picture: first mirror the stored rows and columns, then, if
// `transpose` is set, swap x and y.
struct Orientation {
  bool flipX = false;
  bool flipY = false;
  bool transpose = false;
};

// The orientation that a TIFF structure (the body of an Exif block) holds; upright if it holds none or
// is damaged.
Orientation ExifOrientation(std::string_view tiff);

// The picture that stored rows mean.
Image Upright(Image stored, const Orientation& orientation);

}  // namespace snell::image
