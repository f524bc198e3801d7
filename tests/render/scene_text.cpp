// SPDX-License-Identifier: Apache-2.0
#include "render/scene_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace snell::test {

namespace {

// A file that exists while the object lives.
class SceneFile {
 public:
  explicit SceneFile(std::string_view text) {
    static int count = 0;
    path_ = std::filesystem::temp_directory_path() /
            fmt::format("snell-render-{}-{}.toml", ::getpid(), ++count);
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~SceneFile() { std::filesystem::remove(path_); }
  SceneFile(const SceneFile&) = delete;
  SceneFile& operator=(const SceneFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace

Scene SceneOf(std::string_view text) {
  const SceneFile file(text);
  LoadOptions options;
  options.warn = [](const Diagnostic& warning) {
    // Skies and lights are pictures enough
    if (warning.message != "the scene has no objects")
      ADD_FAILURE() << "unexpected warning: " << ToString(warning);
  };
  return LoadScene(file.path(), options);
}

RenderResult RenderText(std::string_view text, const RenderOptions& options) {
  RenderResult result = Render(SceneOf(text), options);
  for (const std::string& warning : result.report.warnings)
    ADD_FAILURE() << "unexpected warning: " << warning;
  return result;
}

Picture PictureOf(std::string_view text, const RenderOptions& options) {
  return RenderText(text, options).picture;
}

double MeanOf(const Picture& picture, int channel) {
  double sum = 0;
  for (std::size_t i = std::size_t(channel); i < picture.rgb.size(); i += 3)
    sum += double(picture.rgb[i]);
  return 3 * sum / double(picture.rgb.size());
}

double LargestDifference(const Picture& a, const Picture& b) {
  EXPECT_EQ(a.rgb.size(), b.rgb.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i)
    largest = std::max(largest, std::abs(double(a.rgb[i]) - double(b.rgb[i])));
  return largest;
}

std::string Toml(dvec3 v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }

std::string View::Write(int spp, int maxDepth, std::string_view filter) const {
  return fmt::format(
      "[render]\nsize = [{}, {}]\nspp = {}\nmax_depth = {}\nmin_contribution = 0\n{}\n"
      "[camera]\ntype = '{}'\n{} = {}\nposition = {}\ndirection = {}\nup = {}\n",
      width, height, spp, maxDepth, filter, orthographic ? "orthographic" : "pinhole",
      orthographic ? "height" : "fov", extent, Toml(position), Toml(direction), Toml(up));
}

std::string View::Exact(int maxDepth) const {
  return Write(1, maxDepth, "filter = 'box'\nfilter_radius = 1e-6");
}

std::string View::Sampled(int spp, int maxDepth) const {
  return Write(spp, maxDepth, "filter = 'box'");
}

// The offset from the picture's middle, in the plane at distance 1 or, without perspective, in metres.
dvec3 View::InPlane(double x, double y) const {
  const dvec3 forward = glm::normalize(direction);
  const dvec3 right = glm::normalize(glm::cross(forward, up));
  const double half = orthographic ? extent / 2 : std::tan(glm::radians(extent) / 2);
  return right * ((2 * x - width) / height * half) +
         glm::cross(right, forward) * ((height - 2 * y) / height * half);
}

dvec3 View::RayOrigin(double x, double y) const {
  return orthographic ? position + InPlane(x, y) : position;
}

dvec3 View::RayDirection(double x, double y) const {
  const dvec3 forward = glm::normalize(direction);
  return orthographic ? forward : glm::normalize(forward + InPlane(x, y));
}

View FromAbove(int width, int height, double extent) {
  View view{width, height};
  view.extent = extent;
  view.position = {0, 50, 0};
  view.direction = {0, -1, 0};
  view.up = {0, 0, -1};
  return view;
}

}  // namespace snell::test
