// SPDX-License-Identifier: Apache-2.0
//
// pbrt's named textures as far as a scene's textures can hold them; the others become constants.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "io/pbrt/values.h"

namespace snell::io {

class PbrtTextures {
 public:
  explicit PbrtTextures(PbrtContext& context) : context_(context) {}

  // What a Texture statement defines. `toWorld` is the place of its coordinates.
  void Define(const std::string& name, const std::string& type, const std::string& kind,
              const PbrtParameters& parameters, const scene::Affine& toWorld);

  // A parameter that may be a colour or a texture's name. Colours are factors from 0 to 1.
  scene::ColorInput Color(const PbrtParameters& parameters, std::string_view name,
                          const scene::Spectrum& absent) const;
  // The same for numbers; `channel` of pictures is red.
  scene::ScalarInput Scalar(const PbrtParameters& parameters, std::string_view name,
                            float absent) const;

 private:
  const scene::ColorInput& Named(const PbrtParameter& parameter, bool isFloat) const;
  // A texture's own input: a number, a colour or another texture.
  scene::ColorInput Input(const PbrtParameters& parameters, std::string_view name, bool isFloat,
                          const scene::Spectrum& absent) const;
  scene::ColorInput Make(const std::string& kind, const PbrtParameters& parameters, bool isFloat,
                         const scene::Affine& toWorld);
  scene::ColorInput Picture(const PbrtParameters& parameters, bool isFloat);
  scene::ColorInput Checkerboard(const PbrtParameters& parameters, bool isFloat,
                                 const scene::Affine& toWorld);
  scene::ColorInput Mix(const PbrtParameters& parameters, bool isFloat) const;
  scene::ColorInput Scale(const PbrtParameters& parameters, bool isFloat) const;
  // The constant that stands for a texture; reported if it is none.
  scene::Spectrum MeanOf(const scene::ColorInput& texture, const PbrtParameters& parameters) const;
  scene::Spectrum MeanOf(scene::ImageIndex image) const;
  scene::Affine UvPlacement(const PbrtParameters& parameters) const;

  PbrtContext& context_;
  std::map<std::pair<std::string, bool>, scene::ColorInput> textures_;  // bool: of numbers
  mutable std::map<scene::ImageIndex, scene::Spectrum> means_;
};

}  // namespace snell::io
