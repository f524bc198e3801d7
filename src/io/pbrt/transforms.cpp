// SPDX-License-Identifier: Apache-2.0
//
// The statements that change the current transform: each is multiplied from the right.
#include <fmt/format.h>

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "io/mesh/text.h"
#include "io/pbrt/reader.h"

namespace snell::io {

using scene::Affine;

static constexpr std::size_t MaxCoordinateSystems = 100'000;

void PbrtReader::Concat(const Affine& map) {
  Replace(state_.transform * map, state_.transformEnd * map);
}

void PbrtReader::Replace(const Affine& start, const Affine& end) {
  if (state_.startCounts) state_.transform = start;
  if (state_.endCounts) state_.transformEnd = end;
}

// Of what stands by `toObject` in the current transform; empty if that does not move.
scene::Motion PbrtReader::MotionOf(const Affine& toObject) const {
  if (state_.transform == state_.transformEnd) return {};
  return {{movementStart_, state_.transform * toObject},
          {movementEnd_, state_.transformEnd * toObject}};
}

void PbrtReader::Identity() { Replace(Affine(1.0), Affine(1.0)); }

void PbrtReader::Translate() {
  const std::vector<double> n = Numbers(3);
  Concat(glm::translate(Affine(1.0), {n[0], n[1], n[2]}));
}

void PbrtReader::Scale() {
  const std::vector<double> n = Numbers(3);
  Concat(glm::scale(Affine(1.0), {n[0], n[1], n[2]}));
}

void PbrtReader::Rotate() {
  const std::vector<double> n = Numbers(4);
  const glm::dvec3 axis(n[1], n[2], n[3]);
  if (!(glm::length(axis) > 0)) throw Error("the axis of 'Rotate' has no direction", place_);
  Concat(glm::rotate(Affine(1.0), glm::radians(n[0]), glm::normalize(axis)));
}

void PbrtReader::LookAt() {
  const std::vector<double> n = Numbers(9);
  const glm::dvec3 eye(n[0], n[1], n[2]), at(n[3], n[4], n[5]), up(n[6], n[7], n[8]);
  const glm::dvec3 forward = glm::normalize(at - eye);
  const glm::dvec3 right = glm::cross(glm::normalize(up), forward);
  if (!(glm::length(right) > 1e-9))
    throw Error("'LookAt' looks at its own place or along its up vector", place_);
  const glm::dvec3 x = glm::normalize(right);
  const Affine fromCamera(glm::dvec4(x, 0), glm::dvec4(glm::cross(forward, x), 0),
                          glm::dvec4(forward, 0), glm::dvec4(eye, 1));
  Concat(glm::inverse(fromCamera));
}

// Sixteen numbers, column after column.
Affine PbrtReader::Matrix() {
  const std::vector<double> n = Numbers(16);
  if (n[3] != 0 || n[7] != 0 || n[11] != 0 || n[15] == 0)
    throw Error("a transform with perspective is not read", place_);
  Affine map;
  for (int i = 0; i < 16; ++i) map[i / 4][i % 4] = n[std::size_t(i)] / n[15];
  return map;
}

void PbrtReader::Transform() {
  const Affine map = Matrix();
  Replace(map, map);
}

void PbrtReader::ConcatTransform() { Concat(Matrix()); }

void PbrtReader::CoordinateSystem() {
  if (coordinateSystems_.size() >= MaxCoordinateSystems)
    throw Error("there are too many coordinate systems", place_);
  coordinateSystems_[String("a name")] = {state_.transform, state_.transformEnd};
}

void PbrtReader::CoordSysTransform() {
  const std::string name = String("a name");
  const auto system = coordinateSystems_.find(name);
  if (system == coordinateSystems_.end())
    throw Error(fmt::format("there is no coordinate system {}", Quoted(name)), place_);
  Replace(system->second.first, system->second.second);
}

// StartTime, EndTime or All.
void PbrtReader::ActiveTransform() {
  const PbrtWord word = words_->Next();
  if (word.text != "StartTime" && word.text != "EndTime" && word.text != "All")
    throw Error(
        fmt::format("'ActiveTransform' needs StartTime, EndTime or All, not {}", Quoted(word)),
        words_->PlaceOf(word));
  state_.startCounts = word.text != "EndTime";
  state_.endCounts = word.text != "StartTime";
}

void PbrtReader::TransformTimes() {
  RequireWorld(false);
  const std::vector<double> times = Numbers(2);
  if (!(times[0] < times[1])) throw Error("'TransformTimes' needs two times that rise", place_);
  movementStart_ = times[0];
  movementEnd_ = times[1];
}

}  // namespace snell::io
