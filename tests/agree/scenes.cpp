// SPDX-License-Identifier: Apache-2.0
#include "agree/scenes.h"

#include "util/error.h"

namespace snell::agree {

std::vector<scene::Scene> AllScenes() {
  std::vector<scene::Scene> scenes;
  for (const auto family : {ScenesOfShapes, ScenesOfLights, ScenesOfMaterials, ScenesOfPictures,
                            ScenesOfGlass, ScenesOfMedia, ScenesOfCameras, ScenesOfMotion}) {
    for (scene::Scene& scene : family()) scenes.push_back(std::move(scene));
  }
  return scenes;
}

std::vector<std::string> SceneNames() {
  std::vector<std::string> names;
  for (const scene::Scene& scene : AllScenes()) names.push_back(scene.name);
  return names;
}

scene::Scene SceneNamed(const std::string& name) {
  for (scene::Scene& scene : AllScenes()) {
    if (scene.name == name) return std::move(scene);
  }
  throw Error("there is no scene called '" + name + "'");
}

}  // namespace snell::agree
