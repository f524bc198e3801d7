// SPDX-License-Identifier: Apache-2.0
#include "api/picture.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "api/film_picture.h"
#include "image/codec.h"
#include "image/color.h"
#include "image/compare.h"
#include "image/read.h"
#include "image/write.h"
#include "util/check.h"
#include "util/threads.h"

namespace snell {

static image::Image ToImage(const Picture& picture) {
  image::Image image(picture.width, picture.height);
  CHECK(picture.rgb.size() == image.pixels.size() * 3);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = {picture.rgb[3 * i], picture.rgb[3 * i + 1], picture.rgb[3 * i + 2]};
  return image;
}

static image::View ViewNamed(const std::string& name) {
  for (const auto& [known, view] : image::ViewNames()) {
    if (known == name) return view;
  }
  throw Error(fmt::format("there is no view '{}'", name), {},
              fmt::format("the views are: {}", fmt::join(KnownViews(), ", ")));
}

static image::WriteOptions ToWriteOptions(const PictureOptions& options) {
  image::WriteOptions write;
  write.bits = options.bits;
  write.exrFloat = options.exrFloat;
  write.exposure = options.exposure;
  write.view = ViewNamed(options.view);
  write.jpegQuality = options.jpegQuality;
  write.metadata = options.metadata;
  return write;
}

std::vector<std::uint8_t> DisplayBytes(const Picture& picture, const PictureOptions& options) {
  const image::WriteOptions write = ToWriteOptions(options);
  CHECK(picture.rgb.size() == std::size_t(picture.width) * std::size_t(picture.height) * 3);
  std::vector<std::uint8_t> bytes(picture.rgb.size());
  const std::size_t rowSize = 3 * std::size_t(picture.width);
  ParallelInOrder(std::uint64_t(picture.height), [&](std::uint64_t y, int) {
    for (std::size_t i = y * rowSize; i < (y + 1) * rowSize; i += 3) {
      const kernel::vec3 color =
          image::DisplayColor({picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]}, write);
      for (int c = 0; c < 3; ++c) bytes[i + std::size_t(c)] = image::Quantize8(color[c]);
    }
  });
  return bytes;
}

void WritePicture(const std::filesystem::path& path, const Picture& picture,
                  const PictureOptions& options) {
  image::Layers layers;
  layers.metadata = picture.layerMetadata;
  for (const PictureLayer& layer : picture.layers)
    layers.layers.push_back({layer.name, layer.channels, layer.isColor, layer.values});
  image::WriteOptions write = ToWriteOptions(options);
  write.layers = &layers;
  image::WriteImage(path, ToImage(picture), write);
}

void CheckPictureWritable(const std::filesystem::path& path, const PictureOptions& options) {
  image::CheckWritable(path, ToWriteOptions(options));
}

std::vector<std::string> KnownViews() {
  std::vector<std::string> names;
  for (const auto& [name, view] : image::ViewNames()) names.push_back(name);
  return names;
}

std::string KnownPictureExtensions() { return image::KnownWriteExtensions(); }

Picture ReadPicture(const std::filesystem::path& path) { return ToPicture(image::ReadImage(path)); }

PictureInfo InspectPicture(const std::filesystem::path& path) {
  const image::ExrSummary summary = image::SummarizeExr(path);
  return {summary.width, summary.height, summary.channels};
}

Picture CropPicture(const Picture& picture, const std::array<int, 4>& crop) {
  const auto [x0, y0, x1, y1] = crop;
  if (x0 < 0 || y0 < 0 || x1 > picture.width || y1 > picture.height || x0 >= x1 || y0 >= y1)
    throw Error(fmt::format("the crop {},{},{},{} is empty or outside the picture of {}×{} pixels",
                            x0, y0, x1, y1, picture.width, picture.height));
  Picture part{x1 - x0, y1 - y0, {}, {}, {}};
  for (int y = y0; y < y1; ++y) {
    const auto row = picture.rgb.begin() + 3 * (std::ptrdiff_t(y) * picture.width + x0);
    part.rgb.insert(part.rgb.end(), row, row + 3 * std::ptrdiff_t(part.width));
  }
  return part;
}

PictureDifference ComparePictures(const Picture& reference, const Picture& test) {
  const image::Comparison c = image::Compare(ToImage(reference), ToImage(test));
  return {c.rmse, c.relMse, c.psnr, c.maxAbs, c.meanFlip, c.meanReference, c.meanTest};
}

Picture DifferencePicture(const Picture& reference, const Picture& test) {
  return ToPicture(image::DifferenceImage(ToImage(reference), ToImage(test)));
}

}  // namespace snell
