// SPDX-License-Identifier: Apache-2.0
//
// All files of a scene as one document: includes followed, tables merged, names collected. Nothing is
// looked into yet; what the tables mean stands in the sections (toml_sections.h).
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "io/toml/reader.h"
#include "io/toml/table.h"

namespace snell::io {

// A table under a name, such as [material.glass].
struct NamedFields {
  std::string name;
  Fields fields;
};

struct Document {
  std::vector<std::shared_ptr<const toml::node>> files;  // keeps all nodes alive
  Fields render;
  Fields environment;
  std::vector<Fields> cameras;
  std::vector<Fields> lights;
  std::vector<Fields> objects;
  std::vector<NamedFields> groups;  // in the order of the files, as all lists
  std::vector<NamedFields> materials;
  std::vector<NamedFields> textures;
};

// Includes may be nested this deep.
inline constexpr int MaxIncludeDepth = 16;

// Read a scene file and all that it includes; each file counts once. Throws Error if the scene file itself
// cannot be read; all else is reported.
Document ReadDocument(Reader& reader, const std::filesystem::path& sceneFile);

// The tables of a list under a key, such as [[light]]; nothing if the entry is null.
std::vector<Fields> TablesOf(Reader& reader, const std::string& title, const Node::Entry* list);

// Report that a table does not have a key.
void ReportUnknownKey(Reader& reader, const Section& section, const Node::Entry& entry,
                      const std::string& title);

}  // namespace snell::io
