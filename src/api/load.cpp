// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <system_error>

#include "api/scene.h"
#include "io/format.h"
#include "io/read_scene.h"
#include "io/toml/scene.h"
#include "util/text.h"

namespace snell {

std::vector<std::string> Scene::cameras() const {
  std::vector<std::string> names;
  for (const scene::Camera& camera : contents_->cameras) {
    if (!camera.name.empty()) names.push_back(camera.name);
  }
  return names;
}

float Scene::exposure() const { return contents_->settings.exposure; }

std::string Scene::view() const {
  for (const auto& [name, view] : image::ViewNames()) {
    if (view == contents_->settings.view) return name;
  }
  return "srgb";
}

std::vector<LoadLimit> KnownLoadLimits() {
  std::vector<LoadLimit> known;
  for (const io::LimitName& name : io::LimitNames())
    known.push_back({name.name, name.text, io::ReadLimits().*name.limit});
  return known;
}

static io::ReadLimits LimitsOf(const LoadOptions& options) {
  io::ReadLimits limits;
  for (const auto& [name, value] : options.limits) {
    std::vector<std::string> names;
    bool found = false;
    for (const io::LimitName& known : io::LimitNames()) {
      if (name == known.name) limits.*known.limit = value;
      found |= name == known.name;
      names.emplace_back(known.name);
    }
    if (!found) throw Error("there is no limit '" + name + "'", {}, DidYouMean(name, names));
  }
  return limits;
}

static void CheckFolders(const LoadOptions& options) {
  std::error_code ignored;
  for (const std::filesystem::path& folder : options.folders)
    if (!std::filesystem::is_directory(folder, ignored))
      throw Error("there is no such folder to read from", {folder.string()});
}

Scene LoadScene(const std::filesystem::path& path, const LoadOptions& options) {
  io::ReadOptions readOptions;
  readOptions.zUp = options.zUp;
  readOptions.smooth = options.smooth;
  readOptions.time = options.time;
  readOptions.environment = options.environment;
  readOptions.limits = LimitsOf(options);
  CheckFolders(options);
  readOptions.folders = options.folders;
  return Scene(
      std::make_shared<const scene::Scene>(io::ReadScene(path, readOptions, options.warn)));
}

std::string KnownSceneExtensions() { return io::KnownFormats(); }
bool HasSceneExtension(const std::filesystem::path& path) {
  return io::FormatOf(path) != io::Format::Unknown;
}
std::string SceneReference() { return io::SceneReferenceMarkdown(); }
std::string SceneSchema() { return io::SceneJsonSchema(); }

}  // namespace snell
