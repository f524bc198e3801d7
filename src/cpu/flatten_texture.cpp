// SPDX-License-Identifier: Apache-2.0
#include "cpu/flatten_texture.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/matrix.hpp>

#include "image/color.h"
#include "kernel/image.h"

namespace snell::cpu {

using namespace kernel;

namespace {

uint FlattenKind(scene::TextureKind kind) {
  switch (kind) {
    case scene::TextureKind::Checker: return TEXTURE_CHECKER;
    case scene::TextureKind::Stripes: return TEXTURE_STRIPES;
    case scene::TextureKind::Gradient: return TEXTURE_GRADIENT;
    case scene::TextureKind::Marble: return TEXTURE_MARBLE;
    case scene::TextureKind::Wood: return TEXTURE_WOOD;
    case scene::TextureKind::Image: return TEXTURE_IMAGE;
  }
  return TEXTURE_CHECKER;
}

uint FlattenSpace(scene::TextureSpace space) {
  switch (space) {
    case scene::TextureSpace::Uv: return SPACE_UV;
    case scene::TextureSpace::Object: return SPACE_OBJECT;
    case scene::TextureSpace::World: return SPACE_WORLD;
  }
  return SPACE_UV;
}

uint FlattenWrap(scene::Wrap wrap) {
  switch (wrap) {
    case scene::Wrap::Repeat: return WRAP_REPEAT;
    case scene::Wrap::Clamp: return WRAP_CLAMP;
    case scene::Wrap::Mirror: return WRAP_MIRROR;
  }
  return WRAP_REPEAT;
}

uint FlattenFilter(scene::TextureFilter filter) {
  switch (filter) {
    case scene::TextureFilter::Nearest: return LOOKUP_NEAREST;
    case scene::TextureFilter::Linear: return LOOKUP_LINEAR;
    case scene::TextureFilter::Mipmap: return LOOKUP_MIPMAP;
  }
  return LOOKUP_MIPMAP;
}

// What counts as a texel of a pattern, to a period: bump maps measure slopes over it.
constexpr double PatternTexels = 64;

// A level of detail in linear light, four floats a texel.
struct Level {
  int width = 0;
  int height = 0;
  std::vector<vec4> texels;
};

// Half as wide and high. Where a size is odd, the last texel takes in the left-over ones.
Level Halved(const Level& from) {
  Level to{std::max(from.width / 2, 1), std::max(from.height / 2, 1), {}};
  to.texels.reserve(std::size_t(to.width) * std::size_t(to.height));
  const auto end = [](int place, int count, int size) {
    return place + 1 == count ? size : std::min(2 * place + 2, size);
  };
  for (int y = 0; y < to.height; ++y) {
    for (int x = 0; x < to.width; ++x) {
      const int x1 = end(x, to.width, from.width), y1 = end(y, to.height, from.height);
      vec4 sum(0.0f);
      for (int j = 2 * y; j < y1; ++j) {
        for (int i = 2 * x; i < x1; ++i)
          sum += from.texels[std::size_t(j) * std::size_t(from.width) + std::size_t(i)];
      }
      to.texels.push_back(sum / float((x1 - 2 * x) * (y1 - 2 * y)));
    }
  }
  return to;
}

std::uint32_t Pack(const vec4& c, bool srgb) {
  const auto code = [&](float x) {
    return std::uint32_t(image::Quantize8(srgb ? image::EncodeSrgb(x) : x));
  };
  return code(c.x) | code(c.y) << 8 | code(c.z) << 16 | std::uint32_t(image::Quantize8(c.w)) << 24;
}

void Append(const Level& level, uint encoding, std::vector<std::uint32_t>& texels) {
  for (const vec4& c : level.texels) {
    if (encoding == IMAGE_FLOATS) {
      for (const float x : {c.x, c.y, c.z, c.w}) texels.push_back(std::bit_cast<std::uint32_t>(x));
    } else {
      texels.push_back(Pack(c, encoding == IMAGE_SRGB));
    }
  }
}

Image FlattenImage(const scene::Image& from, bool mipmapped, FlatScene& flat) {
  const bool isFloat = !from.floats.empty();
  Image image = {};
  image.encoding = isFloat ? IMAGE_FLOATS : from.srgb ? IMAGE_SRGB : IMAGE_BYTES;
  image.width = uint(from.width);
  image.height = uint(from.height);
  image.levels = mipmapped ? uint(std::bit_width(std::max(image.width, image.height))) : 1;
  const std::size_t count = std::size_t(from.width) * std::size_t(from.height);
  const std::size_t words = count * (isFloat ? 4 : 1);
  if (flat.texels.size() + words + words / 2 + 64 > 0xffffffffu)
    throw Error("the pictures of the scene's textures have more texels than Snell can number");
  image.firstWord = uint(flat.texels.size());

  // The first level keeps its bits
  Level level{from.width, from.height, std::vector<vec4>(mipmapped ? count : 0)};
  for (std::size_t i = 0; i < count; ++i) {
    vec4 c;
    if (isFloat) {
      for (int k = 0; k < 4; ++k) {
        c[k] = from.floats[4 * i + std::size_t(k)];
        flat.texels.push_back(std::bit_cast<std::uint32_t>(c[k]));
      }
    } else {
      const std::uint8_t* b = &from.bytes[4 * i];
      flat.texels.push_back(b[0] | std::uint32_t(b[1]) << 8 | std::uint32_t(b[2]) << 16 |
                            std::uint32_t(b[3]) << 24);
      for (int k = 0; k < 4; ++k)
        c[k] =
            from.srgb && k < 3 ? std::bit_cast<float>(flat.texels[b[k]]) : float(b[k]) * ByteUnit;
    }
    if (mipmapped) level.texels[i] = c;
  }
  for (uint i = 1; i < image.levels; ++i) {
    level = Halved(level);
    Append(level, image.encoding, flat.texels);
  }
  return image;
}

}  // namespace

void FlattenTextures(const scene::Scene& scene, FlatScene& flat) {
  // The table of sRGB's codes comes first
  for (int code = 0; code < 256; ++code)
    flat.texels.push_back(std::bit_cast<std::uint32_t>(image::DecodeSrgb(float(code) / 255)));
  std::vector<bool> mipmapped(scene.images.size(), false);
  for (const scene::Texture& texture : scene.textures) {
    if (texture.image >= 0 && texture.filter == scene::TextureFilter::Mipmap)
      mipmapped[std::size_t(texture.image)] = true;
  }
  for (std::size_t i = 0; i < scene.images.size(); ++i)
    flat.images.push_back(FlattenImage(scene.images[i], mipmapped[i], flat));

  for (const scene::Texture& from : scene.textures) {
    Texture texture = {};
    texture.kind = FlattenKind(from.kind);
    texture.space = FlattenSpace(from.space);
    texture.colorA = from.colorA;
    texture.colorB = from.colorB;
    texture.turbulence = from.turbulence;
    texture.octaves = uint(from.octaves);
    texture.smoothEdges = from.smooth ? 1 : 0;
    texture.toSpace = ToTransform(from.placement);
    texture.image = from.image < 0 ? None : uint(from.image);
    texture.uvSet = uint(from.uvSet);
    texture.wrapU = FlattenWrap(from.wrapU);
    texture.wrapV = FlattenWrap(from.wrapV);
    texture.lookup = FlattenFilter(from.filter);
    const double stretch = std::abs(glm::determinant(glm::dmat2(glm::inverse(from.placement))));
    double texels = PatternTexels * PatternTexels;
    if (from.image >= 0) {
      const scene::Image& image = scene.images[std::size_t(from.image)];
      texels = double(image.width) * image.height;
    }
    texture.texelDensity = float(std::sqrt(stretch * texels));
    flat.textures.push_back(texture);
  }
}

}  // namespace snell::cpu
