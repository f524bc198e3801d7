// SPDX-License-Identifier: Apache-2.0
//
// Snell's public interface: pictures. Installed as <snell/api/picture.h>.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "../util/error.h"

namespace snell {

// What a picture holds besides its colours: the channels X, Y and Z of "normal", say, interleaved as those are.
struct PictureLayer {
  std::string name;
  std::vector<std::string> channels;
  bool isColor = false;  // half floats suffice
  std::vector<float> values;
};

// Linear Rec.709 radiance, three floats a pixel, rows from top to bottom.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<float> rgb;
  std::vector<PictureLayer> layers;  // EXR alone has room for them; they are not read
  std::vector<std::pair<std::string, std::string>> layerMetadata;
};

// How to write a picture; the extension names the format.
struct PictureOptions {
  int bits = 8;               // PNG: 8 or 16
  bool exrFloat = false;      // EXR: 32-bit float instead of half
  float exposure = 0;         // stops, for PNG and JPEG; EXR and HDR stay linear
  std::string view = "srgb";  // of the same (docs/views.md)
  int jpegQuality = 95;
  std::vector<std::pair<std::string, std::string>> metadata;
};

// The picture as a PNG of 8 bits with these options holds it: three bytes a pixel. Throws Error.
SNELL_EXPORT std::vector<std::uint8_t> DisplayBytes(const Picture& picture,
                                                    const PictureOptions& options = {});

// Write atomically: the file appears when it is complete. Throws Error.
SNELL_EXPORT void WritePicture(const std::filesystem::path& path, const Picture& picture,
                               const PictureOptions& options = {});
// Throws the Error that WritePicture would throw, as far as it can be known before.
SNELL_EXPORT void CheckPictureWritable(const std::filesystem::path& path,
                                       const PictureOptions& options = {});
// "png, jpg, jpeg, hdr, exr", for messages.
SNELL_EXPORT std::string KnownPictureExtensions();

// The names of views, for messages.
SNELL_EXPORT std::vector<std::string> KnownViews();

// Read PNG, JPEG, EXR or HDR, by content. Throws Error.
SNELL_EXPORT Picture ReadPicture(const std::filesystem::path& path);

// What an EXR holds: its channels with their types, "half", "float" or "uint".
struct PictureInfo {
  int width = 0;
  int height = 0;
  std::vector<std::pair<std::string, std::string>> channels;
};

// Reads the header alone. Throws Error.
SNELL_EXPORT PictureInfo InspectPicture(const std::filesystem::path& path);
// The pixels [x0, x1) × [y0, y1) of a picture, from the top left. Throws Error if they are not within it.
SNELL_EXPORT Picture CropPicture(const Picture& picture, const std::array<int, 4>& crop);

// How far a picture is from a reference of the same size: RMSE, relMSE and the largest difference in linear
// radiance; PSNR and FLIP (Andersson et al. 2020) of the pictures as displayed.
struct PictureDifference {
  double rmse = 0;
  double relMse = 0;  // mean of (a − b)² / (a² + 0.01)
  double psnr = 0;    // dB for a peak of 1; infinite for equal pictures
  double maxAbs = 0;
  double meanFlip = 0;       // 0 equal … 1
  double meanReference = 0;  // linear, of all channels
  double meanTest = 0;
};

// Throws Error if the sizes differ.
SNELL_EXPORT PictureDifference ComparePictures(const Picture& reference, const Picture& test);
// The FLIP error of each pixel in false colours.
SNELL_EXPORT Picture DifferencePicture(const Picture& reference, const Picture& test);

}  // namespace snell
