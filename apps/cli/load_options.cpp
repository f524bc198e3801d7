// SPDX-License-Identifier: Apache-2.0
#include "cli/load_options.h"

#include <utility>

#include "cli/values.h"
#include "util/file.h"

namespace snell::cli {

namespace {

constexpr float MaxSeconds = 1e9f;

void WarnOfMeshOptions(const std::string& scene, const LoadArguments& arguments,
                       const WarningSink& warn) {
  const std::string extension = LowerExtension(scene);
  const bool isScene =
      extension == "toml" || extension == "nff" || extension == "gltf" || extension == "glb";
  if ((arguments.up || arguments.smooth) && isScene)
    warn({"--up and --smooth are for mesh files and change nothing here", {scene}});
}

}  // namespace

void AddLoadOptions(CLI::App& command, LoadArguments& arguments) {
  command.option_defaults()->group("Mesh files");
  AddChoice(command, "--up", "y|z", arguments.up,
            "Mesh files: the axis that points up (y; STL: z)");
  AddValue(command, "--smooth", "DEGREES", Number(0, 180), arguments.smooth,
           "Mesh files without normals: shade edges below this angle smoothly; 0: flat");
  command.option_defaults()->group("Animations");
  AddValue(command, "--time", "SECONDS", Number(-MaxSeconds, MaxSeconds), arguments.time,
           "glTF files with animations: the moment to show; without it everything is at rest");
}

Scene Load(const std::string& scene, const LoadArguments& arguments, WarningSink warn) {
  WarnOfMeshOptions(scene, arguments, warn);
  LoadOptions options;
  options.warn = std::move(warn);
  if (arguments.up) options.zUp = *arguments.up == "z";
  options.smooth = arguments.smooth;
  options.time = arguments.time;
  return LoadScene(scene, options);
}

}  // namespace snell::cli
