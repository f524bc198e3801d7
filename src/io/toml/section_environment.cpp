// SPDX-License-Identifier: Apache-2.0
//
// [environment]: one colour, a gradient, a map, or a sky that is computed.
#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "io/images.h"
#include "io/toml/sections.h"
#include "scene/sky/sun_position.h"
#include "util/file.h"

namespace snell::io {

using scene::Environment;

static constexpr float Degree = 0.0174532925199f;

// --- sky = { … } --------------------------------------------------------------------------------------------

static void CheckSky(Reader& reader, const Fields& fields, SkyDraft& draft) {
  draft.model.turbidity = double(draft.turbidity);
  draft.model.ground = draft.ground;
  draft.model.sun = draft.sun;
  draft.model.elevation = double(draft.elevation);
  draft.model.azimuth = double(draft.azimuth);
  if (draft.direction) {
    const glm::dvec3 toSun = glm::normalize(glm::dvec3(*draft.direction));
    draft.model.elevation = std::asin(std::clamp(toSun.y, -1.0, 1.0));
    draft.model.azimuth = std::atan2(toSun.x, -toSun.z);
  }
  const bool hasPlace = draft.latitude && draft.longitude;
  if (draft.time && hasPlace) {
    const auto sun = scene::SunAt(*draft.time, double(*draft.latitude), double(*draft.longitude));
    draft.model.elevation = sun.elevation;
    draft.model.azimuth = sun.azimuth;
  } else if (draft.time || draft.latitude || draft.longitude) {
    reader.Report(
        fmt::format("'time', 'latitude' and 'longitude' belong together in {}", fields.title),
        fields.place);
  }
}

static Type<double> Time() {
  Type<double> type;
  type.expected = "a time such as \"2026-06-21T12:00:00+02:00\", with its distance to UTC";
  type.schema = R"({"type": "string"})";
  type.example = "\"2026-06-21T12:00:00+02:00\"";
  type.read = [expected = type.expected](Reader& reader, const Node& value, double& days) {
    const auto text = value.String();
    const auto read = text ? scene::DaysOf(*text) : std::nullopt;
    if (read) days = *read;
    return read || reader.Refuse(value, expected);
  };
  return type;
}

static Keys<SkyDraft> SunKeys() {
  return {
      Field("elevation", &SkyDraft::elevation, Degrees({-90, 90}), "Of the sun above the horizon."),
      Field("azimuth", &SkyDraft::azimuth, Degrees({-360, 360}),
            "Of the sun, from north (−z) by east (+x)."),
      Field("direction", &SkyDraft::direction, Direction(), "Towards the sun, in place of the two.")
          .Standard("by `elevation` and `azimuth`"),
      Field("time", &SkyDraft::time, Time(),
            "When the sun stands where it is seen from `latitude` and `longitude`, in place of "
            "its angles.")
          .Standard("none")
          .Not({"date", "date_time"}),
      Field("latitude", &SkyDraft::latitude, Degrees({-90, 90}), "North is positive.")
          .Standard("none"),
      Field("longitude", &SkyDraft::longitude, Degrees({-180, 180}), "East is positive.")
          .Standard("none")};
}

const SectionOf<SkyDraft>& SkySection() {
  static const SectionOf<SkyDraft> section =
      SectionOf<SkyDraft>(
          "sky", "sky",
          "A clear sky, computed from the optics of air, haze and ozone, with the sun as a "
          "directional light. Its watts are weighted by the eye: 1 W stands for 683 lm, so that "
          "noon brings some 170 W/m² (115,000 lux) and wants an `exposure` of about −5.",
          Join<SkyDraft>({SunKeys(),
                          {Field("turbidity", &SkyDraft::turbidity, Number({1, 15}),
                                 "Haze: 1 is pure air, 2 to 3 a clear day, 10 thick haze.")
                               .Example("3"),
                           Field("ground", &SkyDraft::ground, Color(Brightness::Reflectance),
                                 "Reflectance of the ground, which is seen below the horizon.")
                               .Not({"albedo", "ground_albedo"}),
                           Field("sun", &SkyDraft::sun, Boolean(),
                                 "Whether the sun itself shines, or the sky alone.")}}))
          .OnlyOne({{"elevation", "azimuth"}, {"direction"}, {"time", "latitude", "longitude"}})
          .Checked(CheckSky);
  return section;
}

// --- [environment] ------------------------------------------------------------------------------------------

static void CheckEnvironment(Reader& reader, const Fields& fields, EnvironmentDraft& draft) {
  Environment& environment = draft.environment;
  if (draft.color) environment.bottom = environment.top = *draft.color;
  environment.bottom *= draft.strength;
  environment.top *= draft.strength;
  environment.mapScale = Spectrum(draft.strength);
  if (environment.bottomElevation < environment.topElevation) return;
  reader.Report(
      fmt::format("'bottom_elevation' is not less than 'top_elevation' in {}", fields.title),
      fields.PlaceOf(fields.Find("top_elevation") ? "top_elevation" : "bottom_elevation"));
}

static Keys<Environment> GradientKeys() {
  return {Field("bottom", &Environment::bottom, Color(Brightness::Unlimited),
                "Radiance at and below `bottom_elevation`.")
              .Not({"bottom_color", "ground", "low"}),
          Field("top", &Environment::top, Color(Brightness::Unlimited),
                "Radiance at and above `top_elevation`.")
              .Not({"top_color", "high"}),
          Field("bottom_elevation", &Environment::bottomElevation, Degrees({-90, 90}),
                "Angle above the horizon where the gradient begins."),
          Field("top_elevation", &Environment::topElevation, Degrees({-90, 90}),
                "Angle above the horizon where the gradient ends.")};
}

static Keys<EnvironmentDraft> SourceKeys() {
  Keys<EnvironmentDraft> keys = {
      Field("map", &EnvironmentDraft::map, SceneFile("sky.hdr"),
            "A picture of all directions (equirectangular, twice as wide as high), in W/(sr·m²): "
            "its middle is seen towards −z, its right half on the side of +x.")
          .Standard("none")
          .Not({"file", "image", "texture", "hdri"}),
      Field("sky", &EnvironmentDraft::sky,
            TableOf(SkySection, "a table such as { elevation = 30 }"), "A clear sky with the sun.")
          .Standard("none")
          .Example("{ elevation = 30 }"),
      Field("strength", &EnvironmentDraft::strength, Number(NotNegative),
            "Multiplies the radiance of whatever the environment is.")
          .Not({"intensity", "scale", "brightness"})};
  const auto rotation =
      Field("rotation", &Environment::rotation, Degrees({-3600, 3600}),
            "Turns the map or the sky with its sun about the y axis, counter-clockwise from above.")
          .Not({"rotate", "angle"});
  const auto visible = Field("visible", &Environment::visible, Boolean(),
                             "Whether the camera sees it; mirrors do in any case.");
  return Join<EnvironmentDraft>(
      {keys, Within(&EnvironmentDraft::environment, Keys<Environment>{rotation, visible})});
}

const SectionOf<EnvironmentDraft>& EnvironmentSection() {
  const auto color = Field("color", &EnvironmentDraft::color, Color(Brightness::Unlimited),
                           "Radiance from all directions, W/(sr·m²).")
                         .Standard("by `bottom` and `top`")
                         .Not({"radiance", "background", "colour"});
  const auto ior = Field("ior", &Environment::ior, Number({0.1, 10}),
                         "Index of refraction of the space around the objects.")
                       .Not({"index", "refractive_index", "index_of_refraction"});
  const auto medium =
      Field("medium", &Environment::medium, TableOf(MediumSection, "a table of a medium"),
            "What fills the space around the objects without end, such as fog; only the path "
            "tracer shows it.")
          .Standard("nothing")
          .Example("{ scattering = 0.05, absorption = 0.01 }")
          .Not({"fog", "volume", "atmosphere"});
  const auto group = Field("light_group", &Environment::lightGroup, LightGroupName(),
                           "Of its light, as a light's.")
                         .Standard("none")
                         .Not({"group"});
  static const SectionOf<EnvironmentDraft> section =
      SectionOf<EnvironmentDraft>(
          "environment", "[environment]",
          "What is behind everything: one colour, a gradient from bottom to top, a map or a sky. "
          "It is seen, also in mirrors. Surfaces are lit by it in the path tracer; in the classic "
          "integrator maps and skies count as ambient light of their mean.",
          Join<EnvironmentDraft>({{color},
                                  Within(&EnvironmentDraft::environment, GradientKeys()),
                                  SourceKeys(),
                                  Within(&EnvironmentDraft::environment, {ior, medium, group})}))
          .OnlyOne(
              {{"color"}, {"bottom", "top", "bottom_elevation", "top_elevation"}, {"map"}, {"sky"}})
          .Checked(CheckEnvironment);
  return section;
}

// --- Into the scene -----------------------------------------------------------------------------------------

static void LoadMap(Reader& reader, const Fields& fields, const EnvironmentDraft& draft) {
  const Place place = fields.PlaceOf("map");
  try {
    scene::Image map = DecodeTexels(ReadWithin(*draft.map, reader.limits), draft.map->string(),
                                    ImageUse::Color, reader.limits);
    if (map.width != 2 * map.height)
      reader.Warn(fmt::format("the map {} is not twice as wide as high and will look distorted",
                              draft.map->string()),
                  place, "maps are equirectangular pictures of all directions");
    reader.scene.environment.map = scene::ImageIndex(reader.scene.images.size());
    reader.scene.environment.ambient = true;
    reader.scene.images.push_back(std::move(map));
  } catch (const Error& error) {
    for (const Diagnostic& cause : error.diagnostics())
      reader.Report(fmt::format("cannot use the map {}: {}", ToString(cause.place), cause.message),
                    place, cause.hint);
  }
}

void PlaceEnvironment(Reader& reader, const Fields& fields, const EnvironmentDraft& draft) {
  reader.scene.environment = draft.environment;
  if (draft.map) LoadMap(reader, fields, draft);
  if (!draft.sky) return;
  if (draft.sky->model.elevation < -18 * double(Degree))
    reader.Warn("the sun is so far below the horizon that its sky is black", fields.PlaceOf("sky"));
  scene::AddSky(draft.sky->model, draft.strength, reader.scene);
}

}  // namespace snell::io
