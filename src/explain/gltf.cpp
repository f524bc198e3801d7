// SPDX-License-Identifier: Apache-2.0
//
// An explanation's rays as a glTF 2.0 file of lines in one piece: a mesh for each kind of line, unlit in its colour.
#include <bit>
#include <cmath>
#include <cstring>

#include "explain/lines.h"
#include "util/json.h"

namespace snell::explain {

namespace {

std::string Base64(const std::vector<float>& values) {
  static const char* const Digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  static_assert(std::endian::native == std::endian::little);
  std::vector<unsigned char> bytes(values.size() * sizeof(float));
  std::memcpy(bytes.data(), values.data(), bytes.size());
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= count ? Digits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

float Linear(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

// The lines of one style: where their points begin, how many there are, and their box.
struct Group {
  std::size_t style;
  std::size_t first;
  std::size_t count = 0;
  kernel::vec3 low{1e30f}, high{-1e30f};
};

void AddAccessor(const Group& group, JsonWriter& json) {
  json.BeginObject("");
  json.Add("bufferView", 0);
  json.Add("byteOffset", std::uint64_t(group.first * 3 * sizeof(float)));
  json.Add("componentType", 5126);
  json.Add("count", std::uint64_t(group.count));
  json.Add("type", "VEC3");
  json.Add("min", {group.low.x, group.low.y, group.low.z});
  json.Add("max", {group.high.x, group.high.y, group.high.z});
  json.End();
}

void AddMaterial(const LineStyle& style, JsonWriter& json) {
  json.BeginObject("");
  json.Add("name", style.name);
  json.BeginObject("pbrMetallicRoughness");
  json.Add("baseColorFactor",
           {Linear(style.color[0]), Linear(style.color[1]), Linear(style.color[2]), 1.0f});
  json.End();
  json.BeginObject("extensions");
  json.BeginObject("KHR_materials_unlit");
  json.End();
  json.End();
  json.End();
}

void AddMesh(std::size_t index, const LineStyle& style, JsonWriter& json) {
  json.BeginObject("");
  json.Add("name", style.name);
  json.BeginArray("primitives");
  json.BeginObject("");
  json.BeginObject("attributes");
  json.Add("POSITION", std::uint64_t(index));
  json.End();
  json.Add("material", std::uint64_t(index));
  json.Add("mode", 1);
  json.End();
  json.End();
  json.End();
}

}  // namespace

std::string ToGltf(const Explanation& explanation) {
  // Sort the lines by style
  const std::vector<Line> lines = LinesOf(explanation);
  std::vector<Group> groups;
  std::vector<float> points;
  for (std::size_t style = 0; style < LineStyles.size(); ++style) {
    Group group{style, points.size() / 3};
    for (const Line& line : lines) {
      if (line.style != style) continue;
      for (const kernel::vec3& p : {line.from, line.to}) {
        points.insert(points.end(), {p.x, p.y, p.z});
        for (glm::length_t i = 0; i < 3; ++i) {
          group.low[i] = std::min(group.low[i], p[i]);
          group.high[i] = std::max(group.high[i], p[i]);
        }
        ++group.count;
      }
    }
    if (group.count > 0) groups.push_back(group);
  }

  JsonWriter json;
  json.BeginObject("asset");
  json.Add("version", "2.0");
  json.Add("generator", "Snell");
  json.End();
  json.Add("extensionsUsed", std::vector<std::string>{"KHR_materials_unlit"});
  json.Add("scene", 0);
  json.BeginArray("scenes");
  json.BeginObject("");
  json.BeginArray("nodes");
  for (std::size_t i = 0; i < groups.size(); ++i) json.Add("", std::uint64_t(i));
  json.End();
  json.End();
  json.End();
  json.BeginArray("nodes");
  for (std::size_t i = 0; i < groups.size(); ++i) {
    json.BeginObject("");
    json.Add("mesh", std::uint64_t(i));
    json.End();
  }
  json.End();
  json.BeginArray("meshes");
  for (std::size_t i = 0; i < groups.size(); ++i) AddMesh(i, LineStyles[groups[i].style], json);
  json.End();
  json.BeginArray("materials");
  for (const Group& group : groups) AddMaterial(LineStyles[group.style], json);
  json.End();
  json.BeginArray("accessors");
  for (const Group& group : groups) AddAccessor(group, json);
  json.End();
  const std::uint64_t bytes = points.size() * sizeof(float);
  json.BeginArray("bufferViews");
  json.BeginObject("");
  json.Add("buffer", 0);
  json.Add("byteLength", bytes);
  json.End();
  json.End();
  json.BeginArray("buffers");
  json.BeginObject("");
  json.Add("byteLength", bytes);
  json.Add("uri", "data:application/octet-stream;base64," + Base64(points));
  json.End();
  json.End();
  return json.Finish();
}

}  // namespace snell::explain
