// SPDX-License-Identifier: Apache-2.0
//
// Small scenes, none above some forty primitives, that together use everything the Whitted integrator knows:
// every shape, light, fall-off, shader term, reflection model, texture, space, camera and filter, instances,
// mirrored and sheared transforms, nested media, thin sheets, every kind of shadow. coverage_test.cpp checks
// that nothing is left out. Whoever adds to the kernel adds to these scenes.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace snell::agree {

// Valid scenes of 64 × 64 pixels, each with one camera and a name of letters alone.
std::vector<scene::Scene> ScenesOfShapes();
std::vector<scene::Scene> ScenesOfLights();
std::vector<scene::Scene> ScenesOfMaterials();
std::vector<scene::Scene> ScenesOfPictures();
std::vector<scene::Scene> ScenesOfGlass();
std::vector<scene::Scene> ScenesOfCameras();
std::vector<scene::Scene> ScenesOfMotion();
std::vector<scene::Scene> ScenesOfMedia();

// All of them.
std::vector<scene::Scene> AllScenes();

// Their names, and one by its name.
std::vector<std::string> SceneNames();
scene::Scene SceneNamed(const std::string& name);

}  // namespace snell::agree
