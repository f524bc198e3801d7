// SPDX-License-Identifier: Apache-2.0
//
// What all parts of the TOML reader share while they fill a scene: the findings so far, what names mean,
// and the meshes to load. Findings are collected, not thrown, so that a user sees all of them at once.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/toml/inclusions.h"
#include "io/toml/meshes.h"
#include "io/toml/node.h"
#include "scene/scene.h"
#include "util/error.h"

namespace snell::io {

class Reader {
 public:
  // Findings that one Error shows; the rest are counted.
  static constexpr std::size_t MaxFindings = 20;

  Reader(const std::filesystem::path& sceneFile, const ReadOptions& options);

  // --- Findings

  void Report(std::string message, Place place, std::string hint = "");

  // Report "'key': expected …, found …" at a value; returns false, for the readers of values.
  bool Refuse(const Node& value, std::string_view expected, std::string hint = "");

  std::size_t findings() const { return findingCount_; }

  // Throw all findings, in the order of the files, if there are any.
  void ThrowFindings();

  // Something that is allowed and may be a mistake.
  void Warn(std::string message, Place place, std::string hint = "");

  // Hand over the warnings, in the order of the files.
  void EmitWarnings(const WarningSink& sink);

  // --- Files

  // The file that a value names, which must exist and lie where files may be read. Reports if not.
  bool FindFile(const Node& name, std::filesystem::path& path);

  // --- What is being read

  scene::Scene scene;
  MeshLibrary meshes;
  InclusionLibrary inclusions;
  ReadLimits limits;
  std::shared_ptr<Inclusion> inclusion;        // never null
  std::vector<std::filesystem::path> folders;  // that may be read from, the scene's first
  std::optional<double> time;                  // for animations of included files
  bool animated = false;                       // there is one
  std::map<std::string, scene::TextureIndex, std::less<>> textures;
  std::map<std::string, scene::MaterialIndex, std::less<>> materials;
  std::map<std::string, int, std::less<>> groups;
  std::vector<std::string> files;  // in the order in which findings are sorted
  std::string key;                 // being read, for messages: see KeyScope
  bool filesMissing = false;       // a file could not be read: unknown names say nothing

 private:
  void SortByPlace(std::vector<Diagnostic>& list) const;

  std::vector<Diagnostic> findings_;
  std::size_t findingCount_ = 0;
  std::vector<Diagnostic> warnings_;
};

// Says for messages which key is being read while it lives.
class KeyScope {
 public:
  KeyScope(Reader& reader, std::string_view key)
      : reader_(reader), outer_(std::exchange(reader.key, std::string(key))) {}
  ~KeyScope() { reader_.key = std::move(outer_); }
  KeyScope(const KeyScope&) = delete;
  KeyScope& operator=(const KeyScope&) = delete;

 private:
  Reader& reader_;
  std::string outer_;
};

// A name from a file for a message: at most 60 characters, without control characters.
std::string Printable(std::string_view name);

// The same in quotes.
std::string QuotedName(std::string_view name);

// DidYouMean for a name from a file, which may be long.
std::string Suggestion(std::string_view name, const std::vector<std::string>& known);

// The keys of a map, for suggestions; none if there are too many to search.
template <class Value>
std::vector<std::string> NamesOf(const std::map<std::string, Value, std::less<>>& map) {
  std::vector<std::string> names;
  if (map.size() > 1000) return names;
  for (const auto& [name, value] : map) names.push_back(name);
  return names;
}

}  // namespace snell::io
