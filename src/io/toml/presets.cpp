// SPDX-License-Identifier: Apache-2.0
//
// The materials that are ready for use by name, in the language that users write. Indices of refraction at
// 587.6 nm: SCHOTT N-BK7; water at 20 °C, Daimon and Masumura 2007; diamond, Peter 1923. Reflectances in
// linear Rec.709: gold, Adobe Standard Material; chromium, from the Lorentz-Drude model of Rakić et al. 1998.
#include "io/toml/sections.h"

namespace snell::io {

const std::vector<Preset>& Presets() {
  static const std::vector<Preset> presets = {
      {"glass", "Crown glass (BK7).", R"(type = "dielectric"
ior = 1.5168
specular = 1)"},
      {"water", "Water at 20 °C.", R"(type = "dielectric"
ior = 1.3334
specular = 1)"},
      {"diamond", "Diamond.", R"(type = "dielectric"
ior = 2.4175
specular = 1)"},
      {"mirror", "A good mirror.", R"(type = "mirror"
color = 0.95
specular = 0.95)"},
      {"chrome", "Polished chromium.", R"(type = "metal"
color = [0.645, 0.65, 0.654]
specular = [0.645, 0.65, 0.654])"},
      {"gold", "Polished gold.", R"(type = "metal"
color = [1, 0.71, 0.315]
specular = [1, 0.71, 0.315])"},
      {"plastic", "Smooth grey plastic; give it a colour by `diffuse`.", R"(type = "blinn"
diffuse = 0.5
specular = 0.04
shininess = 300
normalized = true
reflectivity = 1
reflection = "fresnel"
ior = 1.5)"},
      {"rubber", "Black rubber.", R"(type = "blinn"
diffuse = 0.03
specular = 0.04
shininess = 8
normalized = true)"},
  };
  return presets;
}

}  // namespace snell::io
