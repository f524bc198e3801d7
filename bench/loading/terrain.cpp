// SPDX-License-Identifier: Apache-2.0
#include "loading/terrain.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include "util/file.h"

namespace snell::bench {

namespace {

static_assert(std::endian::native == std::endian::little, "GLB is little-endian");

struct Terrain {
  std::vector<float> positions, normals, uvs;
  std::vector<std::uint32_t> indices;
};

float Height(float x, float y) {
  return 0.15f * std::sin(7 * x) * std::cos(5 * y) + 0.05f * std::sin(31 * x + 17 * y);
}

Terrain MakeTerrain(std::uint32_t side) {
  Terrain terrain;
  constexpr float Step = 1e-3f;
  for (std::uint32_t j = 0; j < side; ++j) {
    for (std::uint32_t i = 0; i < side; ++i) {
      const float x = float(i) / float(side - 1), y = float(j) / float(side - 1);
      const float dx = (Height(x + Step, y) - Height(x - Step, y)) / (2 * Step);
      const float dy = (Height(x, y + Step) - Height(x, y - Step)) / (2 * Step);
      const float length = std::sqrt(1 + dx * dx + dy * dy);
      for (const float value : {x, Height(x, y), -y}) terrain.positions.push_back(value);
      for (const float value : {-dx / length, 1 / length, dy / length})
        terrain.normals.push_back(value);
      for (const float value : {x, y}) terrain.uvs.push_back(value);
    }
  }
  for (std::uint32_t j = 0; j + 1 < side; ++j) {
    for (std::uint32_t i = 0; i + 1 < side; ++i) {
      const std::uint32_t a = j * side + i, b = a + side;
      for (const std::uint32_t corner : {a, a + 1, b + 1, a, b + 1, b})
        terrain.indices.push_back(corner);
    }
  }
  return terrain;
}

template <class T>
std::uint32_t Append(std::string& bytes, const std::vector<T>& values) {
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  return std::uint32_t(values.size() * sizeof(T));
}

void AppendWord(std::string& bytes, std::uint32_t word) {
  bytes.append(reinterpret_cast<const char*>(&word), sizeof word);
}

}  // namespace

void WriteTerrainObj(const std::filesystem::path& path, std::uint32_t side) {
  const Terrain terrain = MakeTerrain(side);
  std::string text = "o terrain\n";
  const auto write = [&](const char* keyword, const std::vector<float>& values, std::size_t width) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i % width == 0) text += keyword;
      fmt::format_to(std::back_inserter(text), " {:.6f}", values[i]);
      if (i % width == width - 1) text += '\n';
    }
  };
  write("v", terrain.positions, 3);
  write("vt", terrain.uvs, 2);
  write("vn", terrain.normals, 3);
  for (std::size_t i = 0; i < terrain.indices.size(); ++i) {
    if (i % 3 == 0) text += 'f';
    fmt::format_to(std::back_inserter(text), " {0}/{0}/{0}", terrain.indices[i] + 1);
    if (i % 3 == 2) text += '\n';
  }
  WriteFile(path, text);
}

void WriteTerrainGlb(const std::filesystem::path& path, std::uint32_t side) {
  Terrain terrain = MakeTerrain(side);
  // The first row of a picture is at v = 0 in glTF
  for (std::size_t i = 1; i < terrain.uvs.size(); i += 2) terrain.uvs[i] = 1 - terrain.uvs[i];
  std::string data;
  std::string views;
  const auto append = [&](const auto& values) {
    const std::size_t offset = data.size();
    const std::uint32_t length = Append(data, values);
    views += fmt::format(R"({}{{"buffer":0,"byteOffset":{},"byteLength":{}}})",
                         views.empty() ? "" : ",", offset, length);
  };
  append(terrain.positions);
  append(terrain.normals);
  append(terrain.uvs);
  append(terrain.indices);

  const std::uint32_t count = side * side;
  std::string json = fmt::format(
      R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0}}],)"
      R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2}},"indices":3}}]}}],)"
      R"("buffers":[{{"byteLength":{}}}],"bufferViews":[{}],"accessors":[)"
      R"({{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3","min":[0,-0.2,-1],"max":[1,0.2,0]}},)"
      R"({{"bufferView":1,"componentType":5126,"count":{},"type":"VEC3"}},)"
      R"({{"bufferView":2,"componentType":5126,"count":{},"type":"VEC2"}},)"
      R"({{"bufferView":3,"componentType":5125,"count":{},"type":"SCALAR"}}]}})",
      data.size(), views, count, count, count, terrain.indices.size());
  json.resize((json.size() + 3) / 4 * 4, ' ');

  constexpr std::uint32_t Json = 0x4e4f534a, Bin = 0x004e4942;
  std::string file = "glTF";
  AppendWord(file, 2);
  AppendWord(file, std::uint32_t(28 + json.size() + data.size()));
  AppendWord(file, std::uint32_t(json.size()));
  AppendWord(file, Json);
  file += json;
  AppendWord(file, std::uint32_t(data.size()));
  AppendWord(file, Bin);
  file += data;
  WriteFile(path, file);
}

}  // namespace snell::bench
