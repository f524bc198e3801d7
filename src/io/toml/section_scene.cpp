// SPDX-License-Identifier: Apache-2.0
//
// The tables that a scene has once, what a file and a group may hold, and the list of all sections.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "io/toml/sections.h"

namespace snell::io {

using scene::Integrator;
using scene::LightSampling;
using scene::PixelFilter;
using scene::RenderSettings;

// --- [render] -----------------------------------------------------------------------------------------------

static Keys<RenderSettings> SamplingKeys() {
  const auto integrators =
      Choice<Integrator>({{"whitted", Integrator::Whitted}, {"path", Integrator::Path}});
  return {
      Field("spp", &RenderSettings::spp, Integer(1, 1 << 20), "Samples per pixel.")
          .Standard("`16`, by paths `64`")
          .Not({"samples", "samples_per_pixel"}),
      Field("seed", &RenderSettings::seed, Seed(), "Another number gives other noise."),
      Field("integrator", &RenderSettings::integrator, integrators,
            "How light is followed: a tree of mirrored and refracted rays, or paths with all "
            "reflections between surfaces.")
          .Standard("`\"path\"` if an object has a physical material, else `\"whitted\"`"),
      Field("max_depth", &RenderSettings::maxDepth, Integer(1, 1000),
            "Longest chain of rays; 1: rays from the camera only.")
          .Not({"depth", "recursion", "max_recursion", "bounces"}),
      Field("max_volume_depth", &RenderSettings::maxVolumeDepth, Integer(0, 1000000),
            "How often a path may be scattered within media and below surfaces.")
          .Not({"volume_bounces", "volume_depth"}),
      Field("max_diffuse_depth", &RenderSettings::maxDiffuseDepth, Integer(0, 1000),
            "Path tracer: how often a path may be reflected by matt surfaces; 1: they show direct "
            "light only.")
          .Standard("any")
          .Not({"diffuse_bounces", "diffuse_depth"}),
      Field("max_specular_depth", &RenderSettings::maxSpecularDepth, Integer(0, 1000),
            "Path tracer: how often it may be reflected by mirrors, smooth or glossy.")
          .Standard("any")
          .Not({"glossy_bounces", "specular_bounces", "specular_depth", "max_glossy_depth"}),
      Field("max_transmission_depth", &RenderSettings::maxTransmissionDepth, Integer(0, 1000),
            "Path tracer: how often it may pass through surfaces; a body of glass has two.")
          .Standard("any")
          .Not({"transmission_bounces", "refraction_depth"}),
      Field("caustics", &RenderSettings::caustics,
            Choice<scene::Caustics>({{"full", scene::Caustics::Full},
                                     {"regularized", scene::Caustics::Regularized},
                                     {"none", scene::Caustics::None}}),
            "Path tracer: light that mirrors and glass throw onto rough surfaces: all of it, with "
            "noise; blurred, with little noise and some error; or none, which is darker.")
          .Not({"caustic", "regularize", "filter_glossy"}),
      Field("min_contribution", &RenderSettings::minContribution, Number({0, 1}),
            "Reflected and refracted rays that can add less than this to a pixel are not followed.")
          .Not({"cutoff", "threshold"}),
      Field("clamp_indirect", &RenderSettings::clampIndirect, Number(NotNegative, "W/(sr·m²)"),
            "Path tracer: the most that indirect light adds to a pixel at once, 0: any. Removes "
            "fireflies and with them some light; how much is told.")
          .Not({"clamp", "firefly_clamp", "max_radiance"}),
      Field("shadows", &RenderSettings::tintedShadows,
            Choice<bool>({{"tinted", true}, {"opaque", false}}),
            "Whether clear materials colour the light that they let through, or block it."),
      Field("light_sampling", &RenderSettings::lightSampling,
            Choice<LightSampling>({{"tree", LightSampling::Tree}, {"power", LightSampling::Power}}),
            "How the path tracer chooses among lights and what glows: by what each can bring to a "
            "point, or by power alone, as a measure of what the former saves.")};
}

static Keys<RenderSettings> PictureKeys() {
  const auto filters = Choice<PixelFilter>({{"box", PixelFilter::Box},
                                            {"tent", PixelFilter::Tent},
                                            {"gaussian", PixelFilter::Gaussian},
                                            {"blackman-harris", PixelFilter::BlackmanHarris}});
  const auto samplers = Choice<scene::Sampler>(
      {{"sobol", scene::Sampler::Sobol}, {"independent", scene::Sampler::Independent}});
  return {
      Field("sampler", &RenderSettings::sampler, samplers,
            "The path tracer's samples: of a sequence that covers pixels and lights evenly, or "
            "random numbers, "
            "which take more samples to the same picture."),
      Field("filter", &RenderSettings::filter, filters, "How samples are weighted around a pixel."),
      Field("filter_radius", &RenderSettings::filterRadius, Number({0, 16}, "pixels"),
            "Radius of the filter; 0: the usual one of its kind."),
      Field("exposure", &RenderSettings::exposure, Number({-32, 32}, "stops"),
            "Brightens pictures that are not linear; 1 doubles."),
      Field("view", &RenderSettings::view, Choice<image::View>(image::ViewNames()),
            "How pictures that are not linear show what is brighter than white.")
          .Not({"view_transform", "tone_mapping", "tonemap"})};
}

static void FinishRender(Reader&, const Fields&, RenderDraft& draft) {
  for (const scene::Aov aov : draft.aovs) draft.settings.aovs.Add(aov);
  draft.settings.width = draft.size[0];
  draft.settings.height = draft.size[1];
}

const SectionOf<RenderDraft>& RenderSection() {
  const auto size =
      Field("size", &RenderDraft::size, ImageSize(), "Width and height of the picture.")
          .Not({"resolution", "width", "height", "image_size"});
  const auto aovs =
      Field("aovs", &RenderDraft::aovs,
            ListOf(Choice<scene::Aov>(scene::AovNames()), "names of layers"),
            "Layers that an EXR holds besides the picture: those of `docs/aovs.md`, or \"all\".")
          .Standard("none")
          .Example("[\"albedo\", \"normal\", \"depth\"]")
          .Not({"aov", "passes", "layers"});
  static const SectionOf<RenderDraft> section =
      SectionOf<RenderDraft>("render", "[render]",
                             "How the picture is made. The command line overrides it.",
                             Join<RenderDraft>({{size},
                                                Within(&RenderDraft::settings, SamplingKeys()),
                                                Within(&RenderDraft::settings, PictureKeys()),
                                                {aovs}}))
          .Checked(FinishRender);
  return section;
}

// --- What a file and a group may hold -----------------------------------------------------------------------

// A key that the reader of files takes itself: only described here.
template <class Draft>
static KeyOf<Draft> Described(std::string name, std::string expected, std::string schema,
                              std::string text, std::vector<std::string> mistakes) {
  KeyOf<Draft> key;
  key.name = std::move(name);
  key.expected = std::move(expected);
  key.schema = std::move(schema);
  key.text = std::move(text);
  key.mistakes = std::move(mistakes);
  return key;
}

static std::string Reference(const char* name) {
  return fmt::format(R"({{"$ref": "#/definitions/{}"}})", name);
}
static std::string ListOfThem(const char* name) {
  return fmt::format(R"({{"type": "array", "items": {}}})", Reference(name));
}
static std::string ByName(const char* name) {
  return fmt::format(R"({{"type": "object", "additionalProperties": {}}})", Reference(name));
}

const SectionOf<FileDraft>& FileSection() {
  using Draft = FileDraft;
  static const SectionOf<Draft> section(
      "file", "The file",
      "The tables that a scene file may hold, all of them optional, in any order.",
      {Described<Draft>(
           "include", "a file name or a list of file names",
           R"({"anyOf": [{"type": "string"}, {"type": "array", "items": {"type": "string"}}]})",
           "Other scene files, relative to this one, whose tables are added. Where both say "
           "something about [render], [camera] or [environment], this file's keys win.",
           {"includes", "import"}),
       Described<Draft>("render", "a table", Reference("render"), "How the picture is made.",
                        {"settings", "film"}),
       Described<Draft>(
           "camera", "a table, or several",
           fmt::format(R"({{"anyOf": [{}, {}]}})", Reference("camera"), ListOfThem("camera")),
           "Where the picture is taken from.", {"cameras"}),
       Described<Draft>("environment", "a table", Reference("environment"),
                        "What is behind everything.", {"background", "sky", "world"}),
       Described<Draft>("light", "several tables", ListOfThem("light"), "Sources of light.",
                        {"lights"}),
       Described<Draft>("object", "several tables", ListOfThem("object"), "Things in the scene.",
                        {"objects", "shape"}),
       Described<Draft>("group", "tables by name", ByName("group"),
                        "Objects and lights to be placed together.", {"groups"}),
       Described<Draft>("material", "tables by name", ByName("material"),
                        "What surfaces are made of.", {"materials"}),
       Described<Draft>("texture", "tables by name", ByName("texture"), "Patterns.",
                        {"textures"})});
  return section;
}

const SectionOf<GroupDraft>& GroupSection() {
  using Draft = GroupDraft;
  static const SectionOf<Draft> section(
      "group", "[group.NAME]",
      "Objects and lights that are placed together, as often as needed: `[[group.tree.object]]` "
      "defines members, `[[object]]` with `group = \"tree\"` places them. Groups may contain "
      "groups.",
      {Described<Draft>("object", "several tables", ListOfThem("object"),
                        "The members, as `[[object]]`.", {"objects"}),
       Described<Draft>("light", "several tables", ListOfThem("light"),
                        "Lights that move with the group, as `[[light]]`.", {"lights"})});
  return section;
}

const std::vector<const Section*>& AllSections() {
  static const std::vector<const Section*> sections = {
      &FileSection(),     &RenderSection(),        &CameraSection(),    &EnvironmentSection(),
      &SkySection(),      &LightSection(),         &ObjectSection(),    &MeshSection(),
      &GroupSection(),    &TransformStepSection(), &RotationSection(),  &LookAtSection(),
      &MaterialSection(), &SubdivisionSection(),   &CreaseSection(),    &DisplacementSection(),
      &TermSection(),     &MediumSection(),        &TextureSection(),   &TintSection(),
      &ChannelSection(),  &MotionKeySection(),     &CameraKeySection(), &ShapeKeySection()};
  return sections;
}

}  // namespace snell::io
