// SPDX-License-Identifier: Apache-2.0
//
// All of Snell's public interface. A picture in three lines:
//
//   snell::Scene scene = snell::LoadScene("bunny.ply");
//   snell::RenderResult result = snell::Render(scene);
//   snell::WritePicture("bunny.png", result.picture);
#pragma once

#include "devices.h"
#include "explain.h"
#include "merge.h"
#include "picture.h"
#include "render.h"
#include "scene.h"
#include "selftest.h"
#include "session.h"
#include "version.h"
