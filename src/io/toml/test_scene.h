// SPDX-License-Identifier: Apache-2.0
//
// For the tests of the TOML reader: scene files in a folder of their own, which goes with the test.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "io/test_folder.h"
#include "io/toml/scene.h"
#include "util/error.h"

namespace snell::io {

// A picture of one red pixel, in Radiance HDR: readers go by the contents.
inline const std::string OnePixel =
    "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n\x80\x01\x01\x81";

class TestScene : public TestFolder {
 public:
  TestScene() = default;
  explicit TestScene(const std::string& text) : TestScene() { Write("scene.toml", text); }

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
};

}  // namespace snell::io
