// SPDX-License-Identifier: Apache-2.0
//
// Animations at a moment: steps, lines and cubic splines between keys (glTF 2.0, section 3.11 and
// appendix C).
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "io/gltf/nodes.h"

namespace snell::io {
namespace {

// Between which keys a moment lies, and how far.
struct Moment {
  std::size_t before = 0;
  std::size_t after = 0;
  double fraction = 0;
  double duration = 0;  // from key to key
};

Moment Find(const std::vector<float>& times, double time) {
  const auto next = std::ranges::upper_bound(times, time, {}, [](float t) { return double(t); });
  if (next == times.begin()) return {};
  const std::size_t after = std::size_t(next - times.begin());
  if (after == times.size()) return {after - 1, after - 1, 0, 0};
  const double start = double(times[after - 1]), duration = double(times[after]) - start;
  return {after - 1, after, duration > 0 ? (time - start) / duration : 0, duration};
}

// Rotate evenly by the shorter way (spherical linear interpolation).
std::vector<double> Slerp(const std::vector<double>& a, const std::vector<double>& b, double t) {
  const glm::dquat from(a[3], a[0], a[1], a[2]), to(b[3], b[0], b[1], b[2]);
  const glm::dquat q = glm::slerp(from, to, t);
  return {q.x, q.y, q.z, q.w};
}

// A sampler's value: `width` numbers.
std::vector<double> Sample(const std::vector<float>& times, const std::vector<float>& values,
                           const std::string& interpolation, std::size_t width, double time,
                           bool isRotation) {
  const Moment moment = Find(times, time);
  const bool isSpline = interpolation == "CUBICSPLINE";
  // Of the spline's three parts of a key, 0 is the tangent before, 1 the value, 2 the tangent after
  const auto key = [&](std::size_t index, std::size_t part) {
    const std::size_t first = isSpline ? (3 * index + part) * width : index * width;
    return std::vector<double>(values.begin() + std::ptrdiff_t(first),
                               values.begin() + std::ptrdiff_t(first + width));
  };
  std::vector<double> result = key(moment.before, 1);
  if (interpolation == "STEP" || moment.fraction == 0) return result;
  const std::vector<double> next = key(moment.after, 1);
  const double t = moment.fraction;
  if (!isSpline) {
    if (isRotation) return Slerp(result, next, t);
    for (std::size_t i = 0; i < width; ++i) result[i] += t * (next[i] - result[i]);
    return result;
  }
  const std::vector<double> leaving = key(moment.before, 2), arriving = key(moment.after, 0);
  const double t2 = t * t, t3 = t2 * t;
  for (std::size_t i = 0; i < width; ++i)
    result[i] = (2 * t3 - 3 * t2 + 1) * result[i] +
                moment.duration * (t3 - 2 * t2 + t) * leaving[i] + (3 * t2 - 2 * t3) * next[i] +
                moment.duration * (t3 - t2) * arriving[i];
  return result;
}

// Give the state a property of the path's kind.
void Set(const std::string& path, const std::vector<double>& v, GltfNodeState& state) {
  state.matrix.reset();
  if (path == "translation") state.translation = {v[0], v[1], v[2]};
  if (path == "scale") state.scale = {v[0], v[1], v[2]};
  if (path == "rotation") state.rotation = glm::dquat(v[3], v[0], v[1], v[2]);
}

void Move(GltfData& data, const tinygltf::AnimationSampler& sampler, const std::string& path,
          double time, GltfNodeState& state, const std::string& part) {
  const std::vector<float> times = data.Floats(sampler.input, 1);
  if (!std::ranges::is_sorted(times)) throw data.document().Fault(part, "its times do not rise");
  const std::size_t parts = sampler.interpolation == "CUBICSPLINE" ? 3 : 1;
  const std::size_t keys = times.size() * parts;
  if (path == "weights") {
    const std::vector<float> values = data.Floats(sampler.output, 1);
    if (values.size() < keys || values.size() % keys != 0)
      throw data.document().Fault(part, "the number of its weights does not fit its times");
    state.weights = Sample(times, values, sampler.interpolation, values.size() / keys, time, false);
    return;
  }
  const bool isRotation = path == "rotation";
  const int width = isRotation ? 4 : 3;
  const std::vector<float> values = data.Floats(sampler.output, width, keys);
  const auto value =
      Sample(times, values, sampler.interpolation, std::size_t(width), time, isRotation);
  if (std::ranges::all_of(value, [](double x) { return std::isfinite(x); }))
    Set(path, value, state);
}

}  // namespace

void Animate(GltfData& data, double time, std::vector<GltfNodeState>& states) {
  const GltfDocument& document = data.document();
  std::set<std::pair<int, std::string>> moved;
  for (std::size_t i = 0; i < document.model.animations.size(); ++i) {
    const tinygltf::Animation& animation = document.model.animations[i];
    const std::string part = GltfPart("animation", i, animation.name);
    for (const tinygltf::AnimationChannel& channel : animation.channels) {
      const std::string& path = channel.target_path;
      if (channel.target_node < 0 || std::size_t(channel.target_node) >= states.size() ||
          channel.sampler < 0 || std::size_t(channel.sampler) >= animation.samplers.size()) {
        document.findings.Note("animations of what does not exist are left out", part);
      } else if (path != "translation" && path != "rotation" && path != "scale" &&
                 path != "weights") {
        document.findings.Note("animations of unknown properties are left out", part);
      } else if (!moved.emplace(channel.target_node, path).second) {
        document.findings.Note("of animations that move the same, the first is shown", part);
      } else {
        Move(data, animation.samplers[std::size_t(channel.sampler)], path, time,
             states[std::size_t(channel.target_node)], part);
      }
    }
  }
}

}  // namespace snell::io
