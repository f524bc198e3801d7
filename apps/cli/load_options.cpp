// SPDX-License-Identifier: Apache-2.0
#include "cli/load_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string_view>
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
  const bool isMesh = extension == "obj" || extension == "ply" || extension == "stl";
  if (arguments.up && !isScene && !isMesh)
    warn({"--up is for OBJ, PLY and STL files and changes nothing here", {scene}});
}

struct Setting {
  std::string name;
  std::uint64_t value = 0;
};

// "triangles=2G": the suffixes are powers of 1024.
Setting ReadLimit(const std::string& text) {
  static constexpr std::string_view Suffixes = "KMGT";
  static constexpr std::uint64_t Most = std::uint64_t(1) << 60;
  const std::size_t equals = std::min(text.find('='), text.size());
  Setting setting{text.substr(0, equals)};
  std::vector<std::string> names;
  for (const LoadLimit& known : KnownLoadLimits()) names.push_back(known.name);
  if (std::find(names.begin(), names.end(), setting.name) == names.end())
    throw BadValue(fmt::format("must be NAME=N, where NAME is {}", fmt::join(names, ", ")));

  std::string_view number = std::string_view(text).substr(std::min(equals + 1, text.size()));
  const std::size_t power = number.empty() ? Suffixes.npos : Suffixes.find(number.back());
  if (power != Suffixes.npos) number.remove_suffix(1);
  const char* end = number.data() + number.size();
  const auto [rest, failed] = std::from_chars(number.data(), end, setting.value);
  if (number.empty() || rest != end || failed != std::errc())
    throw BadValue("must be NAME=N with a whole number, to which K, M, G or T may be added");
  const int shift = power == Suffixes.npos ? 0 : 10 * (int(power) + 1);
  if (setting.value == 0 || setting.value > Most >> shift)
    throw BadValue("must be NAME=N with a number from 1 to 2^60");
  setting.value <<= shift;
  return setting;
}

std::string CheckLimit(const std::string& text) {
  ReadLimit(text);
  return text;
}

std::string LimitText() {
  std::string text;
  for (const LoadLimit& limit : KnownLoadLimits())
    text += fmt::format("{}{}, {}", text.empty() ? "" : "; ", limit.name, limit.text);
  return text;
}

}  // namespace

void AddLoadOptions(CLI::App& command, LoadArguments& arguments) {
  command.option_defaults()->group("Mesh files");
  AddChoice(command, "--up", "y|z", arguments.up,
            "Mesh files: the axis that points up (y; STL: z)");
  AddValue(command, "--smooth", "DEGREES", Number(0, 180), arguments.smooth,
           "Mesh files without normals: shade edges below this angle smoothly; 0: flat");
  command.option_defaults()->group("Animations");
  AddValue(command, "--at", "SECONDS", Number(-MaxSeconds, MaxSeconds), arguments.time,
           "glTF files with animations: the moment to show; without it everything is at rest");
  command.option_defaults()->group("Light");
  AddValue<std::string>(
      command, "--environment", "FILE", ReadText, arguments.environment,
      "A picture of all directions that lights the scene in place of its environment and of the "
      "studio that models are set into");
  command.option_defaults()->group("Safety");
  AddValues(command, "--allow", "FOLDER", ReadText, arguments.folders,
            "A folder that files may be read from besides the scene's own; may be given several "
            "times");
  AddValues(command, "--limit", "NAME=N", CheckLimit, arguments.limits,
            "Let files demand more, or less; may be given several times. K, M, G and T after N "
            "are powers of 1024. The names: " +
                LimitText());
}

Scene Load(const std::string& scene, const LoadArguments& arguments, WarningSink warn) {
  WarnOfMeshOptions(scene, arguments, warn);
  LoadOptions options;
  options.warn = std::move(warn);
  if (arguments.up) options.zUp = *arguments.up == "z";
  options.smooth = arguments.smooth;
  options.time = arguments.time;
  if (arguments.environment) options.environment = *arguments.environment;
  options.folders.assign(arguments.folders.begin(), arguments.folders.end());
  for (const std::string& limit : arguments.limits) {
    const Setting setting = ReadLimit(limit);
    options.limits[setting.name] = setting.value;
  }
  return LoadScene(scene, options);
}

}  // namespace snell::cli
