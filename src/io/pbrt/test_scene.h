// SPDX-License-Identifier: Apache-2.0
//
// For the tests of pbrt scenes: files in a folder that goes with the test.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "image/write.h"
#include "io/pbrt/pbrt.h"
#include "io/read_scene.h"
#include "io/test_folder.h"

namespace snell::io {

class PbrtTestScene : public TestFolder {
 public:
  PbrtTestScene& Write(const std::string& name, const std::string& text) {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return *this;
  }

  // A picture of one colour in linear light.
  PbrtTestScene& Paint(const std::string& name, image::vec3 color, int size = 2) {
    image::Image picture(size, size);
    std::ranges::fill(picture.pixels, color);
    image::WriteImage(folder_ / name, picture);
    return *this;
  }

  // The scene of this text; `error` and `warnings` have places relative to the folder.
  scene::Scene Read(const std::string& text) {
    Write("a.pbrt", text);
    warnings.clear();
    error.clear();
    try {
      return ReadScene(folder_ / "a.pbrt", {}, [this](const Diagnostic& warning) {
        warnings.push_back(Local(ToString(warning)));
      });
    } catch (const Error& fault) {
      error = Local(fault.what());
      return {};
    }
  }

  // The same for what stands after WorldBegin, with a light and a sphere at its end.
  scene::Scene ReadWorld(const std::string& text) {
    return Read("WorldBegin\n" + text + "\nLightSource \"point\"\nShape \"sphere\"\n");
  }

  bool Warned(const std::string& part) const {
    return std::ranges::any_of(
        warnings, [&](const std::string& w) { return w.find(part) != std::string::npos; });
  }

  std::vector<std::string> warnings;
  std::string error;
};

}  // namespace snell::io
