// SPDX-License-Identifier: Apache-2.0
#include "io/format.h"

#include "util/file.h"

namespace snell::io {

Format FormatOf(const std::filesystem::path& path) {
  const std::string extension = LowerExtension(path);
  if (extension == "toml") return Format::Toml;
  if (extension == "gltf" || extension == "glb") return Format::Gltf;
  if (extension == "nff") return Format::Nff;
  if (extension == "pbrt") return Format::Pbrt;
  if (extension == "obj" || extension == "ply" || extension == "stl") return Format::Mesh;
  for (const char* other : {"dae", "fbx", "3ds", "off", "ac", "x"})
    if (extension == other) return Format::Other;
  return Format::Unknown;
}

std::string KnownFormats() {
  return "toml, gltf, glb, nff, pbrt, obj, ply, stl, dae, fbx, 3ds, off, ac, x";
}

}  // namespace snell::io
