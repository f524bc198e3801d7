// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <glm/matrix.hpp>
#include <utility>

#include "image/color.h"
#include "io/gltf/nodes.h"
#include "io/gltf/uri.h"
#include "util/text.h"
#include "util/threads.h"

namespace snell::io {
namespace {

scene::Wrap WrapOf(int mode) {
  if (mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return scene::Wrap::Clamp;
  if (mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT) return scene::Wrap::Mirror;
  return scene::Wrap::Repeat;
}

scene::TextureFilter FilterOf(const tinygltf::Sampler& sampler) {
  if (sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST) return scene::TextureFilter::Nearest;
  const bool isSingleLevel = sampler.minFilter == TINYGLTF_TEXTURE_FILTER_NEAREST ||
                             sampler.minFilter == TINYGLTF_TEXTURE_FILTER_LINEAR;
  return isSingleLevel ? scene::TextureFilter::Linear : scene::TextureFilter::Mipmap;
}

std::string NameOf(const GltfImage& image) {
  if (!image.name.empty() || image.uri.empty() || IsDataUri(image.uri)) return image.name;
  return std::filesystem::path(DecodePercent(image.uri)).filename().string();
}

}  // namespace

scene::Affine GltfPlacement(const GltfValue& transform) {
  // In glTF, texture coordinates are scaled, then turned counter-clockwise as seen in the picture, whose v
  // points down, then moved
  const std::vector<double> offset = transform.Numbers("offset", {0, 0});
  const std::vector<double> scale = transform.Numbers("scale", {1, 1});
  const double angle = transform.Number("rotation", 0);
  const double c = std::cos(angle), s = std::sin(angle);
  const scene::Affine toPicture(glm::dvec4(c * scale[0], -s * scale[0], 0, 0),
                                glm::dvec4(s * scale[1], c * scale[1], 0, 0),
                                glm::dvec4(0, 0, 1, 0), glm::dvec4(offset[0], offset[1], 0, 1));
  // Our v points up, before and after
  const scene::Affine flip(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, -1, 0, 0), glm::dvec4(0, 0, 1, 0),
                           glm::dvec4(0, 1, 0, 1));
  return transform ? flip * glm::inverse(toPicture) * flip : scene::Affine(1.0);
}

GltfTextures::GltfTextures(GltfData& data, scene::Scene& scene) : data_(data), scene_(scene) {
  // Find the bytes first: buffer views may have to be decompressed
  const GltfDocument& document = data.document();
  std::map<int, std::string_view> bytes;
  for (const tinygltf::Texture& texture : document.model.textures) {
    for (const int source : Sources(texture)) {
      const GltfImage& image = document.images[std::size_t(source)];
      if (pictures_.contains(source)) continue;
      GltfPicture& picture = pictures_[source];
      try {
        const std::string_view view =
            image.uri.empty() ? data.View(image.bufferView) : std::string_view();
        bytes.emplace(source, view);
      } catch (const Error& error) {
        picture.fault = error.diagnostics().front().message;
      }
    }
  }

  std::vector<int> images;
  for (const auto& [image, view] : bytes) images.push_back(image);
  std::vector<GltfPicture*> results;
  for (const int image : images) results.push_back(&pictures_[image]);
  std::atomic<std::uint64_t> pixels = 0;
  ParallelInOrder(images.size(), [&](std::uint64_t i, int) {
    GltfPicture picture = ReadGltfPicture(document, bytes.at(images[i]), images[i]);
    pixels += std::uint64_t(picture.texels.width) * std::uint64_t(picture.texels.height);
    if (pixels > document.limits.pixels)
      throw document.Fault(
          "",
          fmt::format("the pictures have more than {}", Plural(document.limits.pixels, "pixel")),
          LiftedBy(&ReadLimits::pixels));
    *results[i] = std::move(picture);
  });
}

// The images that a texture may show, the best first.
std::vector<int> GltfTextures::Sources(const tinygltf::Texture& texture) const {
  std::vector<int> sources;
  for (const int source :
       {GltfValue(texture.extensions, "EXT_texture_webp").Integer("source"), texture.source}) {
    if (source >= 0 && std::size_t(source) < data_.document().images.size())
      sources.push_back(source);
  }
  return sources;
}

scene::ImageIndex GltfTextures::ImageOf(int image, GltfPictureUse use, double gloss) {
  const auto [entry, isNew] = images_.try_emplace({image, use, gloss}, 0);
  if (!isNew) return entry->second;
  GltfPicture& picture = pictures_[image];
  const auto home = home_.find(image);
  scene::Image made =
      home == home_.end() ? picture.texels : scene_.images[std::size_t(home->second)];
  made.name = NameOf(data_.document().images[std::size_t(image)]);
  made.srgb = use == GltfPictureUse::Color && made.floats.empty();
  entry->second = scene::ImageIndex(scene_.images.size());
  if (use == GltfPictureUse::Gloss) {
    for (std::size_t i = 3; i < made.bytes.size(); i += 4)
      made.bytes[i] = std::uint8_t(std::lround(255 - gloss * made.bytes[i]));
    for (std::size_t i = 3; i < made.floats.size(); i += 4)
      made.floats[i] = float(1 - gloss * double(made.floats[i]));
  } else if (!made.floats.empty()) {
    // Encoded colours of 16 bits
    for (std::size_t i = 0; use == GltfPictureUse::Color && i < made.floats.size(); ++i)
      if (i % 4 != 3) made.floats[i] = image::DecodeSrgb(made.floats[i]);
  } else if (home == home_.end()) {
    home_[image] = entry->second;
    picture.texels.bytes = {};
  }
  scene_.images.push_back(std::move(made));
  return entry->second;
}

scene::TextureIndex GltfTextures::Get(const GltfTextureInfo& info, GltfPictureUse use,
                                      const std::string& part, double gloss) {
  if (info.texture < 0) return -1;
  const GltfDocument& document = data_.document();
  GltfFindings& findings = document.findings;
  const auto leaveOut = [&](std::string why) {
    findings.Note(std::move(why), part);
    return -1;
  };
  if (std::size_t(info.texture) >= document.model.textures.size())
    return leaveOut("a texture does not exist");
  const tinygltf::Texture& record = document.model.textures[std::size_t(info.texture)];
  const int uvSet = info.transform.Integer("texCoord", info.coordinates);
  if (uvSet < 0 || uvSet > 1)
    return leaveOut("textures on a third or later set of coordinates are left out");

  // Take the first picture that can be shown
  const std::vector<int> sources = Sources(record);
  const auto source =
      std::ranges::find_if(sources, [&](int image) { return pictures_.at(image).fault.empty(); });
  if (sources.empty() && record.extensions.contains("KHR_texture_basisu"))
    return leaveOut("textures with KTX2 pictures only (KHR_texture_basisu) are left out");
  if (sources.empty()) return leaveOut("textures without a picture are left out");
  if (source == sources.end()) {
    const GltfImage& image = document.images[std::size_t(sources.back())];
    return leaveOut(fmt::format("the picture {} is left out: {}",
                                image.uri.empty()
                                    ? "in " + GltfPart("buffer view", std::size_t(image.bufferView))
                                    : ShortUri(image.uri),
                                pictures_.at(sources.back()).fault));
  }

  scene::Texture texture;
  texture.kind = scene::TextureKind::Image;
  texture.uvSet = uvSet;
  texture.placement = GltfPlacement(info.transform);
  if (!IsInvertible(texture.placement)) {
    findings.Note("a texture's transform that cannot be undone is ignored", part);
    texture.placement = scene::Affine(1.0);
  }
  if (record.sampler >= 0 && std::size_t(record.sampler) < document.model.samplers.size()) {
    const tinygltf::Sampler& sampler = document.model.samplers[std::size_t(record.sampler)];
    texture.wrapU = WrapOf(sampler.wrapS);
    texture.wrapV = WrapOf(sampler.wrapT);
    texture.filter = FilterOf(sampler);
  }
  texture.image = ImageOf(*source, use, gloss);
  texture.name = record.name.empty() ? scene_.images[std::size_t(texture.image)].name : record.name;

  // Equal ones are one
  std::vector<double> key = {double(texture.image), double(uvSet), double(int(texture.wrapU)),
                             double(int(texture.wrapV)), double(int(texture.filter))};
  for (int column : {0, 1, 3})
    for (int row : {0, 1}) key.push_back(texture.placement[column][row]);
  const auto [entry, isNew] =
      textures_.try_emplace(std::move(key), scene::TextureIndex(scene_.textures.size()));
  if (isNew) scene_.textures.push_back(std::move(texture));
  return entry->second;
}

}  // namespace snell::io
