// SPDX-License-Identifier: Apache-2.0
#include "scene/motion.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numbers>

namespace snell::scene {

namespace {

using glm::dmat3;
using glm::dquat;
using glm::dvec3;

constexpr double LargestTurn = 2 * std::numbers::pi / 180;
constexpr int MostSteps = 256;

struct Parts {
  dvec3 translation;
  dquat rotation;
  dmat3 stretch;  // symmetric, but for the sign of a mirrored map
};

double SizeOf(const dmat3& m) {
  return std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]));
}

Parts PartsOf(const Affine& map) {
  const dmat3 linear(map);
  // The nearest rotation by Newton's iteration (Higham 1986, "Computing the polar decomposition")
  dmat3 rotation = linear;
  for (int i = 0; i < 100; ++i) {
    const dmat3 next = (rotation + glm::transpose(glm::inverse(rotation))) * 0.5;
    const double change = SizeOf(next - rotation);
    rotation = next;
    if (change <= 1e-15 * SizeOf(rotation)) break;
  }
  if (glm::determinant(rotation) < 0) rotation = -rotation;
  return {dvec3(map[3]), glm::normalize(glm::quat_cast(rotation)),
          glm::transpose(rotation) * linear};
}

Affine Between(const Affine& from, const Affine& to, double share) {
  const Parts a = PartsOf(from), b = PartsOf(to);
  const dmat3 linear = glm::mat3_cast(glm::slerp(a.rotation, b.rotation, share)) *
                       (a.stretch * (1 - share) + b.stretch * share);
  Affine map(glm::dmat4{linear});
  map[3] = glm::dvec4(a.translation * (1 - share) + b.translation * share, 1);
  return map;
}

// By how much the rotation changes from key to key.
double TurnBetween(const Affine& from, const Affine& to) {
  const double cosine = std::abs(glm::dot(PartsOf(from).rotation, PartsOf(to).rotation));
  return 2 * std::acos(std::min(cosine, 1.0));
}

}  // namespace

Affine PlaceAt(const Motion& motion, double time) {
  const auto next = std::ranges::upper_bound(motion, time, {}, &MotionKey::time);
  if (next == motion.begin()) return motion.front().place;
  const auto last = next - 1;
  if (next == motion.end() || last->time == time || last->place == next->place) return last->place;
  return Between(last->place, next->place, (time - last->time) / (next->time - last->time));
}

Affine ToWorldAt(const Object& object, double time) {
  return object.motion.empty() ? object.toWorld : PlaceAt(object.motion, time);
}

Affine FrameOf(const Camera& camera) {
  const dvec3 position(camera.position);
  const dvec3 forward = glm::normalize(dvec3(camera.lookAt) - position);
  const dvec3 right = glm::normalize(glm::cross(forward, dvec3(camera.up)));
  const dvec3 up = glm::cross(right, forward);
  return {glm::dvec4(right, 0), glm::dvec4(up, 0), glm::dvec4(-forward, 0),
          glm::dvec4(position, 1)};
}

Affine FrameAt(const Camera& camera, double time) {
  return camera.motion.empty() ? FrameOf(camera) : PlaceAt(camera.motion, time);
}

Motion Compose(const Affine& outerPlace, const Motion& outer, const Affine& innerPlace,
               const Motion& inner) {
  std::vector<double> times;
  for (const Motion* motion : {&outer, &inner})
    for (const MotionKey& key : *motion) times.push_back(key.time);
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  Motion composed;
  for (const double time : times) {
    composed.push_back({time, (outer.empty() ? outerPlace : PlaceAt(outer, time)) *
                                  (inner.empty() ? innerPlace : PlaceAt(inner, time))});
  }
  return composed;
}

bool IsMoving(const Motion& motion, double open, double close) {
  if (motion.empty() || !(open < close)) return false;
  const Affine start = PlaceAt(motion, open);
  if (PlaceAt(motion, close) != start) return true;
  return std::ranges::any_of(motion, [&](const MotionKey& key) {
    return key.time > open && key.time < close && key.place != start;
  });
}

int StepsOf(const Motion& motion, double open, double close) {
  double turn = 0;
  std::vector<double> cuts;  // shares of the time where keys lie
  Affine last = PlaceAt(motion, open);
  for (const MotionKey& key : motion) {
    if (key.time <= open || key.time >= close) continue;
    turn += TurnBetween(last, key.place);
    last = key.place;
    cuts.push_back((key.time - open) / (close - open));
  }
  turn += TurnBetween(last, PlaceAt(motion, close));
  // Rounding aside, what only moves needs one
  return EvenSteps(cuts, std::clamp(int(std::ceil(turn / LargestTurn - 1e-6)), 1, MostSteps),
                   MostSteps);
}

int EvenSteps(const std::vector<double>& cuts, int least, int most) {
  for (int steps = least; steps < most; ++steps) {
    const auto isCut = [&](double share) {
      return std::abs(share * steps - std::round(share * steps)) < 1e-3;
    };
    if (std::ranges::all_of(cuts, isCut)) return steps;
  }
  return most;
}

bool KeepsHandedness(const Motion& motion) {
  return std::ranges::all_of(motion, [&](const MotionKey& key) {
    return glm::determinant(dmat3(key.place)) * glm::determinant(dmat3(motion.front().place)) > 0;
  });
}

}  // namespace snell::scene
