// SPDX-License-Identifier: Apache-2.0
//
// What any file that Snell opens says itself, before a studio is set up around it (read_scene.h) or another
// scene takes it in (toml/inclusions.h).
#pragma once

#include <filesystem>

#include "io/read_options.h"
#include "scene/scene.h"
#include "util/error.h"

namespace snell::io {

struct Contents {
  scene::Scene scene;
  bool animated = false;  // a time changes something
};

// Objects of mesh files that bring no material have material -1. Lights are in watts whatever the file's
// unit, and nothing is exposed for them. Throws Error with every mistake found; not validated yet.
Contents ReadContents(const std::filesystem::path& path, const ReadOptions& options,
                      const WarningSink& warn);

}  // namespace snell::io
