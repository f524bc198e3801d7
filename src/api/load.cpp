// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "api/scene.h"
#include "io/format.h"
#include "io/read_scene.h"
#include "io/toml/scene.h"

namespace snell {

float Scene::exposure() const { return contents_->settings.exposure; }

Scene LoadScene(const std::filesystem::path& path, const LoadOptions& options) {
  io::ReadOptions readOptions;
  readOptions.zUp = options.zUp;
  readOptions.smooth = options.smooth;
  readOptions.time = options.time;
  return Scene(
      std::make_shared<const scene::Scene>(io::ReadScene(path, readOptions, options.warn)));
}

std::string KnownSceneExtensions() { return io::KnownFormats(); }
std::string SceneReference() { return io::SceneReferenceMarkdown(); }
std::string SceneSchema() { return io::SceneJsonSchema(); }

}  // namespace snell
