// SPDX-License-Identifier: Apache-2.0
//
// What scenes get that leave settings open.
#include "scene/settings.h"

#include <gtest/gtest.h>

namespace snell::scene {
namespace {

Scene SceneOf(bool isPhysical, bool isUsed) {
  Scene scene;
  scene.materials.resize(2);
  if (isPhysical) scene.materials[1].physical.emplace();
  scene.objects.resize(1);
  scene.objects[0].material = isUsed ? 1 : 0;
  return scene;
}

TEST(Settings, PhysicalMaterialsInUseAskForPaths) {
  RenderSettings settings;
  Resolve(SceneOf(true, true), settings);
  EXPECT_EQ(settings.integrator, Integrator::Path);
  EXPECT_EQ(settings.spp, PathSamples);
  for (const Scene& scene : {SceneOf(true, false), SceneOf(false, true), Scene()}) {
    RenderSettings classic;
    Resolve(scene, classic);
    EXPECT_EQ(classic.integrator, Integrator::Whitted);
    EXPECT_EQ(classic.spp, WhittedSamples);
  }
}

TEST(Settings, WhatIsGivenStays) {
  RenderSettings settings;
  settings.integrator = Integrator::Whitted;
  Resolve(SceneOf(true, true), settings);
  EXPECT_EQ(settings.integrator, Integrator::Whitted);
  EXPECT_EQ(settings.spp, WhittedSamples);
  settings.spp = 5;
  settings.integrator = Integrator::Path;
  Resolve(Scene(), settings);
  EXPECT_EQ(settings.integrator, Integrator::Path);
  EXPECT_EQ(settings.spp, 5);
}

}  // namespace
}  // namespace snell::scene
