// SPDX-License-Identifier: Apache-2.0
//
// Which extensions of glTF Snell knows (docs/gltf.md says how far).
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "io/gltf/document.h"

namespace snell::io {

static constexpr std::array<std::string_view, 27> Known = {
    "EXT_mesh_gpu_instancing",
    "EXT_meshopt_compression",
    "EXT_texture_webp",
    "KHR_draco_mesh_compression",
    "KHR_lights_punctual",
    "KHR_materials_anisotropy",
    "KHR_materials_clearcoat",
    "KHR_materials_diffuse_transmission",
    "KHR_materials_dispersion",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_iridescence",
    "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_sheen",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_variants",
    "KHR_materials_volume",
    "KHR_mesh_quantization",
    "KHR_node_visibility",
    "KHR_texture_basisu",  // its plain source, or a warning
    "KHR_texture_transform",
    // Of no effect on a picture
    "KHR_xmp_json_ld",
    "EXT_mesh_features",
    "EXT_structural_metadata",
    "KHR_xmp",
};

void CheckGltfExtensions(const GltfDocument& document) {
  const auto isKnown = [](const std::string& name) {
    return std::ranges::find(Known, name) != Known.end();
  };
  for (const std::string& name : document.model.extensionsRequired)
    if (!isKnown(name))
      throw document.Fault("", fmt::format("the file requires the extension '{}', which Snell does "
                                           "not have",
                                           name));
  for (const std::string& name : document.model.extensionsUsed)
    if (!isKnown(name)) document.findings.Note(fmt::format("the extension '{}' is ignored", name));
}

}  // namespace snell::io
