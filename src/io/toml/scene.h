// SPDX-License-Identifier: Apache-2.0
//
// Native scenes: a TOML file, with all that it includes, becomes a Scene. The language is described once,
// in the sections (toml_sections.h); the reference page and the JSON Schema for editors come from there too.
#pragma once

#include <filesystem>
#include <string>

#include "io/contents.h"
#include "scene/scene.h"
#include "util/error.h"

namespace snell::io {

// Read a scene. Other files are read only from the folder of the scene file, the folders in it and those that
// the options add. Throws one Error with all mistakes in all files, in the order of the files; of more than twenty the
// rest are counted. Warnings go to `warn`, which may be empty.
Contents ReadToml(const std::filesystem::path& path, const ReadOptions& options,
                  const WarningSink& warn);

// docs/scene-reference.md: the reference page of the language, in Markdown.
std::string SceneReferenceMarkdown();

// docs/snell-scene.schema.json: the same as a JSON Schema (draft 7), for editors that complete and check.
std::string SceneJsonSchema();

}  // namespace snell::io
