// SPDX-License-Identifier: Apache-2.0
//
// For the tests of OBJ scenes: files and pictures in a folder that goes with the test.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "image/write.h"
#include "io/obj/scene.h"
#include "io/test_folder.h"
#include "util/error.h"

namespace snell::io {

class ObjTestScene : public TestFolder {
 public:
  ObjTestScene& Write(const std::string& name, const std::string& text) {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return *this;
  }

  // A picture of one colour in linear light, two pixels wide; the second one has this alpha.
  ObjTestScene& Paint(const std::string& name, image::vec3 color, float alpha = 1) {
    image::Image picture(2, 1);
    picture.pixels = {color, color};
    if (alpha < 1) picture.alpha = {1, alpha};
    image::WriteImage(folder_ / name, picture);
    return *this;
  }

  // A triangle of each material.
  ObjTestScene& WriteTriangles(const std::string& libraries,
                               const std::vector<std::string>& materials) {
    std::string text =
        "mtllib " + libraries + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 2 0\nvt 0 2\n";
    for (const std::string& name : materials) text += "usemtl " + name + "\nf 1/1 2/2 3/3\n";
    return Write("a.obj", text);
  }

  // The scene of a.obj; `error` and `warnings` have places relative to the folder.
  scene::Scene Read(const MeshReadOptions& options = {.smoothingGroups = true}) {
    warnings.clear();
    error.clear();
    try {
      return ReadObjScene(folder_ / "a.obj", options, [this](const Diagnostic& warning) {
        warnings.push_back(Local(ToString(warning)));
      });
    } catch (const Error& fault) {
      error = Local(fault.what());
      return {};
    }
  }

  // The material of one triangle with this text in its library.
  scene::Material ReadMaterial(const std::string& text) {
    Write("a.mtl", "newmtl m\n" + text).WriteTriangles("a.mtl", {"m"});
    contents = Read();
    return contents.materials.empty() ? scene::Material() : contents.materials[0];
  }

  std::vector<std::string> warnings;
  std::string error;
  scene::Scene contents;  // of ReadMaterial
};

}  // namespace snell::io
