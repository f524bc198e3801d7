// SPDX-License-Identifier: Apache-2.0
//
// Materials of type "openpbr", by the names of OpenPBR Surface 1.1, and the maps of all materials.
#include "io/toml/sections.h"

namespace snell::io {

using scene::Material;
using scene::OpenPbr;
using scene::ReliefMap;
using scene::ScalarInput;

Type<ScalarInput> Share() {
  Type<ScalarInput> type;
  const Type<float> number = Number({0, 1});
  type.expected = number.expected;
  type.schema = number.schema;
  type.example = number.example;
  type.read = [number](Reader& reader, const Node& value, ScalarInput& input) {
    return number.read(reader, value, input.value);
  };
  type.write = [number](const ScalarInput& input) { return number.write(input.value); };
  return type;
}

Keys<MaterialDraft> MapKeys() {
  const auto normals =
      Within(&Material::normalMap,
             {Field("normal_map", &ReliefMap::texture, TextureName(),
                    "A texture of normals in tangent space; of type `image`, with `data = true`.")
                  .Standard("none"),
              Field("normal_scale", &ReliefMap::scale, Number(Any), "How steep its normals are."),
              Field("normal_flip_green", &ReliefMap::flipGreen, Boolean(),
                    "Its green points down, as DirectX has it.")});
  const auto bumps =
      Within(&Material::bumpMap,
             {Field("bump_map", &ReliefMap::texture, TextureName(),
                    "A texture of heights: the brighter, the higher.")
                  .Standard("none"),
              Field("bump_height", &ReliefMap::scale, Number(Any, "m"), "From black to white.")});
  const auto displacement =
      Field("displacement", &Material::displacement,
            TableOf(DisplacementSection, "a table with a texture and a height"),
            "Moves the surface of meshes.")
          .Standard("none")
          .Example("{ texture = \"marble\", height = 0.2 }")
          .Not({"displacement_map", "disp"});
  return Within(&MaterialDraft::material, Join<Material>({normals, bumps, {displacement}}));
}

static void FinishPhysical(Reader&, const Fields&, MaterialDraft& draft) {
  draft.physical.specularIor = draft.material.ior;
  draft.physical.emission = draft.material.emission;
  draft.material.physical = draft.physical;
}

VariantOf<MaterialDraft> PhysicalMaterial() {
  const auto color = [](const char* name, ColorInput OpenPbr::*member, const char* text) {
    return Field(name, member, ColorOrTexture(Brightness::Reflectance), text);
  };
  const auto share = [](const char* name, ScalarInput OpenPbr::*member, const char* text) {
    return Field(name, member, Share(), text);
  };
  return VariantOf<MaterialDraft>(
             "openpbr",
             "Physical, by the names of OpenPBR Surface; `ior` and `emission` count as its own.",
             Within(&MaterialDraft::physical,
                    Join<OpenPbr>(
                        {InteriorKeys(),
                         {color("base_color", &OpenPbr::baseColor, "Of the base, matt or metal.")
                              .Not({"color", "diffuse", "albedo"}),
                          share("base_metalness", &OpenPbr::baseMetalness, "0 dielectric, 1 metal.")
                              .Not({"metalness", "metallic"}),
                          share("specular_weight", &OpenPbr::specularWeight, "Of the reflection."),
                          color("specular_color", &OpenPbr::specularColor, "Of the reflection."),
                          share("specular_roughness", &OpenPbr::specularRoughness,
                                "0 mirrors, 1 scatters widely.")
                              .Not({"roughness"}),
                          share("transmission_weight", &OpenPbr::transmissionWeight,
                                "How much of the base is clear.")
                              .Not({"transmission", "transparency"}),
                          share("coat_weight", &OpenPbr::coatWeight, "Of the clear coat.")
                              .Not({"coat", "clearcoat"}),
                          share("coat_roughness", &OpenPbr::coatRoughness, "Of the clear coat."),
                          share("fuzz_weight", &OpenPbr::fuzzWeight, "Of the fuzz, as on velvet.")
                              .Not({"fuzz", "sheen"}),
                          color("fuzz_color", &OpenPbr::fuzzColor, "Of the fuzz."),
                          share("fuzz_roughness", &OpenPbr::fuzzRoughness, "Of the fuzz.")}})))
      .Checked(FinishPhysical);
}

}  // namespace snell::io
