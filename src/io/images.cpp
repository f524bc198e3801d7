// SPDX-License-Identifier: Apache-2.0
#include "io/images.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <new>
#include <optional>
#include <stdexcept>

#include "image/color.h"
#include "image/read.h"
#include "io/mesh/text.h"
#include "util/file.h"

namespace snell::io {

namespace fs = std::filesystem;

namespace {

// Missing files that are told one by one.
constexpr int MaxWarnings = 32;

bool IsByte(float value) { return float(image::Quantize8(value)) / 255.0f == value; }

// Whether all numbers are those of 8-bit files, so that bytes lose nothing.
bool FitsBytes(const image::Image& picture) {
  return std::all_of(picture.pixels.begin(), picture.pixels.end(),
                     [](const auto& p) { return IsByte(p.x) && IsByte(p.y) && IsByte(p.z); }) &&
         std::all_of(picture.alpha.begin(), picture.alpha.end(), IsByte);
}

// PNG, JPEG and WebP; the others are linear whatever they are used for.
bool HasCodes(std::string_view bytes) {
  return bytes.starts_with("\x89PNG") || bytes.starts_with("\xff\xd8") ||
         (bytes.starts_with("RIFF") && bytes.substr(0, 12).ends_with("WEBP"));
}

void StoreFloats(const image::Image& picture, ImageUse use, scene::Image& texels) {
  texels.floats.resize(picture.pixels.size() * 4);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    image::vec3 color = image::FiniteOrZero(
        picture.HasAlpha() && picture.premultiplied ? picture.Straight(i) : picture.pixels[i]);
    if (use == ImageUse::Color) color = glm::max(color, image::vec3(0.0f));
    for (int c = 0; c < 3; ++c) texels.floats[i * 4 + std::size_t(c)] = color[c];
    const float alpha = picture.HasAlpha() ? picture.alpha[i] : 1.0f;
    texels.floats[i * 4 + 3] = std::isfinite(alpha) ? std::clamp(alpha, 0.0f, 1.0f) : 1.0f;
  }
}

// As bytes, four channels each; alpha is 255 where the picture has none.
std::vector<std::uint8_t> ByteTexels(const image::Image& picture) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(picture.pixels.size() * 4);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    for (int c = 0; c < 3; ++c) bytes.push_back(image::Quantize8(picture.pixels[i][c]));
    bytes.push_back(picture.HasAlpha() ? image::Quantize8(picture.alpha[i]) : 255);
  }
  return bytes;
}

// How to decode a picture whose numbers are wanted as they are.
image::ReadOptions RawPictures(const ReadLimits& limits) {
  return {.colorSpace = image::ColorSpace::Raw,
          .limits = {.pixels = limits.picturePixels,
                     .fileBytes = limits.fileBytes,
                     .pixelHint = LiftedBy(&ReadLimits::picturePixels)}};
}

}  // namespace

scene::Image DecodeTexels(std::string_view bytes, const std::string& name, ImageUse use,
                          const ReadLimits& limits) {
  try {
    scene::Image texels;
    texels.name = name;
    image::Image picture = image::DecodeImage(bytes, name, RawPictures(limits));
    texels.width = picture.width;
    texels.height = picture.height;
    const bool hasCodes = HasCodes(bytes);
    if (hasCodes && FitsBytes(picture)) {
      texels.srgb = use == ImageUse::Color;
      texels.bytes = ByteTexels(picture);
      return texels;
    }
    if (hasCodes && use == ImageUse::Color)
      for (image::vec3& pixel : picture.pixels) pixel = image::DecodeSrgb(pixel);
    StoreFloats(picture, use, texels);
    return texels;
  } catch (const std::bad_alloc&) {
    throw Error("there is not enough memory for the picture", {name});
  } catch (const std::length_error&) {
    throw Error("there is not enough memory for the picture", {name});
  }
}

ImageLoader::ImageLoader(std::vector<fs::path> roots, WarningSink warn, ReadLimits limits)
    : finder_(std::move(roots)), warn_(std::move(warn)), limits_(limits) {}

scene::ImageIndex ImageLoader::Load(scene::Scene& scene, std::string_view name, ImageUse use,
                                    const Place& place, const fs::path& folder) {
  const fs::path& from = folder.empty() ? finder_.root() : folder;
  const auto [entry, isNew] = named_.try_emplace({from.string(), std::string(name), use}, -1);
  if (isNew) entry->second = LoadFirst(scene, from, name, use, place);
  return entry->second;
}

// The picture of a name that was not asked for before; its file may have been, by another name.
scene::ImageIndex ImageLoader::LoadFirst(scene::Scene& scene, const fs::path& folder,
                                         std::string_view name, ImageUse use, const Place& place) {
  const auto provided = provided_.find(name);
  const bool isProvided = provided != provided_.end();
  const std::optional<fs::path> path =
      isProvided ? fs::path(provided->first) : finder_.Find(folder, name);
  if (!path) {
    if (missing_.emplace(name).second)
      Warn(fmt::format("the picture {} is not found in the scene's folder", Quoted(name)), place);
    return -1;
  }

  std::error_code ignored;
  const std::string real =
      isProvided ? "embedded:" + provided->first : fs::weakly_canonical(*path, ignored).string();
  const auto [entry, isNew] = loaded_.try_emplace({real, use}, -1);
  if (!isNew) return entry->second;
  if (scene.images.size() >= limits_.pictures)
    throw Error("too many pictures", place, LiftedBy(&ReadLimits::pictures));
  try {
    scene::Image texels =
        isProvided ? DecodeTexels(provided->second, path->string(), use, limits_)
                   : DecodeTexels(ReadWithin(*path, limits_), path->string(), use, limits_);
    texels_ += std::uint64_t(texels.width) * std::uint64_t(texels.height);
    if (texels_ > limits_.pixels)
      throw Error("all pictures together are too large", {path->string()},
                  LiftedBy(&ReadLimits::pixels));
    scene.images.push_back(std::move(texels));
    entry->second = scene::ImageIndex(scene.images.size()) - 1;
  } catch (const Error& error) {
    const Diagnostic& cause = error.diagnostics().front();
    Warn(fmt::format("cannot use the picture {}: {}", ToString(cause.place), cause.message), place,
         cause.hint);
  }
  return entry->second;
}

void ImageLoader::Warn(std::string message, const Place& place, std::string hint) {
  if (++warnings_ > MaxWarnings || !warn_) return;
  if (warnings_ == MaxWarnings) message = "more pictures are missing or damaged";
  warn_({std::move(message), place, std::move(hint)});
}

}  // namespace snell::io
