// SPDX-License-Identifier: Apache-2.0
#include "fuzz/check.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "scene/bounds.h"
#include "util/check.h"

namespace snell::fuzz {

namespace {

template <typename Vector>
bool AllFinite(const std::vector<Vector>& vectors) {
  for (const Vector& v : vectors)
    for (int i = 0; i < Vector::length(); ++i)
      if (!std::isfinite(v[i])) return false;
  return true;
}

void CheckMesh(const scene::Mesh& mesh) {
  CHECK(AllFinite(mesh.positions));
  CHECK(AllFinite(mesh.normals));
  CHECK(AllFinite(mesh.uvs));
  CHECK(AllFinite(mesh.uvs1));
  CHECK(AllFinite(mesh.tangents));
  CHECK(AllFinite(mesh.colors));
  for (const scene::MeshKey& key : mesh.keys) {
    CHECK(key.positions.size() == mesh.positions.size() && AllFinite(key.positions));
    CHECK(key.normals.size() == mesh.normals.size() && AllFinite(key.normals));
    CHECK(key.tangents.size() == mesh.tangents.size() && AllFinite(key.tangents));
  }
}

}  // namespace

void CheckScene(const scene::Scene& scene) {
  for (const scene::Mesh& mesh : scene.meshes) CheckMesh(mesh);
  for (const scene::Image& image : scene.images)
    for (const float value : image.floats) CHECK(std::isfinite(value));
  for (const scene::DensityGrid& grid : scene.grids) CheckGrid(grid);
  for (const scene::LightProfile& profile : scene.profiles) CheckProfile(profile);
  const scene::Box3 box = scene::BoundsOf(scene);
  CHECK(box.Empty() || std::isfinite(box.Size().x + box.Size().y + box.Size().z));
}

void CheckGrid(const scene::DensityGrid& grid) {
  const std::size_t bricks = grid.values.size() / 512;
  CHECK(grid.values.size() % 512 == 0);
  CHECK(grid.table.size() == std::size_t(grid.bricks.x) * grid.bricks.y * grid.bricks.z);
  for (const int number : grid.table) CHECK(number == -1 || std::size_t(number) < bricks);
  for (const float value : grid.values) CHECK(std::isfinite(value) && value >= 0);
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row) CHECK(std::isfinite(float(grid.toObject[column][row])));
}

void CheckProfile(const scene::LightProfile& profile) {
  const auto areAngles = [](const std::vector<float>& angles, float most) {
    return std::ranges::is_sorted(angles) && angles.front() >= 0 && angles.back() <= most;
  };
  CHECK(profile.verticals.size() >= 2 && areAngles(profile.verticals, 3.1416f));
  CHECK(!profile.horizontals.empty() && areAngles(profile.horizontals, 6.2832f));
  CHECK(profile.intensities.size() == profile.verticals.size() * profile.horizontals.size());
  for (const float value : profile.intensities) CHECK(std::isfinite(value) && value >= 0);
}

void CheckPicture(const image::Image& picture, const image::Metadata& metadata) {
  CHECK(picture.width > 0 && picture.height > 0);
  const std::size_t count = std::size_t(picture.width) * std::size_t(picture.height);
  CHECK(picture.pixels.size() == count);
  CHECK(picture.alpha.empty() || picture.alpha.size() == count);
  for (const auto& [key, value] : metadata) CHECK(!key.empty());
}

void CheckText(std::string_view message) {
  constexpr std::size_t Long = 1 << 20;
  CHECK(!message.empty() && message.size() < Long);
}

}  // namespace snell::fuzz
