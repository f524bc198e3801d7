// SPDX-License-Identifier: Apache-2.0
//
// Physical materials (OpenPBR) of what MTL files say. docs/obj.md has the mapping and what it approximates.
#pragma once

#include <cstdint>
#include <map>
#include <tuple>

#include "io/findings.h"
#include "io/images.h"
#include "io/obj/mtl.h"
#include "scene/scene.h"

namespace snell::io {

// MTL's heights have no unit. White is this much of the length that a picture covers on the surface, times
// the option -bm, above black; MtlConverter gives it for pictures one metre long.
inline constexpr float BumpHeight = 0.01f;

// The roughness of a Blinn-Phong highlight: α = √(2 / (exponent + 2)) (Walter et al. 2007), whose square root
// it is.
float RoughnessOfExponent(float exponent);

class MtlConverter {
 public:
  // Adds pictures and textures to the scene.
  MtlConverter(scene::Scene& scene, ImageLoader& images, Findings& findings)
      : scene_(scene), images_(images), findings_(findings) {}

  scene::Material Convert(const MtlMaterial& mtl);

 private:
  void ConvertBase(const MtlMaterial& mtl, scene::OpenPbr& pbr);
  void ConvertSpecular(const MtlMaterial& mtl, scene::OpenPbr& pbr);
  void ConvertMirror(const MtlMaterial& mtl, scene::OpenPbr& pbr);
  void ConvertRoughness(const MtlMaterial& mtl, scene::OpenPbr& pbr);
  void ConvertLayers(const MtlMaterial& mtl, scene::OpenPbr& pbr);
  void ConvertTransparency(const MtlMaterial& mtl, scene::Material& material);
  void ConvertRelief(const MtlMaterial& mtl, scene::Material& material);

  // A value, and the map that multiplies it: beside a map, 0 or nothing counts as 1, as files mean it.
  scene::ColorInput Color(const MtlMaterial& mtl, MtlColor key, MtlMapKey map,
                          scene::Spectrum absent, bool reflectance);
  scene::ScalarInput Scalar(const MtlMaterial& mtl, MtlNumber key, MtlMapKey map, float absent);
  float Number(const MtlMaterial& mtl, MtlNumber key, float absent, float least, float most);
  scene::Spectrum Clamped(const MtlMaterial& mtl, scene::Spectrum color, float most);
  scene::TextureIndex Load(const MtlMaterial& mtl, MtlMapKey map, ImageUse use);
  int ChannelOf(const MtlMaterial& mtl, MtlMapKey map);
  bool BakeRoughness(scene::TextureIndex exponents, int channel, float scale);
  Place PlaceOf(const MtlMaterial& mtl, int line = 0) const;

  // What a picture holds, found once for each.
  struct Facts {
    bool hasAlpha = false;
    bool isBinary[4] = {};  // each channel: nothing but 0 and 1
  };
  const Facts& FactsOf(scene::ImageIndex image);

  scene::Scene& scene_;
  ImageLoader& images_;
  Findings& findings_;
  std::map<scene::ImageIndex, Facts> facts_;
  std::map<std::tuple<scene::ImageIndex, int, float>, scene::ImageIndex> baked_;
  std::uint64_t bakedTexels_ = 0;
};

}  // namespace snell::io
