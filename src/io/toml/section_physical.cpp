// SPDX-License-Identifier: Apache-2.0
//
// Physical materials, by the names of OpenPBR Surface 1.1 or as real metals and glasses, and the maps of all materials.
#include <fmt/format.h>

#include "io/toml/sections.h"
#include "scene/measured.h"

namespace snell::io {

using scene::Material;
using scene::OpenPbr;
using scene::ReliefMap;
using scene::ScalarInput;

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

// --- Checks -------------------------------------------------------------------------------------------------

// Report if the table has one of the keys beside `key`. Returns whether it has not.
static bool Alone(Reader& reader, const Fields& fields, const char* key,
                  std::initializer_list<const char*> others) {
  bool alone = true;
  for (const char* other : others) {
    if (!fields.Find(key) || !fields.Find(other)) continue;
    reader.Report(fmt::format("'{}' and '{}' exclude each other in {}", key, other, fields.title),
                  fields.PlaceOf(other));
    alone = false;
  }
  return alone;
}

// Take what the names of a metal or a glass say.
static void ApplyNames(Reader& reader, const Fields& fields, MaterialDraft& draft) {
  OpenPbr& physical = draft.physical;
  if (const scene::MeasuredMetal* metal = scene::FindMetal(draft.metal)) {
    Alone(reader, fields, "metal", {"glass", "base_color", "specular_color", "base_metalness"});
    SetMetal(*metal, physical);
  }
  if (const scene::MeasuredGlass* glass = scene::FindGlass(draft.glass)) {
    Alone(reader, fields, "glass", {"ior", "specular_ior", "transmission_dispersion_abbe_number"});
    const OpenPbr given = physical;
    SetGlass(*glass, physical);
    draft.material.ior = physical.specularIor;
    if (fields.Find("transmission_weight")) physical.transmissionWeight = given.transmissionWeight;
    if (fields.Find("transmission_dispersion_scale"))
      physical.transmissionDispersionScale = given.transmissionDispersionScale;
    if (!fields.Find("specular_roughness")) physical.specularRoughness.value = 0;
  }
}

static void FinishPhysical(Reader& reader, const Fields& fields, MaterialDraft& draft) {
  constexpr float LumensPerWatt = 683;
  OpenPbr& physical = draft.physical;
  ApplyNames(reader, fields, draft);
  physical.specularIor = draft.material.ior;
  Alone(reader, fields, "specular_ior", {"ior"});
  Alone(reader, fields, "geometry_thin_walled", {"thin"});
  physical.emission = draft.material.emission;
  if (Alone(reader, fields, "emission", {"emission_luminance"}) && draft.emissionLuminance > 0) {
    physical.emission = draft.emissionColor;
    physical.emission.value *= draft.emissionLuminance / LumensPerWatt;
  }
  if (fields.Find("geometry_opacity")) draft.material.alphaMode = scene::AlphaMode::Blend;
  draft.material.physical = physical;
}

// --- Keys ---------------------------------------------------------------------------------------------------

Type<ScalarInput> Share() { return NumberOrTexture({0, 1}); }
static Type<ColorInput> Reflectance() { return ColorOrTexture(Brightness::Reflectance); }

static Keys<OpenPbr> BaseKeys() {
  return {Field("base_weight", &OpenPbr::baseWeight, Number({0, 1}), "Multiplies `base_color`."),
          Field("base_color", &OpenPbr::baseColor, Reflectance(), "Of the base, matt or metal.")
              .Not({"color", "diffuse", "albedo"}),
          Field("base_metalness", &OpenPbr::baseMetalness, Share(), "0 dielectric, 1 metal.")
              .Not({"metalness", "metallic"}),
          Field("base_diffuse_roughness", &OpenPbr::baseDiffuseRoughness, Number({0, 1}),
                "Of the matt base: 0 Lambert's law, 1 flat as the moon.")};
}

static Keys<OpenPbr> SpecularKeys() {
  return {Field("specular_weight", &OpenPbr::specularWeight, NumberOrTexture(NotNegative),
                "Multiplies the reflectance at normal incidence."),
          Field("specular_color", &OpenPbr::specularColor, Reflectance(),
                "Of the reflection; of metals towards their edges."),
          Field("specular_roughness", &OpenPbr::specularRoughness, Share(),
                "0 mirrors, 1 scatters widely.")
              .Not({"roughness"}),
          Field("specular_roughness_anisotropy", &OpenPbr::specularRoughnessAnisotropy, Share(),
                "How far highlights are stretched along the surface's tangent, as by brushing.")
              .Not({"anisotropy", "specular_anisotropy"}),
          Field("geometry_tangent_rotation", &OpenPbr::anisotropyRotation, Degrees(Any),
                "Turns the tangent.")
              .Not({"anisotropy_rotation"})};
}

static Keys<OpenPbr> TransmissionKeys() {
  return {Field("transmission_weight", &OpenPbr::transmissionWeight, Share(),
                "How much of the base is clear.")
              .Not({"transmission", "transparency"}),
          Field("transmission_color", &OpenPbr::transmissionColor, Reflectance(),
                "What is left of white light after `transmission_depth`, or, if that is 0, at the "
                "surface."),
          Field("transmission_depth", &OpenPbr::transmissionDepth, Number(NotNegative, "m"),
                "The distance inside after which white light has `transmission_color`."),
          Field("transmission_dispersion_scale", &OpenPbr::transmissionDispersionScale,
                Number({0, 1}), "How far colours are spread by refraction; 1 is Abbe's number.")
              .Not({"dispersion"}),
          Field("transmission_dispersion_abbe_number", &OpenPbr::transmissionDispersionAbbeNumber,
                Number(Positive), "Abbe's number: the smaller, the wider the spread.")
              .Not({"abbe", "abbe_number"})};
}

static Keys<OpenPbr> LayerKeys() {
  return {Field("coat_weight", &OpenPbr::coatWeight, Share(), "Of the clear coat.")
              .Not({"coat", "clearcoat"}),
          Field("coat_color", &OpenPbr::coatColor, Reflectance(),
                "What is left of light that passes the coat down and up again."),
          Field("coat_roughness", &OpenPbr::coatRoughness, Share(), "Of the clear coat."),
          Field("coat_roughness_anisotropy", &OpenPbr::coatRoughnessAnisotropy, Number({0, 1}),
                "Of the clear coat."),
          Field("coat_ior", &OpenPbr::coatIor, Number({1, 10}), "Index of refraction of the coat."),
          Field("coat_darkening", &OpenPbr::coatDarkening, Number({0, 1}),
                "How far reflections inside the coat darken the base; 1 is physical."),
          Field("fuzz_weight", &OpenPbr::fuzzWeight, Share(), "Of the fuzz, as on velvet.")
              .Not({"fuzz", "sheen"}),
          Field("fuzz_color", &OpenPbr::fuzzColor, Reflectance(), "Of the fuzz."),
          Field("fuzz_roughness", &OpenPbr::fuzzRoughness, Share(), "Of the fuzz."),
          Field("thin_film_weight", &OpenPbr::thinFilmWeight, Share(),
                "Of a film on the base that shimmers by interference.")
              .Not({"iridescence"}),
          Field("thin_film_thickness", &OpenPbr::thinFilmThickness,
                NumberOrTexture(NotNegative, "µm"), "Of the film."),
          Field("thin_film_ior", &OpenPbr::thinFilmIor, Number({0.1, 10}),
                "Index of refraction of the film.")};
}

static Keys<MaterialDraft> CoatMapKeys() {
  const auto at = [](MaterialDraft& draft) -> ReliefMap& { return draft.physical.coatNormal; };
  return Within<MaterialDraft, ReliefMap>(
      at, {Field("coat_normal_map", &ReliefMap::texture, TextureName(),
                 "A texture of normals for the coat alone, which `normal_map` does not change.")
               .Standard("none")
               .Not({"geometry_coat_normal"}),
           Field("coat_normal_scale", &ReliefMap::scale, Number(Any), "How steep its normals are."),
           Field("coat_normal_flip_green", &ReliefMap::flipGreen, Boolean(),
                 "Its green points down, as DirectX has it.")});
}

static Keys<MaterialDraft> SurfaceKeys() {
  return Join<MaterialDraft>(
      {{Field("emission_luminance", &MaterialDraft::emissionLuminance, Number(NotNegative, "cd/m²"),
              "How bright the surface glows, in place of `emission`."),
        Field("emission_color", &MaterialDraft::emissionColor, Reflectance(),
              "The colour of `emission_luminance`.")},
       Within(&MaterialDraft::material,
              Keys<Material>{
                  Field("specular_ior", &Material::ior, Number({0.1, 10}), "The same as `ior`."),
                  Field("geometry_thin_walled", &Material::thin, Boolean(), "The same as `thin`."),
                  Field("geometry_opacity", &Material::opacity, Share(),
                        "How much of the surface is there.")})});
}

static Keys<MaterialDraft> NameKeys() {
  std::vector<std::pair<std::string, std::string>> metals, glasses;
  for (const scene::MeasuredMetal& metal : scene::MeasuredMetals())
    metals.emplace_back(metal.name, metal.name);
  for (const scene::MeasuredGlass& glass : scene::MeasuredGlasses())
    glasses.emplace_back(glass.name, glass.name);
  return {Field("metal", &MaterialDraft::metal, Choice<std::string>(metals),
                "A real metal by its measured indices of refraction, in place of `base_color`, "
                "`base_metalness` and `specular_color`. `type` may be left out.")
              .Standard("none")
              .Example("\"gold\"")
              .Tells(),
          Field("glass", &MaterialDraft::glass, Choice<std::string>(glasses),
                "A real clear material by its measured index of refraction and dispersion; smooth "
                "and clear unless other keys say so. `type` may be left out.")
              .Standard("none")
              .Example("\"BK7\"")
              .Tells()};
}

VariantOf<MaterialDraft> PhysicalMaterial() {
  const Keys<OpenPbr> own =
      Join<OpenPbr>({BaseKeys(), SpecularKeys(), TransmissionKeys(), InteriorKeys(), LayerKeys()});
  return VariantOf<MaterialDraft>(
             "openpbr",
             "Physical, by the names of OpenPBR Surface; `ior` and `emission` count as its own.",
             Join<MaterialDraft>(
                 {NameKeys(), Within(&MaterialDraft::physical, own), CoatMapKeys(), SurfaceKeys()}))
      .Checked(FinishPhysical);
}

}  // namespace snell::io
