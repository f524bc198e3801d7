// SPDX-License-Identifier: Apache-2.0
//
// [material.NAME] and inline materials: the classic material as a stack of shader terms, and the types that
// stand for usual stacks. How the parts share the light: kernel/interface.h.
#include "io/toml/sections.h"

namespace snell::io {

using scene::Material;
using scene::ReflectionModel;
using scene::Term;
using scene::TermKind;

// Of the highlights that stand for the mirror image of a small light.
static constexpr float GlintExponent = 2000;

static Type<ColorInput> Reflectance() { return ColorOrTexture(Brightness::Reflectance); }

// --- Terms --------------------------------------------------------------------------------------------------

const SectionOf<Term>& TermSection() {
  const auto color = Field("color", &Term::color, Reflectance(), "The term's colour.")
                         .Not({"diffuse", "specular", "ambient"});
  const auto exponent =
      Field("exponent", &Term::exponent, Number({0, 1e6}), "How small and sharp the highlight is.")
          .Not({"shininess", "power", "n"});
  const auto normalized =
      Field("normalized", &Term::normalized, Boolean(),
            "Scale the highlight so that it conserves energy: the sharper, the brighter.");
  static const SectionOf<Term> section =
      SectionOf<Term>("term", "term", "A shader term of a classic material.", {color})
          .Variants(
              "type",
              {VariantOf<Term>("ambient", "Reflects the ambient lights.", {}).Begin([](Term& term) {
                 term.kind = TermKind::Ambient;
               }),
               VariantOf<Term>("diffuse", "Lambert's law: light that falls straight counts most.",
                               {})
                   .Begin([](Term& term) { term.kind = TermKind::Diffuse; }),
               VariantOf<Term>("phong", "A highlight around the mirror direction.",
                               {exponent, normalized})
                   .Begin([](Term& term) { term.kind = TermKind::Phong; }),
               VariantOf<Term>("blinn", "A highlight around the half-way direction.",
                               {exponent, normalized})
                   .Begin([](Term& term) { term.kind = TermKind::Blinn; })});
  return section;
}

// --- What the types stand for -------------------------------------------------------------------------------

static void AddTerm(MaterialDraft& draft, TermKind kind, const ColorInput& color) {
  if (color.value == Spectrum(0.0f)) return;
  Term term{kind, color};
  if (kind == TermKind::Phong || kind == TermKind::Blinn) {
    term.exponent = draft.shininess;
    term.normalized = draft.normalized;
  }
  draft.material.terms.push_back(term);
}

static void FinishDiffuse(Reader&, const Fields&, MaterialDraft& draft) {
  AddTerm(draft, TermKind::Ambient, draft.ambient.value_or(draft.diffuse));
  AddTerm(draft, TermKind::Diffuse, draft.diffuse);
}

static void FinishPhong(Reader& reader, const Fields& fields, MaterialDraft& draft) {
  FinishDiffuse(reader, fields, draft);
  AddTerm(draft, TermKind::Phong, draft.specular);
}

static void FinishBlinn(Reader& reader, const Fields& fields, MaterialDraft& draft) {
  FinishDiffuse(reader, fields, draft);
  AddTerm(draft, TermKind::Blinn, draft.specular);
}

// Dielectrics, mirrors and metals.
static void FinishGlint(Reader&, const Fields&, MaterialDraft& draft) {
  draft.normalized = true;
  AddTerm(draft, TermKind::Phong, draft.specular);
}

static void FinishMaterial(Reader& reader, const Fields& fields, MaterialDraft&) {
  if (fields.Find("attenuation_color") && !fields.Find("attenuation_distance"))
    reader.Warn("'attenuation_color' has no effect without 'attenuation_distance'",
                fields.PlaceOf("attenuation_color"));
}

// --- Keys ---------------------------------------------------------------------------------------------------

using MaterialKeys = Keys<MaterialDraft>;

// Material's keys as the draft's.
static MaterialKeys In(const Keys<Material>& keys) {
  return Within(&MaterialDraft::material, keys);
}

static KeyOf<MaterialDraft> PresetKey() {
  std::vector<std::pair<std::string, std::string>> names;
  for (const Preset& preset : Presets()) names.emplace_back(preset.name, preset.name);
  return Field("preset", &MaterialDraft::preset, Choice<std::string>(names),
               "Start from a ready material, in place of `type`; further keys change it.")
      .Standard("none")
      .Example("\"plastic\"")
      .Not({"base", "template"});
}

static MaterialKeys CommonKeys() {
  const auto emission =
      Field("emission", &Material::emission, ColorOrTexture(Brightness::Unlimited),
            "The radiance with which the surface glows, W/(sr·m²); with `integrator = \"whitted\"` "
            "it "
            "lights nothing else.")
          .Not({"emissive", "glow", "radiance"});
  const auto group = Field("light_group", &Material::lightGroup, LightGroupName(),
                           "Of what the surface emits, as a light's.")
                         .Standard("none")
                         .Not({"group"});
  const auto thin =
      Field("thin", &Material::thin, Boolean(),
            "A sheet without an inside, such as a window pane: light passes straight through.")
          .Not({"thin_walled"});
  const auto ior =
      Field("ior", &Material::ior, Number({0.1, 10}), "Index of refraction of the inside.")
          .Not({"index", "refractive_index", "index_of_refraction", "eta", "refraction"});
  const auto color =
      Field("attenuation_color", &Material::attenuationColor, Color(Brightness::Reflectance),
            "What is left of white light after `attenuation_distance` inside (Beer–Lambert).")
          .Not({"absorption_color", "absorption"});
  const auto distance =
      Field("attenuation_distance", &Material::attenuationDistance, Number(Positive, "m"),
            "The distance inside after which white light has `attenuation_color`.")
          .Standard("no absorption")
          .Not({"absorption_distance"});
  const auto priority =
      Field("priority", &Material::priority, Integer(-1000, 1000),
            "Where insides overlap, the material with the higher priority fills the space.");
  return Join<MaterialDraft>(
      {{PresetKey()}, In({emission, group, thin, ior, color, distance, priority}), MapKeys()});
}

static MaterialKeys ReflectionKeys() {
  const auto models = Choice<ReflectionModel>({{"constant", ReflectionModel::Constant},
                                               {"fresnel", ReflectionModel::Fresnel},
                                               {"schlick", ReflectionModel::Schlick}});
  return In(
      {Field("reflectivity", &Material::reflectivity, Reflectance(),
             "How much the surface mirrors.")
           .Not({"reflectance", "mirror", "reflective"}),
       Field(
           "reflection", &Material::reflection, models,
           "How `reflectivity` changes with the angle: not at all, as a factor of Fresnel's "
           "reflectance for `ior`, or rising from its value at normal incidence to 1 (Schlick).")});
}

static MaterialKeys TransparencyKeys() {
  return In({Field("transparency", &Material::transparency, Reflectance(),
                   "How much light enters the inside, where it is refracted by `ior`.")
                 .Not({"opacity", "alpha", "transmission", "transparent"})});
}

static KeyOf<MaterialDraft> AmbientKey(const char* standard) {
  return Field("ambient", &MaterialDraft::ambient, Reflectance(), "Colour under ambient lights.")
      .Standard(standard);
}

static MaterialKeys HighlightKeys() {
  return {Field("specular", &MaterialDraft::specular, Reflectance(), "Colour of the highlights."),
          Field("shininess", &MaterialDraft::shininess, Number({0, 1e6}),
                "How small and sharp the highlights are: the exponent.")
              .Not({"exponent", "glossiness", "roughness"})};
}

// `color` for what the classic material calls `name`.
static MaterialKeys ColorKey(ColorInput Material::*member, const char* name, const char* text) {
  return In({Field("color", member, Reflectance(), text).Not({name, "reflectance", "diffuse"})});
}

// --- Types --------------------------------------------------------------------------------------------------

static VariantOf<MaterialDraft> ClassicMaterial() {
  const auto list = ListOf(TableOf(TermSection, "{ type, color, … }"), "terms", 0, 64);
  const auto terms =
      Field("terms", &Material::terms, list, "The shader terms; their light is added.")
          .Standard("none")
          .Example("[{ type = \"diffuse\", color = 0.5 }, { type = \"phong\", exponent = 50 }]")
          .Not({"term", "shaders"});
  return VariantOf<MaterialDraft>(
      "classic", "An ordered stack of shader terms, any number of each kind.",
      Join<MaterialDraft>({In({terms}), ReflectionKeys(), TransparencyKeys()}));
}

static VariantOf<MaterialDraft> DiffuseMaterial() {
  const auto color =
      Field("color", &MaterialDraft::diffuse, Reflectance(), "The colour.").Not({"diffuse"});
  return VariantOf<MaterialDraft>(
             "diffuse", "Matt, by Lambert's law.",
             Join<MaterialDraft>(
                 {{color, AmbientKey("`color`")}, ReflectionKeys(), TransparencyKeys()}))
      .Checked(FinishDiffuse);
}

// Phong's and Blinn's.
static VariantOf<MaterialDraft> ShinyMaterial(const char* name, const char* text) {
  const auto diffuse =
      Field("diffuse", &MaterialDraft::diffuse, Reflectance(), "Colour of the matt base.")
          .Not({"color", "colour", "albedo", "base_color"});
  const auto normalized = Field("normalized", &MaterialDraft::normalized, Boolean(),
                                "Scale the highlights so that they conserve energy.");
  return VariantOf<MaterialDraft>(name, text,
                                  Join<MaterialDraft>({{diffuse, AmbientKey("`diffuse`")},
                                                       HighlightKeys(),
                                                       {normalized},
                                                       ReflectionKeys(),
                                                       TransparencyKeys()}))
      .Begin([](MaterialDraft& draft) { draft.specular = {Spectrum(0.3f)}; });
}

static VariantOf<MaterialDraft> DielectricMaterial() {
  const auto color =
      ColorKey(&Material::transparency, "transparency", "The colour of the light that enters.");
  return VariantOf<MaterialDraft>(
             "dielectric",
             "Clear, such as glass and water: reflects and refracts by Fresnel's equations.",
             Join<MaterialDraft>({color, HighlightKeys(), ReflectionKeys()}))
      .Begin([](MaterialDraft& draft) {
        draft.material.transparency = {Spectrum(1.0f)};
        draft.shininess = GlintExponent;
      })
      .Checked(FinishGlint);
}

static VariantOf<MaterialDraft> MirrorMaterial() {
  const auto color = ColorKey(&Material::reflectivity, "reflectivity", "The reflectance.");
  return VariantOf<MaterialDraft>("mirror", "Reflects the same at all angles.",
                                  Join<MaterialDraft>({color, HighlightKeys(), TransparencyKeys()}))
      .Begin([](MaterialDraft& draft) {
        draft.material.reflectivity = {Spectrum(1.0f)};
        draft.shininess = GlintExponent;
      })
      .Checked(FinishGlint);
}

static VariantOf<MaterialDraft> MetalMaterial() {
  const auto color =
      ColorKey(&Material::reflectivity, "reflectivity", "The reflectance at normal incidence.");
  return VariantOf<MaterialDraft>(
             "metal", "Reflects more towards grazing angles, by Schlick's approximation.",
             Join<MaterialDraft>({color, HighlightKeys(), TransparencyKeys()}))
      .Begin([](MaterialDraft& draft) {
        draft.material.reflectivity = {Spectrum(0.9f)};
        draft.material.reflection = ReflectionModel::Schlick;
        draft.shininess = GlintExponent;
      })
      .Checked(FinishGlint);
}

const SectionOf<MaterialDraft>& MaterialSection() {
  static const SectionOf<MaterialDraft> section =
      SectionOf<MaterialDraft>(
          "material", "[material.NAME]",
          "How a surface reflects, lets through and sends out light. A material stands under a "
          "name, or in place of one: `material = { type = \"mirror\" }`.",
          CommonKeys())
          .Variants("type",
                    {ClassicMaterial(), DiffuseMaterial(),
                     ShinyMaterial("phong", "Matt with Phong's highlights.").Checked(FinishPhong),
                     ShinyMaterial("blinn", "Matt with Blinn's highlights.").Checked(FinishBlinn),
                     DielectricMaterial(), MirrorMaterial(), MetalMaterial(), PhysicalMaterial(),
                     VolumeMaterial()},
                    "classic")
          .Base("preset")
          .Checked(FinishMaterial);
  return section;
}

}  // namespace snell::io
