// SPDX-License-Identifier: Apache-2.0
//
// The tables that a scene has once, what a file and a group may hold, and the list of all sections.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "io/toml/sections.h"

namespace snell::io {

using glm::dvec3;
using scene::Camera;
using scene::Integrator;
using scene::PixelFilter;
using scene::RenderSettings;

static constexpr float Degree = 0.0174532925199f;

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
      Field("min_contribution", &RenderSettings::minContribution, Number({0, 1}),
            "Reflected and refracted rays that can add less than this to a pixel are not followed.")
          .Not({"cutoff", "threshold"}),
      Field("shadows", &RenderSettings::tintedShadows,
            Choice<bool>({{"tinted", true}, {"opaque", false}}),
            "Whether clear materials colour the light that they let through, or block it.")};
}

static Keys<RenderSettings> PictureKeys() {
  const auto filters = Choice<PixelFilter>({{"box", PixelFilter::Box},
                                            {"tent", PixelFilter::Tent},
                                            {"gaussian", PixelFilter::Gaussian},
                                            {"blackman-harris", PixelFilter::BlackmanHarris}});
  return {
      Field("filter", &RenderSettings::filter, filters, "How samples are weighted around a pixel."),
      Field("filter_radius", &RenderSettings::filterRadius, Number({0, 16}, "pixels"),
            "Radius of the filter; 0: the usual one of its kind."),
      Field("exposure", &RenderSettings::exposure, Number({-32, 32}, "stops"),
            "Brightens pictures that are not linear; 1 doubles.")};
}

static void FinishRender(Reader&, const Fields&, RenderDraft& draft) {
  draft.settings.width = draft.size[0];
  draft.settings.height = draft.size[1];
}

const SectionOf<RenderDraft>& RenderSection() {
  const auto size =
      Field("size", &RenderDraft::size, ImageSize(), "Width and height of the picture.")
          .Not({"resolution", "width", "height", "image_size"});
  static const SectionOf<RenderDraft> section =
      SectionOf<RenderDraft>("render", "[render]",
                             "How the picture is made. The command line overrides it.",
                             Join<RenderDraft>({{size},
                                                Within(&RenderDraft::settings, SamplingKeys()),
                                                Within(&RenderDraft::settings, PictureKeys())}))
          .Checked(FinishRender);
  return section;
}

// --- [camera] -----------------------------------------------------------------------------------------------

// A point so far along the direction that the sum keeps the direction's digits.
static vec3 PointAhead(const vec3& position, const vec3& direction) {
  float distance = 1;
  for (int axis = 0; axis < 3; ++axis) distance = std::max(distance, std::abs(position[axis]));
  return position + direction * distance;
}

static void CheckCamera(Reader& reader, const Fields& fields, CameraDraft& draft) {
  Camera& camera = draft.camera;
  if (draft.direction) camera.lookAt = PointAhead(camera.position, *draft.direction);
  const dvec3 forward = dvec3(camera.lookAt) - dvec3(camera.position);
  if (!(glm::length(forward) > 0)) {
    reader.Report(fmt::format("the camera looks at its own position in {}", fields.title),
                  fields.PlaceOf(fields.Find("look_at") ? "look_at" : "position"));
    return;
  }
  const dvec3 side = glm::cross(glm::normalize(forward), glm::normalize(dvec3(camera.up)));
  if (!(glm::length(side) > 1e-6))
    reader.Report(fmt::format("'up' is parallel to the line of sight in {}", fields.title),
                  fields.PlaceOf("up"),
                  fields.Find("up") ? "" : "give another 'up', such as [0, 0, -1]");
}

// Camera's keys as the draft's.
static Keys<CameraDraft> In(const Keys<Camera>& keys) { return Within(&CameraDraft::camera, keys); }

static Keys<CameraDraft> ViewKeys() {
  const auto name =
      Field("name", &Camera::name, Text("front"), "For the command line.").Standard("none");
  const auto position = Field("position", &Camera::position, Point(), "Where the camera stands.")
                            .Not({"eye", "from", "origin", "pos", "location"});
  const auto lookAt =
      Field("look_at", &Camera::lookAt, Point(), "A point in the middle of the picture.")
          .Not({"target", "to", "at", "lookat", "center"});
  const auto direction = Field("direction", &CameraDraft::direction, Direction(),
                               "The line of sight, in place of `look_at`.")
                             .Standard("by `look_at`")
                             .Not({"forward", "dir"});
  const auto up = Field("up", &Camera::up, NotZero(""), "What points up in the picture.");
  return Join<CameraDraft>({In({name, position, lookAt}), {direction}, In({up})});
}

static VariantOf<CameraDraft> Pinhole() {
  const auto fov = Field("fov", &Camera::fov, Degrees({0, 180, true}), "Vertical angle of view.")
                       .Not({"angle", "field_of_view", "zoom"});
  return VariantOf<CameraDraft>("pinhole", "With perspective.", In({fov}))
      .Begin([](CameraDraft& draft) {
        draft.camera.kind = scene::CameraKind::Pinhole;
        draft.camera.fov = 40 * Degree;
      });
}

static VariantOf<CameraDraft> Orthographic() {
  const auto height = Field("height", &Camera::height, Number(Positive, "m"), "Height of the view.")
                          .Not({"size", "scale"});
  return VariantOf<CameraDraft>("orthographic", "Without perspective: parallel rays.", In({height}))
      .Begin([](CameraDraft& draft) { draft.camera.kind = scene::CameraKind::Orthographic; });
}

const SectionOf<CameraDraft>& CameraSection() {
  static const SectionOf<CameraDraft> section =
      SectionOf<CameraDraft>(
          "camera", "[camera]",
          "Where the picture is taken from. `[[camera]]` may stand several times; the first is "
          "used unless the command line names another. Without a camera, one is chosen that shows "
          "everything.",
          ViewKeys())
          .Variants("type", {Pinhole(), Orthographic()}, "pinhole")
          .OnlyOne({{"look_at"}, {"direction"}})
          .Checked(CheckCamera);
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
      &FileSection(),     &RenderSection(),        &CameraSection(),   &EnvironmentSection(),
      &SkySection(),      &LightSection(),         &ObjectSection(),   &MeshSection(),
      &GroupSection(),    &TransformStepSection(), &RotationSection(), &LookAtSection(),
      &MaterialSection(), &SubdivisionSection(),   &CreaseSection(),   &DisplacementSection(),
      &TermSection(),     &TextureSection(),       &TintSection(),     &ChannelSection()};
  return sections;
}

}  // namespace snell::io
