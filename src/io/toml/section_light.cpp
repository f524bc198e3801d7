// SPDX-License-Identifier: Apache-2.0
//
// [[light]]: the kinds of light, and placing them by the transforms of groups.
#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "io/toml/sections.h"

namespace snell::io {

using glm::dvec3;
using scene::Falloff;
using scene::Light;
using scene::LightKind;

static constexpr double Pi = 3.14159265358979323846;
static constexpr float Degree = float(Pi / 180);

// --- Checks -------------------------------------------------------------------------------------------------

static void AimAt(Reader& reader, const Fields& fields, LightDraft& draft) {
  if (!draft.lookAt) return;
  const dvec3 way = dvec3(*draft.lookAt) - dvec3(draft.light.position);
  if (glm::length(way) > 0)
    draft.light.direction = vec3(glm::normalize(way));
  else
    reader.Report(fmt::format("'look_at' is the light's own position in {}", fields.title),
                  fields.PlaceOf("look_at"));
}

static void CheckPoint(Reader& reader, const Fields& fields, LightDraft& draft) {
  AimAt(reader, fields, draft);
  FinishProfile(reader, fields, draft);
}

static void CheckSpot(Reader& reader, const Fields& fields, LightDraft& draft) {
  CheckPoint(reader, fields, draft);
  draft.light.innerAngle = draft.innerAngle.value_or(0.8f * draft.light.outerAngle);
  if (draft.light.innerAngle > draft.light.outerAngle)
    reader.Report(fmt::format("'inner_angle' is larger than 'outer_angle' ({:.4g}) in {}",
                              draft.light.outerAngle / Degree, fields.title),
                  fields.PlaceOf("inner_angle"));
}

static void CheckRectangle(Reader& reader, const Fields& fields, LightDraft& draft) {
  if (HaveNoArea(draft.light.edgeU, draft.light.edgeV))
    reader.Report(fmt::format("'edge_u' and 'edge_v' are parallel in {}", fields.title),
                  fields.PlaceOf("edge_v"));
}

static void CheckTriangle(Reader& reader, const Fields& fields, LightDraft& draft) {
  draft.light.position = draft.vertices[0];
  draft.light.edgeU = draft.vertices[1] - draft.vertices[0];
  draft.light.edgeV = draft.vertices[2] - draft.vertices[0];
  if (HaveNoArea(draft.light.edgeU, draft.light.edgeV))
    reader.Report(fmt::format("the triangle has no area in {}", fields.title),
                  fields.PlaceOf("vertices"));
}

// --- Keys that several kinds share --------------------------------------------------------------------------

// Light's keys as the draft's.
static Keys<LightDraft> In(const Keys<Light>& keys) { return Within(&LightDraft::light, keys); }

static Keys<LightDraft> StrengthKey(const char* name, const char* unit, const char* text) {
  std::vector<std::string> mistakes;
  for (const char* word :
       {"strength", "brightness", "energy", "emission", "intensity", "irradiance", "radiance"})
    if (std::string(word) != name) mistakes.emplace_back(word);
  if (std::string(name) != "radiance") mistakes.emplace_back("power");
  return In({Field(name, &Light::strength, Number(NotNegative, unit), text).Not(mistakes)});
}

static KeyOf<Light> CenterKey() {
  return Field("center", &Light::position, Point(), "The centre.").Not({"position", "pos"});
}

static KeyOf<Light> RadiusKey() {
  return Field("radius", &Light::radius, Number(Positive, "m"), "The radius.").Not({"size", "r"});
}

static KeyOf<LightDraft> LookAtKey() {
  return Field("look_at", &LightDraft::lookAt, Point(), "A point to face, in place of a direction.")
      .Standard("none")
      .Not({"target", "to", "at", "lookat"});
}

static KeyOf<Light> SamplesKey() {
  return Field("samples", &Light::samples, Integer(1, 4096),
               "Shadow rays for each ray that meets a surface; more make soft shadows smoother.")
      .Not({"spp", "shadow_samples", "rays"});
}

static Keys<LightDraft> FalloffKeys() {
  const auto falloff = Choice<Falloff>({{"none", Falloff::None},
                                        {"linear", Falloff::Linear},
                                        {"inverse-square", Falloff::InverseSquare}});
  return In({Field("falloff", &Light::falloff, falloff,
                   "How the light fades with distance: not at all, by 1 / (distance · "
                   "`falloff_factor`) as in the classic teaching model, or by 1 / distance² as in "
                   "nature.")
                 .Not({"attenuation", "decay"}),
             Field("falloff_factor", &Light::falloffFactor, Number(Positive),
                   "The factor of the linear falloff."),
             Field("range", &Light::range, Number(NotNegative, "m"),
                   "The light fades smoothly to nothing at this distance; 0: no end.")
                 .Not({"distance", "max_distance"})});
}

static Keys<LightDraft> PointKeys() {
  const auto position = Field("position", &Light::position, Point(), "Where the light is.")
                            .Not({"center", "centre", "from", "pos", "location"});
  const auto radius = Field("radius", &Light::radius, Number(NotNegative, "m"),
                            "Makes the shadows soft, as a ball of this radius would.")
                          .Not({"size"});
  return Join<LightDraft>({In({position}),
                           StrengthKey("intensity", "W/sr",
                                       "Power per solid angle; with `ies`, of its brightest "
                                       "direction, in place of the file's candela at 683 lm/W."),
                           FalloffKeys(), In({radius, SamplesKey()}), ProfileKeys()});
}

static Keys<LightDraft> AreaKeys() {
  const auto power = Field("power", &LightDraft::power, Number(NotNegative, "W"),
                           "All the light that is sent out, in place of `radiance`.")
                         .Standard("by `radiance`")
                         .Not({"watts", "watt", "flux"});
  const auto visible = Field("visible", &Light::visible, Boolean(),
                             "Whether the camera and mirrors see the shining surface.")
                           .Not({"visible_to_camera"});
  return Join<LightDraft>({{power},
                           StrengthKey("radiance", "W/(sr·m²)",
                                       "Radiance of the lit side, the same in all directions."),
                           FalloffKeys(),
                           In({SamplesKey(), visible})});
}

// --- The kinds ----------------------------------------------------------------------------------------------

static VariantOf<LightDraft> AmbientLight() {
  return VariantOf<LightDraft>(
             "ambient",
             "The same light from everywhere, without shadows; `ambient` terms reflect it.",
             StrengthKey("radiance", "W/(sr·m²)", "Radiance from all directions."))
      .Begin([](LightDraft& draft) { draft.light.kind = LightKind::Ambient; });
}

static VariantOf<LightDraft> DirectionalLight() {
  const auto direction =
      Field("direction", &Light::direction, Direction(), "Where the light travels to.")
          .Not({"dir", "to"});
  const auto irradiance =
      StrengthKey("irradiance", "W/m²",
                  "Power that falls on a surface that faces the light; with 3.14 a white matt one "
                  "looks white.");
  const auto size = Field("angular_size", &Light::angularSize, Degrees({0, 180}),
                          "Diameter as seen from the scene; the sun's is 0.53. 0: sharp shadows.")
                        .Not({"angle", "size", "radius", "softness"});
  const auto visible = Field("visible", &Light::visible, Boolean(),
                             "Whether the path tracer's camera and mirrors see its disc.");
  return VariantOf<LightDraft>(
             "directional", "Parallel light from far away, such as the sun's.",
             Join<LightDraft>({In({direction}), irradiance, In({size, SamplesKey(), visible})}))
      .Begin([](LightDraft& draft) { draft.light.kind = LightKind::Directional; });
}

static VariantOf<LightDraft> PointLight() {
  const auto direction = Field("direction", &Light::direction, Direction(),
                               "Where the lamp of `ies` points: its vertical angle 0.");
  return VariantOf<LightDraft>("point", "Shines from a point in all directions.",
                               Join<LightDraft>({PointKeys(), In({direction}), {LookAtKey()}}))
      .Begin([](LightDraft& draft) { draft.light.kind = LightKind::Point; })
      .Checked(CheckPoint);
}

static VariantOf<LightDraft> SpotLight() {
  const auto direction =
      Field("direction", &Light::direction, Direction(), "The axis of the cone.").Not({"dir"});
  const auto outer = Field("outer_angle", &Light::outerAngle, Degrees({0.01, 180}),
                           "From the axis to where the light ends.")
                         .Not({"angle", "cutoff", "cone_angle", "cone", "fov"});
  const auto inner = Field("inner_angle", &LightDraft::innerAngle, Degrees({0, 180}),
                           "From the axis to where the light begins to fade.")
                         .Standard("0.8 · `outer_angle`")
                         .Not({"blend", "penumbra"});
  return VariantOf<LightDraft>(
             "spot", "A point light with a cone.",
             Join<LightDraft>({PointKeys(), In({direction}), {LookAtKey()}, In({outer}), {inner}}))
      .Begin([](LightDraft& draft) {
        draft.light.kind = LightKind::Spot;
        draft.light.outerAngle = 30 * Degree;
      })
      .Checked(CheckSpot);
}

static VariantOf<LightDraft> RectangleLight() {
  const auto corner = Field("corner", &Light::position, Point(), "One corner.")
                          .Required()
                          .Not({"position", "center"});
  const auto edgeU = Field("edge_u", &Light::edgeU, NotZero("m"), "From the corner to the next.")
                         .Required()
                         .Example("[1, 0, 0]")
                         .Not({"u"});
  const auto edgeV =
      Field("edge_v", &Light::edgeV, NotZero("m"), "From the corner to the other next.")
          .Required()
          .Example("[0, 0, 1]")
          .Not({"v"});
  return VariantOf<LightDraft>("rectangle",
                               "A parallelogram that shines towards `edge_u` × `edge_v`.",
                               Join<LightDraft>({In({corner, edgeU, edgeV}), AreaKeys()}))
      .Begin([](LightDraft& draft) { draft.light.kind = LightKind::Rectangle; })
      .Checked(CheckRectangle);
}

static VariantOf<LightDraft> TriangleLight() {
  const auto vertices =
      Field("vertices", &LightDraft::vertices, ListOf(Point(), "points", 3, 3), "The corners.")
          .Required()
          .Example("[[0, 2, 0], [1, 2, 0], [0, 2, 1]]")
          .Not({"points", "positions"});
  return VariantOf<LightDraft>(
             "triangle", "Shines to the side from which its vertices count counter-clockwise.",
             Join<LightDraft>({{vertices}, AreaKeys()}))
      .Begin([](LightDraft& draft) { draft.light.kind = LightKind::Triangle; })
      .Checked(CheckTriangle);
}

static VariantOf<LightDraft> DiskLight() {
  const auto normal =
      Field("normal", &Light::direction, Direction(), "The side that shines.").Not({"direction"});
  return VariantOf<LightDraft>(
             "disk", "Shines to the side of its normal.",
             Join<LightDraft>(
                 {In({CenterKey(), normal}), {LookAtKey()}, In({RadiusKey()}), AreaKeys()}))
      .Begin([](LightDraft& draft) {
        draft.light.kind = LightKind::Disk;
        draft.light.radius = 0.5f;
      })
      .Checked(AimAt);
}

static VariantOf<LightDraft> SphereLight() {
  return VariantOf<LightDraft>("sphere", "Shines outwards.",
                               Join<LightDraft>({In({CenterKey(), RadiusKey()}), AreaKeys()}))
      .Begin([](LightDraft& draft) {
        draft.light.kind = LightKind::Sphere;
        draft.light.radius = 0.5f;
      });
}

const SectionOf<LightDraft>& LightSection() {
  static const SectionOf<LightDraft> section =
      SectionOf<LightDraft>(
          "light", "[[light]]",
          "A source of light. Area lights shine from one side, spheres outwards.",
          In({Field("name", &Light::name, Text("sun"), "For messages.").Standard("none"),
              Field("color", &Light::color, Color(Brightness::Unlimited),
                    "Multiplies the strength.")
                  .Not({"colour", "rgb", "tint"}),
              Field("light_group", &Light::group, LightGroupName(),
                    "Sources of one name are told apart from others in a layer of their own, if "
                    "`light_groups` is among the AOVs.")
                  .Standard("none")
                  .Not({"group"})}))
          .Variants("type", {AmbientLight(), DirectionalLight(), PointLight(), SpotLight(),
                             RectangleLight(), TriangleLight(), DiskLight(), SphereLight()})
          .OnlyOne({{"direction"}, {"look_at"}})
          .OnlyOne({{"normal"}, {"look_at"}})
          .OnlyOne({{"radiance"}, {"power"}});
  return section;
}

// --- Placing ------------------------------------------------------------------------------------------------

static double AreaOf(const Light& light) {
  const double parallelogram = glm::length(glm::cross(dvec3(light.edgeU), dvec3(light.edgeV)));
  const double square = double(light.radius) * double(light.radius);
  switch (light.kind) {
    case LightKind::Rectangle: return parallelogram;
    case LightKind::Triangle: return 0.5 * parallelogram;
    case LightKind::Disk: return Pi * square;
    case LightKind::Sphere: return 4 * Pi * square;
    default: return 0;
  }
}

// The factor of a map that scales the same in all directions, or 0.
static double UniformScale(const Affine& map) {
  const dvec3 x(map[0]), y(map[1]), z(map[2]);
  const double scale = glm::length(x);
  const double tolerance = 1e-5 * scale;
  const bool equal =
      std::abs(glm::length(y) - scale) < tolerance && std::abs(glm::length(z) - scale) < tolerance;
  const bool square = std::abs(glm::dot(x, y)) < tolerance * scale &&
                      std::abs(glm::dot(y, z)) < tolerance * scale &&
                      std::abs(glm::dot(z, x)) < tolerance * scale;
  return equal && square ? scale : 0;
}

static bool IsFinite(const vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool PlaceLight(Reader& reader, const LightDraft& draft, const Affine& toWorld, const Place& place,
                Light& light) {
  light = draft.light;
  if (toWorld != Affine(1.0)) {
    const auto vector = [&](const vec3& v) { return vec3(glm::dmat3(toWorld) * dvec3(v)); };
    light.position = vec3(toWorld * glm::dvec4(dvec3(light.position), 1.0));
    light.edgeU = vector(light.edgeU);
    light.edgeV = vector(light.edgeV);
    light.direction = vec3(glm::normalize(glm::dmat3(toWorld) * dvec3(light.direction)));

    // Mirroring would turn the lit side: exchange the edges, and a triangle's corners with them
    if (glm::determinant(glm::dmat3(toWorld)) < 0 && light.profile < 0)
      std::swap(light.edgeU, light.edgeV);

    if (!IsFinite(light.position) || !IsFinite(light.edgeU) || !IsFinite(light.edgeV)) {
      reader.Report("the light is moved out of all bounds by its groups", place);
      return false;
    }

    const bool round = light.radius > 0;
    const double scale = UniformScale(toWorld);
    if (round && scale == 0) {
      reader.Report("a round light cannot be scaled unevenly by its groups", place);
      return false;
    }
    if (round) light.radius = float(double(light.radius) * scale);
  }

  // A lambertian surface sends out π times its radiance from each square metre
  if (draft.power) light.strength = float(double(*draft.power) / (Pi * AreaOf(light)));
  if (std::isfinite(light.strength)) return true;
  reader.Report("the light's area is too small for its power", place);
  return false;
}

}  // namespace snell::io
