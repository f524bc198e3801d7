// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include "image/color.h"
#include "io/mesh/text.h"

namespace snell::io {

using scene::ColorInput;
using scene::Spectrum;

namespace {

// The mean of a picture's texels, of at most about a million of them.
Spectrum MeanTexel(const scene::Image& image) {
  const std::size_t count = std::size_t(image.width) * std::size_t(image.height);
  const std::size_t step = std::max<std::size_t>(1, count >> 20);
  glm::dvec3 sum(0.0);
  std::size_t taken = 0;
  for (std::size_t i = 0; i < count; i += step, ++taken) {
    image::vec3 texel;
    for (int c = 0; c < 3; ++c) {
      const std::size_t at = i * 4 + std::size_t(c);
      texel[c] = image.bytes.empty() ? image.floats[at] : float(image.bytes[at]) / 255;
    }
    sum += glm::dvec3(image.srgb ? image::DecodeSrgb(texel) : texel);
  }
  return Spectrum(sum / double(std::max<std::size_t>(taken, 1)));
}

bool IsInvertible(const scene::Affine& m) {
  const double determinant = glm::determinant(glm::dmat3(m));
  return std::isfinite(determinant) && std::abs(determinant) > 1e-30;
}

}  // namespace

void PbrtTextures::Define(const std::string& name, const std::string& type, const std::string& kind,
                          const PbrtParameters& parameters, const scene::Affine& toWorld) {
  const bool isFloat = type == "float";
  if (!isFloat && type != "spectrum" && type != "color")
    throw Error(fmt::format("a texture is of type float or spectrum, not {}", Quoted(type)),
                parameters.place());
  ColorInput made = Make(kind, parameters, isFloat, toWorld);
  made.value = glm::max(made.value, Spectrum(0.0f));
  textures_[{name, isFloat}] = std::move(made);
}

const ColorInput& PbrtTextures::Named(const PbrtParameter& parameter, bool isFloat) const {
  if (parameter.strings.size() != 1) throw Error("one texture is needed", parameter.place);
  const auto entry = textures_.find({parameter.strings[0], isFloat});
  if (entry != textures_.end()) return entry->second;
  throw Error(fmt::format("there is no {} texture {}", isFloat ? "float" : "spectrum",
                          Quoted(parameter.strings[0])),
              parameter.place);
}

ColorInput PbrtTextures::Input(const PbrtParameters& parameters, std::string_view name,
                               bool isFloat, const Spectrum& absent) const {
  const PbrtParameter* given = parameters.Peek(name);
  if (given && given->type == PbrtType::Texture)
    return Named(*parameters.Find(name, {PbrtType::Texture}), isFloat);
  if (isFloat) return {Spectrum(parameters.Number(name, absent.x))};
  const auto spectrum = SpectrumOf(parameters, name, context_);
  return {spectrum ? spectrum->Factor() : absent};
}

ColorInput PbrtTextures::Color(const PbrtParameters& parameters, std::string_view name,
                               const Spectrum& absent) const {
  ColorInput color = Input(parameters, name, false, absent);
  color.value = Albedo(color.value);
  return color;
}

scene::ScalarInput PbrtTextures::Scalar(const PbrtParameters& parameters, std::string_view name,
                                        float absent) const {
  const ColorInput color = Input(parameters, name, true, Spectrum(absent));
  return {std::max(color.value.x, 0.0f), color.texture, 0};
}

ColorInput PbrtTextures::Make(const std::string& kind, const PbrtParameters& parameters,
                              bool isFloat, const scene::Affine& toWorld) {
  if (kind == "constant") return Input(parameters, "value", isFloat, Spectrum(1.0f));
  if (kind == "imagemap") return Picture(parameters, isFloat);
  if (kind == "checkerboard") return Checkerboard(parameters, isFloat, toWorld);
  if (kind == "mix") return Mix(parameters, isFloat);
  if (kind == "scale") return Scale(parameters, isFloat);

  // A constant that looks the same from afar
  const auto inputs = [&](std::string_view one, std::string_view other) {
    return (MeanOf(Input(parameters, one, isFloat, Spectrum(1.0f)), parameters) +
            MeanOf(Input(parameters, other, isFloat, Spectrum(0.0f)), parameters)) *
           0.5f;
  };
  Spectrum mean(0.5f);
  if (kind == "dots") mean = inputs("inside", "outside");
  if (kind == "directionmix") mean = inputs("tex1", "tex2");
  if (kind == "bilerp") mean = (inputs("v00", "v01") + inputs("v10", "v11")) * 0.5f;
  if (kind == "marble") mean = Spectrum(0.55f, 0.50f, 0.47f);
  context_.findings.Add(fmt::format("{} texture", Quoted(kind)), "approximated by a constant", "",
                        parameters.place());
  for (const auto& parameter : parameters.All()) parameters.Ignore({parameter->name});
  return {mean};
}

// From pattern space to texture coordinates: the other way than pbrt's scale and shift.
scene::Affine PbrtTextures::UvPlacement(const PbrtParameters& parameters) const {
  const std::string mapping = parameters.String("mapping", "uv");
  if (mapping != "uv")
    context_.findings.Add(
        "texture", fmt::format("with the mapping {} laid out by uv instead", Quoted(mapping)), "",
        parameters.place());
  parameters.Ignore({"v1", "v2"});
  scene::Affine map(1.0);
  map[0][0] = double(parameters.Number("uscale", 1));
  map[1][1] = double(parameters.Number("vscale", 1));
  map[3][0] = double(parameters.Number("udelta", 0));
  map[3][1] = double(parameters.Number("vdelta", 0));
  if (IsInvertible(map)) return glm::inverse(map);
  context_.findings.Add("texture", "with a scale of 0, which is not used", "", parameters.place());
  return scene::Affine(1.0);
}

ColorInput PbrtTextures::Picture(const PbrtParameters& parameters, bool isFloat) {
  const std::string file = parameters.String("filename", "");
  if (file.empty()) throw Error("an imagemap needs a filename", parameters.place());
  const std::string encoding = parameters.String("encoding", "sRGB");
  if (encoding.starts_with("gamma"))
    context_.findings.Add("picture", "with a gamma of its own, taken as sRGB", file,
                          parameters.place());
  const std::string wrap = parameters.String("wrap", "repeat");
  const std::string filter = parameters.String("filter", "bilinear");
  const float scale = parameters.Number("scale", 1);
  const bool invert = parameters.Bool("invert", false);
  parameters.Ignore({"maxanisotropy"});

  ColorInput made;
  made.value = Spectrum(std::max(scale, 0.0f));
  scene::Texture texture;
  texture.name = file;
  texture.kind = scene::TextureKind::Image;
  texture.placement = UvPlacement(parameters);
  const ImageUse use = encoding == "linear" ? ImageUse::Data : ImageUse::Color;
  texture.image = context_.images.Load(context_.scene, file, use, parameters.place());
  if (texture.image < 0) return {Spectrum(isFloat ? scale : 0.5f * scale)};
  if (invert) {
    const Spectrum mean = MeanOf(texture.image);
    context_.findings.Add("inverted picture", "approximated by its mean", file, parameters.place());
    return {glm::clamp(Spectrum(1.0f) - mean * scale, 0.0f, 1.0f)};
  }
  if (wrap != "repeat" && wrap != "clamp" && wrap != "black" && wrap != "octahedralsphere")
    throw Error(fmt::format("there is no wrap mode {}", Quoted(wrap)), parameters.place());
  if (wrap == "black" || wrap == "octahedralsphere")
    context_.findings.Add("picture", fmt::format("with the wrap mode '{}' clamped instead", wrap),
                          "", parameters.place());
  texture.wrapU = texture.wrapV = wrap == "repeat" ? scene::Wrap::Repeat : scene::Wrap::Clamp;
  if (filter == "point") texture.filter = scene::TextureFilter::Nearest;
  if (filter == "bilinear") texture.filter = scene::TextureFilter::Linear;
  made.texture = scene::TextureIndex(context_.scene.textures.size());
  context_.scene.textures.push_back(std::move(texture));
  return made;
}

ColorInput PbrtTextures::Checkerboard(const PbrtParameters& parameters, bool isFloat,
                                      const scene::Affine& toWorld) {
  const int dimension = parameters.Integer("dimension", 2);
  if (dimension != 2 && dimension != 3)
    throw Error("a checkerboard has 2 or 3 dimensions", parameters.place());
  scene::Texture texture;
  texture.name = "checkerboard";
  texture.colorA = MeanOf(Input(parameters, "tex1", isFloat, Spectrum(1.0f)), parameters);
  texture.colorB = MeanOf(Input(parameters, "tex2", isFloat, Spectrum(0.0f)), parameters);
  texture.colorA = glm::max(texture.colorA, Spectrum(0.0f));
  texture.colorB = glm::max(texture.colorB, Spectrum(0.0f));
  parameters.Ignore({"aamode"});
  if (dimension == 2) {
    texture.placement = UvPlacement(parameters);
  } else {
    texture.space = scene::TextureSpace::World;
    if (IsInvertible(toWorld)) texture.placement = toWorld;
  }
  ColorInput made{Spectrum(1.0f)};
  made.texture = scene::TextureIndex(context_.scene.textures.size());
  context_.scene.textures.push_back(std::move(texture));
  return made;
}

ColorInput PbrtTextures::Mix(const PbrtParameters& parameters, bool isFloat) const {
  const ColorInput one = Input(parameters, "tex1", isFloat, Spectrum(0.0f));
  const ColorInput other = Input(parameters, "tex2", isFloat, Spectrum(1.0f));
  const ColorInput by = Input(parameters, "amount", true, Spectrum(0.5f));
  const float amount = std::clamp(MeanOf(by, parameters).x, 0.0f, 1.0f);
  if (amount == 0) return one;
  if (amount == 1) return other;
  return {glm::mix(MeanOf(one, parameters), MeanOf(other, parameters), amount)};
}

ColorInput PbrtTextures::Scale(const PbrtParameters& parameters, bool isFloat) const {
  ColorInput texture = Input(parameters, "tex", isFloat, Spectrum(1.0f));
  ColorInput scale = Input(parameters, "scale", true, Spectrum(1.0f));
  if (texture.texture < 0) std::swap(texture, scale);
  texture.value *= MeanOf(scale, parameters);
  return texture;
}

Spectrum PbrtTextures::MeanOf(const ColorInput& texture, const PbrtParameters& parameters) const {
  if (texture.texture < 0) return texture.value;
  context_.findings.Add("texture", "within a texture approximated by its mean", "",
                        parameters.place());
  const scene::Texture& made = context_.scene.textures[std::size_t(texture.texture)];
  return texture.value *
         (made.image >= 0 ? MeanOf(made.image) : (made.colorA + made.colorB) * 0.5f);
}

Spectrum PbrtTextures::MeanOf(scene::ImageIndex image) const {
  const auto [entry, isNew] = means_.try_emplace(image, 0.0f);
  if (isNew) entry->second = MeanTexel(context_.scene.images[std::size_t(image)]);
  return entry->second;
}

}  // namespace snell::io
