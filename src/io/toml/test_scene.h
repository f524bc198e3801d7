// SPDX-License-Identifier: Apache-2.0
//
// For the tests of the TOML reader: scene files in a folder of their own, which goes with the test.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "io/toml/scene.h"
#include "util/error.h"

namespace snell::io {

// A picture of one red pixel, in Radiance HDR: readers go by the contents.
inline const std::string OnePixel =
    "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n\x80\x01\x01\x81";

class TestScene {
 public:
  TestScene() {
    static int count = 0;
    const std::string name =
        "snell-toml-" + std::to_string(::getpid()) + "-" + std::to_string(++count);
    folder_ = std::filesystem::temp_directory_path() / name;
    std::filesystem::create_directories(folder_);
  }
  explicit TestScene(const std::string& text) : TestScene() { Write("scene.toml", text); }
  ~TestScene() { std::filesystem::remove_all(folder_); }
  TestScene(const TestScene&) = delete;
  TestScene& operator=(const TestScene&) = delete;

  const std::filesystem::path& folder() const { return folder_; }

  TestScene& Write(const std::string& name, const std::string& text) {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return *this;
  }

  // The scene; warnings are collected.
  scene::Scene Read() {
    warnings.clear();
    return ReadToml(
               folder_ / "scene.toml", options,
               [this](const Diagnostic& warning) { warnings.push_back(Local(ToString(warning))); })
        .scene;
  }

  // The lines of the error that reading gives, with places relative to the folder; none if it succeeds.
  std::vector<std::string> Errors() {
    std::vector<std::string> lines;
    try {
      Read();
    } catch (const Error& error) {
      for (const Diagnostic& diagnostic : error.diagnostics())
        lines.push_back(Local(ToString(diagnostic)));
    }
    return lines;
  }

  ReadOptions options;
  std::vector<std::string> warnings;

 private:
  std::string Local(std::string text) const {
    const std::string prefix = folder_.string() + "/";
    for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix))
      text.erase(at, prefix.size());
    return text;
  }

  std::filesystem::path folder_;
};

}  // namespace snell::io
