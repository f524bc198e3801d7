// SPDX-License-Identifier: Apache-2.0
//
// Motion: where objects and cameras are at moments of the scene's time. What a key leaves out is as in the table around.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "io/toml/sections.h"
#include "scene/motion.h"

namespace snell::io {

using glm::dvec3;

static Type<float> Seconds() {
  Type<float> type = Number(Any, "s");
  type.example = "0.5";
  return type;
}

// --- Objects ------------------------------------------------------------------------------------------------

static void FinishKey(Reader&, const Fields& fields, MotionKeyDraft& key) {
  key.hasScale = fields.Find("scale") != nullptr;
  key.hasRotation = fields.Find("rotate") != nullptr;
  key.hasTranslation = fields.Find("translate") != nullptr;
  key.hasSteps = fields.Find("transform") != nullptr;
}

const SectionOf<MotionKeyDraft>& MotionKeySection() {
  static const SectionOf<MotionKeyDraft> section =
      SectionOf<MotionKeyDraft>(
          "motion_key", "motion",
          "Where an object is at a moment. In between it moves, stretches and turns evenly, turns "
          "by the shorter way; before the first key and after the last it rests.",
          Join<MotionKeyDraft>(
              {{Field("time", &MotionKeyDraft::time, Seconds(), "The moment.").Required()},
               Within(&MotionKeyDraft::placement, PlacementKeys())}))
          .OnlyOne(PlacementSides)
          .Checked(FinishKey);
  return section;
}

static Affine PlaceOf(const MotionKeyDraft& key, const Placement& own) {
  if (key.hasSteps) return key.placement.steps;
  Placement place = own;
  if (key.hasScale) place.scale = key.placement.scale;
  if (key.hasRotation) place.rotate = key.placement.rotate;
  if (key.hasTranslation) place.translate = key.placement.translate;
  return place.Matrix();
}

// Report times that do not rise, and maps that turn inside out on their way.
static void CheckMotion(Reader& reader, const Fields& fields, const scene::Motion& motion) {
  const auto rises = [](const scene::MotionKey& a, const scene::MotionKey& b) {
    return a.time >= b.time;
  };
  if (std::ranges::adjacent_find(motion, rises) != motion.end()) {
    reader.Report(fmt::format("the times of 'motion' do not rise in {}", fields.title),
                  fields.PlaceOf("motion"));
  } else if (!scene::KeepsHandedness(motion)) {
    reader.Report(fmt::format("'motion' mirrors at some of its keys only in {}", fields.title),
                  fields.PlaceOf("motion"));
  }
}

void FinishMotion(Reader& reader, const Fields& fields, ObjectDraft& draft) {
  if (draft.motion.empty()) return;
  for (const MotionKeyDraft& key : draft.motion) {
    const Affine place = PlaceOf(key, draft.placement);
    if (std::string reason; !IsUsable(place, reason)) {
      reader.Report(fmt::format("the motion of {} cannot be used: {}", fields.title, reason),
                    fields.PlaceOf("motion"));
      return;
    }
    draft.object.motion.push_back({double(key.time), place});
  }
  draft.object.toWorld = draft.object.motion.front().place;
  CheckMotion(reader, fields, draft.object.motion);
}

KeyOf<ObjectDraft> MotionKeyOfObjects() {
  return Field("motion", &ObjectDraft::motion,
               ListOf(TableOf(MotionKeySection, "{ time and where it is }"), "keys", 2),
               "Where it is at moments of the scene's time; shown blurred while the camera's "
               "`shutter` is open. What a key does not say is as in this table. Lights of groups "
               "and files stay where it begins.")
      .Standard("it stands still")
      .Example("[{ time = 0 }, { time = 0.1, translate = [0.3, 0, 0] }]")
      .Not({"animation", "keyframes", "velocity"});
}

// --- Cameras ------------------------------------------------------------------------------------------------

const SectionOf<CameraKeyDraft>& CameraKeySection() {
  static const SectionOf<CameraKeyDraft> section =
      SectionOf<CameraKeyDraft>(
          "camera_key", "motion of [camera]",
          "Where a camera is at a moment. In between it moves and turns evenly.",
          {Field("time", &CameraKeyDraft::time, Seconds(), "The moment.").Required(),
           Field("position", &CameraKeyDraft::position, Point(), "Where the camera stands.")
               .Standard("the camera's"),
           Field("look_at", &CameraKeyDraft::lookAt, Point(),
                 "A point in the middle of the picture.")
               .Standard("the camera's"),
           Field("direction", &CameraKeyDraft::direction, Direction(),
                 "The line of sight, in place of `look_at`.")
               .Standard("by `look_at`"),
           Field("up", &CameraKeyDraft::up, NotZero(""), "What points up in the picture.")
               .Standard("the camera's")})
          .OnlyOne({{"look_at"}, {"direction"}});
  return section;
}

void FinishCameraMotion(Reader& reader, const Fields& fields, CameraDraft& draft) {
  scene::Camera& camera = draft.camera;
  camera.shutterOpen = double(draft.shutter.x);
  camera.shutterClose = double(draft.shutter.y);
  if (draft.shutter.x > draft.shutter.y)
    reader.Report(fmt::format("the shutter closes before it opens in {}", fields.title),
                  fields.PlaceOf("shutter"));
  for (const CameraKeyDraft& key : draft.motion) {
    scene::Camera moved = camera;
    moved.position = key.position.value_or(camera.position);
    const auto direction = key.direction || key.lookAt ? key.direction : draft.direction;
    moved.lookAt =
        direction ? PointAhead(moved.position, *direction) : key.lookAt.value_or(camera.lookAt);
    moved.up = key.up.value_or(camera.up);
    const dvec3 forward = dvec3(moved.lookAt) - dvec3(moved.position);
    if (!(glm::length(glm::cross(forward, dvec3(moved.up))) >
          1e-6 * glm::length(forward) * glm::length(dvec3(moved.up)))) {
      reader.Report(fmt::format("a key of 'motion' looks at its own position or along 'up' in {}",
                                fields.title),
                    fields.PlaceOf("motion"));
      return;
    }
    camera.motion.push_back({double(key.time), scene::FrameOf(moved)});
  }
  CheckMotion(reader, fields, camera.motion);
}

Keys<CameraDraft> CameraMotionKeys() {
  Type<vec2> interval = TexturePoint();
  interval.unit = "s";
  interval.write = [](const vec2& v) { return fmt::format("[{}, {}]", v.x, v.y); };
  return {
      Field("shutter", &CameraDraft::shutter, interval,
            "When it opens and closes, in the scene's time: what moves meanwhile is blurred. If "
            "both are the same, that moment is shown.")
          .Example("[0, 0.02]")
          .Not({"exposure_time", "shutter_speed", "shutter_time"}),
      Field("motion", &CameraDraft::motion,
            ListOf(TableOf(CameraKeySection, "{ time and where it is }"), "keys", 2),
            "Where the camera is at moments of the scene's time, if it moves.")
          .Standard("it stands still")
          .Example("[{ time = 0 }, { time = 0.1, position = [0.2, 0, 5] }]")};
}

}  // namespace snell::io
