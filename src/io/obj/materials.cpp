// SPDX-License-Identifier: Apache-2.0
#include "io/obj/materials.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "io/find_file.h"
#include "io/images.h"
#include "io/mesh/text.h"
#include "io/obj/mtl.h"
#include "io/obj/mtl_material.h"
#include "util/file.h"

namespace snell::io {
namespace {

namespace fs = std::filesystem;

// The single names of "one.mtl my other.mtl": each goes up to its extension.
std::vector<std::string> SplitNames(std::string_view names) {
  std::vector<std::string> split;
  TextScanner scanner(names);
  std::string name;
  for (std::string_view word; !(word = scanner.WordOnLine()).empty();) {
    if (!name.empty()) name += ' ';
    name += word;
    if (word.size() < 4 || !EqualsIgnoringCase(word.substr(word.size() - 4), ".mtl")) continue;
    split.push_back(std::move(name));
    name.clear();
  }
  if (!name.empty()) split.push_back(std::move(name));
  return split;
}

class LibraryReader {
 public:
  LibraryReader(const MeshFile& file, FileFinder& finder, MtlMaterials& materials,
                Findings& findings)
      : file_(file), finder_(finder), materials_(materials), findings_(findings) {}

  // Spaces may be part of a name.
  void Read(const ObjLibraries& libraries) {
    if (Find(libraries.names)) return ReadOne(libraries.names, libraries.line);
    for (const std::string& name : SplitNames(libraries.names)) ReadOne(name, libraries.line);
  }

  bool missing() const { return missing_; }

 private:
  std::optional<fs::path> Find(const std::string& name) {
    return finder_.Find(finder_.root(), name);
  }

  void ReadOne(const std::string& name, int line) {
    const std::optional<fs::path> path = Find(name);
    if (!path) {
      missing_ = true;
      findings_.Add("material file", "not found in the file's folder", name, file_.AtLine(line));
      return;
    }
    if (!seen_.insert(path->string()).second) return;
    std::string text = ReadWithin(*path, file_.options.limits, &ReadLimits::mtlBytes);
    MakeUtf8(text, path->string());
    ReadMtl(text, path->string(), materials_, findings_);
  }

  const MeshFile& file_;
  FileFinder& finder_;
  MtlMaterials& materials_;
  Findings& findings_;
  std::unordered_set<std::string> seen_;
  bool missing_ = false;
};

}  // namespace

std::vector<scene::MaterialIndex> ReadObjMaterials(const ObjParts& parts, const MeshFile& file,
                                                   scene::Scene& scene) {
  // Read what is used
  MtlMaterials materials;
  for (const ObjPart& part : parts.parts())
    if (part.material != 0) materials.try_emplace(parts.NameOf(part.material));
  const ReadLimits& limits = file.options.limits;
  if (materials.size() > limits.materials)
    throw Error(fmt::format("more than {} materials", limits.materials), file.AtLine(0),
                LiftedBy(&ReadLimits::materials));
  Findings findings;
  std::vector<fs::path> folders = {fs::path(file.name).parent_path()};
  folders.insert(folders.end(), file.options.folders.begin(), file.options.folders.end());
  FileFinder finder(folders);
  LibraryReader reader(file, finder, materials, findings);
  for (const ObjLibraries& libraries : parts.libraries()) reader.Read(libraries);

  // Make materials in the order of their first use
  ImageLoader images(std::move(folders), file.warn, limits);
  MtlConverter converter(scene, images, findings);
  std::unordered_map<std::uint32_t, scene::MaterialIndex> indexOf;
  std::vector<scene::MaterialIndex> indices;
  for (const ObjPart& part : parts.parts()) {
    const auto [entry, isNew] = indexOf.try_emplace(part.material, -1);
    if (isNew) {
      const std::string& name = parts.NameOf(part.material);
      const auto found = materials.find(name);
      const bool defined = found != materials.end() && found->second;
      if (defined) scene.materials.push_back(converter.Convert(*found->second));
      if (!defined && part.material != 0 && !reader.missing())
        findings.Add("material", "not defined in any library", name,
                     file.AtLine(parts.materialsLine()));
      if (defined) entry->second = scene::MaterialIndex(scene.materials.size()) - 1;
    }
    indices.push_back(entry->second);
  }
  findings.Report(file.warn);
  return indices;
}

}  // namespace snell::io
