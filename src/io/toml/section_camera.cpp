// SPDX-License-Identifier: Apache-2.0
//
// [camera]: where it stands, its kinds, and lenses in the words of photographers.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "io/toml/sections.h"

namespace snell::io {

using glm::dvec3;
using scene::Camera;
using scene::FisheyeProjection;
using scene::Lens;

static constexpr float Degree = 0.0174532925199f;

// --- Checks -------------------------------------------------------------------------------------------------

vec3 PointAhead(const vec3& position, const vec3& direction) {
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
  if (glm::length(side) > 1e-6) {
    FinishCameraMotion(reader, fields, draft);
  } else {
    reader.Report(fmt::format("'up' is parallel to the line of sight in {}", fields.title),
                  fields.PlaceOf("up"),
                  fields.Find("up") ? "" : "give another 'up', such as [0, 0, -1]");
  }
}

// Where the lens is in focus: as told, or at the point that the camera looks at.
static void FinishFocus(Reader& reader, const Fields& fields, CameraDraft& draft) {
  Camera& camera = draft.camera;
  const dvec3 position(camera.position);
  const dvec3 sight = draft.direction ? dvec3(*draft.direction) : dvec3(camera.lookAt) - position;
  if (draft.focusDistance) {
    camera.lens.focusDistance = *draft.focusDistance;
  } else if (draft.focusAt) {
    const double ahead = glm::dot(dvec3(*draft.focusAt) - position, glm::normalize(sight));
    camera.lens.focusDistance = float(ahead);
    if (glm::length(sight) > 0 && !(camera.lens.focusDistance > 0))
      reader.Report(fmt::format("'focus_at' is not in front of the camera in {}", fields.title),
                    fields.PlaceOf("focus_at"));
  } else if (!draft.direction) {
    camera.lens.focusDistance = float(glm::length(sight));
  } else {
    reader.Report(fmt::format("nothing tells where the lens is in focus in {}", fields.title),
                  fields.place, "give 'focus_distance' or 'focus_at'");
  }
}

static void FinishLens(Reader& reader, const Fields& fields, CameraDraft& draft) {
  if (draft.camera.lens.blades == 1 || draft.camera.lens.blades == 2)
    reader.Report(
        fmt::format("an aperture has 3 blades or more, or is round (0) in {}", fields.title),
        fields.PlaceOf("blades"));
  if (draft.camera.lens.radius > 0) FinishFocus(reader, fields, draft);
}

static void FinishPinhole(Reader& reader, const Fields& fields, CameraDraft& draft) {
  Camera& camera = draft.camera;
  const double half = double(draft.sensorHeight) / 2;  // mm, as the focal length
  double focalLength = half / std::tan(double(camera.fov) / 2);
  if (draft.focalLength) {
    focalLength = double(*draft.focalLength);
    camera.fov = float(2 * std::atan(half / focalLength));
  } else if (draft.horizontalFov) {
    // The sensor is taken to be half as wide again as high
    camera.fovAxis = scene::FovAxis::Horizontal;
    camera.fov = *draft.horizontalFov;
    focalLength = 1.5 * half / std::tan(double(camera.fov) / 2);
  }
  if (draft.fStop) camera.lens.radius = float(focalLength / double(*draft.fStop) / 2 * 1e-3);
  FinishLens(reader, fields, draft);
}

static void CheckPanorama(Reader& reader, const Fields& fields, CameraDraft& draft) {
  const Camera& camera = draft.camera;
  const float width = std::abs(camera.longitude.y - camera.longitude.x);
  if (!(width > 0) || width > 360.001f * Degree)
    reader.Report(
        fmt::format("'longitude' needs two different angles, at most 360 degrees apart, in {}",
                    fields.title),
        fields.PlaceOf("longitude"));
  if (!(camera.latitude.x < camera.latitude.y))
    reader.Report(
        fmt::format("the first angle of 'latitude' must be the smaller one in {}", fields.title),
        fields.PlaceOf("latitude"));
}

static void CheckFisheye(Reader& reader, const Fields& fields, CameraDraft& draft) {
  const bool open = draft.camera.projection == FisheyeProjection::Stereographic;
  if (open && draft.camera.fov > 359 * Degree)
    reader.Report(
        fmt::format("a stereographic fisheye sees less than 359 degrees in {}", fields.title),
        fields.PlaceOf("fov"));
}

// --- Keys ---------------------------------------------------------------------------------------------------

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
  return Join<CameraDraft>(
      {In({name, position, lookAt}), {direction}, In({up}), CameraMotionKeys()});
}

// Of flat pictures through a lens.
static Keys<CameraDraft> LensKeys() {
  const auto blades = Field("blades", &Lens::blades, Integer(0, 64),
                            "Corners of the aperture, from 3 on; 0: it is round.")
                          .Example("5")
                          .Not({"aperture_blades", "bokeh_blades"});
  const auto rotation =
      Field("blade_rotation", &Lens::bladeRotation, Degrees({-360, 360}),
            "Turns the aperture counter-clockwise; without it, a corner is on top.")
          .Not({"aperture_rotation"});
  const auto ratio = Field("aperture_ratio", &Lens::ratio, Number({0.1, 10}),
                           "The aperture's width to its height; below 1 as an anamorphic lens.");
  const auto radius =
      Field("aperture_radius", &Lens::radius, Number(NotNegative, "m"),
            "Of the lens's opening; what is not in focus blurs. 0: everything is sharp.")
          .Not({"lens_radius", "aperture", "aperture_size"});
  const auto shift =
      Field("shift", &Camera::shift, TexturePoint(),
            "Moves the view without turning it, in widths and heights of the picture; "
            "[0, 0.5] puts the horizon on the lower edge and keeps walls upright.")
          .Example("[0, 0.25]")
          .Standard("none");
  const auto distance = Field("focus_distance", &CameraDraft::focusDistance, Number(Positive, "m"),
                              "How far along the line of sight things are sharp.")
                            .Standard("that of `look_at`")
                            .Not({"focal_distance", "focus"});
  const auto at = Field("focus_at", &CameraDraft::focusAt, Point(),
                        "A point that is sharp, in place of `focus_distance`.")
                      .Standard("`look_at`")
                      .Not({"focus_point"});
  const auto lens = [](Camera& camera) -> Lens& { return camera.lens; };
  return Join<CameraDraft>({In({shift}),
                            In(Within<Camera, Lens>(lens, {radius})),
                            {distance, at},
                            In(Within<Camera, Lens>(lens, {blades, rotation, ratio}))});
}

// Two angles.
static Type<vec2> DegreesFromTo(Range range) {
  Type<vec2> type;
  type.expected = "2 numbers" + range.Words();
  type.unit = "degrees";
  type.schema = ListSchema("{\"type\": \"number\"" + range.Schema() + "}", 2, 2);
  type.read = [range, expected = type.expected](Reader& reader, const Node& value, vec2& radians) {
    double v[2];
    if (!ReadNumbers(reader, value, range, expected, v, 2)) return false;
    radians = vec2(float(v[0]), float(v[1])) * Degree;
    return true;
  };
  type.write = [](const vec2& radians) {
    return fmt::format("[{:.5g}, {:.5g}]", radians.x / Degree, radians.y / Degree);
  };
  return type;
}

// --- Kinds --------------------------------------------------------------------------------------------------

static VariantOf<CameraDraft> Pinhole() {
  const auto fov = Field("fov", &Camera::fov, Degrees({0, 180, true}), "Vertical angle of view.")
                       .Not({"angle", "field_of_view", "zoom", "vertical_fov"});
  const auto across = Field("horizontal_fov", &CameraDraft::horizontalFov, Degrees({0, 180, true}),
                            "Horizontal angle of view, in place of `fov`.")
                          .Standard("by `fov`")
                          .Not({"hfov", "fov_x"});
  const auto focal =
      Field("focal_length", &CameraDraft::focalLength, Number(Positive, "mm"),
            "In place of `fov`: how far the lens stands from a sensor of `sensor_height`.")
          .Example("50")
          .Standard("by `fov`");
  const auto sensor = Field("sensor_height", &CameraDraft::sensorHeight, Number(Positive, "mm"),
                            "Of the film or sensor, for `focal_length` and `f_stop`.");
  const auto stop = Field("f_stop", &CameraDraft::fStop, Number(Positive),
                          "The focal length in diameters of the aperture, in place of "
                          "`aperture_radius`.")
                        .Example("2.8")
                        .Standard("none")
                        .Not({"fstop", "f_number"});
  return VariantOf<CameraDraft>(
             "pinhole", "With perspective; sharp everywhere unless it has an aperture.",
             Join<CameraDraft>({In({fov}), {across, focal, sensor, stop}, LensKeys()}))
      .Begin([](CameraDraft& draft) {
        draft.camera.kind = scene::CameraKind::Pinhole;
        draft.camera.fov = 40 * Degree;
      })
      .Checked(FinishPinhole);
}

static VariantOf<CameraDraft> Orthographic() {
  const auto height = Field("height", &Camera::height, Number(Positive, "m"), "Height of the view.")
                          .Not({"size", "scale"});
  return VariantOf<CameraDraft>("orthographic", "Without perspective: parallel rays.",
                                Join<CameraDraft>({In({height}), LensKeys()}))
      .Begin([](CameraDraft& draft) { draft.camera.kind = scene::CameraKind::Orthographic; })
      .Checked(FinishLens);
}

static VariantOf<CameraDraft> Panorama() {
  return VariantOf<CameraDraft>(
             "panorama",
             "All around: azimuth from left to right, elevation upwards (equirectangular). "
             "Pictures "
             "twice as wide as high fit the whole sphere.",
             In({Field("longitude", &Camera::longitude, DegreesFromTo({-720, 720}),
                       "What the left and the right edge show, to the right of the line of sight; "
                       "from the larger to the smaller, the picture is mirrored.")
                     .Example("[-90, 90]"),
                 Field("latitude", &Camera::latitude, DegreesFromTo({-90, 90}),
                       "What the lower and the upper edge show, above the line of sight.")
                     .Example("[-30, 60]")}))
      .Begin([](CameraDraft& draft) { draft.camera.kind = scene::CameraKind::Panorama; })
      .Checked(CheckPanorama);
}

static VariantOf<CameraDraft> Fisheye() {
  const auto fov = Field("fov", &Camera::fov, Degrees({1, 360}),
                         "Angle of view from rim to rim; outside, the picture is black.")
                       .Not({"angle", "field_of_view"});
  const auto projection = Field(
      "projection", &Camera::projection,
      Choice<FisheyeProjection>({{"equidistant", FisheyeProjection::Equidistant},
                                 {"equisolid", FisheyeProjection::Equisolid},
                                 {"stereographic", FisheyeProjection::Stereographic}}),
      "Distances from the middle grow as the angle θ to the line of sight, as sin(θ/2), which "
      "keeps areas, or as tan(θ/2), which keeps shapes.");
  const auto frame =
      Field("frame", &Camera::fullFrame, Choice<bool>({{"circular", false}, {"full", true}}),
            "Whether the circle fits into the picture or goes through its corners.");
  return VariantOf<CameraDraft>("fisheye", "A wide view into a circle.",
                                In({fov, projection, frame}))
      .Begin([](CameraDraft& draft) {
        draft.camera.kind = scene::CameraKind::Fisheye;
        draft.camera.fov = 180 * Degree;
      })
      .Checked(CheckFisheye);
}

const SectionOf<CameraDraft>& CameraSection() {
  static const SectionOf<CameraDraft> section =
      SectionOf<CameraDraft>(
          "camera", "[camera]",
          "Where the picture is taken from. `[[camera]]` may stand several times; the first is "
          "used unless the command line names another. Without a camera, one is chosen that shows "
          "everything.",
          ViewKeys())
          .Variants("type", {Pinhole(), Orthographic(), Panorama(), Fisheye()}, "pinhole")
          .OnlyOne({{"look_at"}, {"direction"}})
          .OnlyOne({{"fov"}, {"horizontal_fov"}, {"focal_length"}})
          .OnlyOne({{"f_stop"}, {"aperture_radius"}})
          .OnlyOne({{"focus_distance"}, {"focus_at"}})
          .Checked(CheckCamera);
  return section;
}

}  // namespace snell::io
