// SPDX-License-Identifier: Apache-2.0
#include "io/toml/inclusions.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "io/append.h"
#include "io/format.h"
#include "io/gltf/gltf.h"
#include "io/toml/reader.h"
#include "util/text.h"

namespace snell::io {

static std::string RealName(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::weakly_canonical(path, ignored).string();
}

int InclusionLibrary::Request(const std::filesystem::path& path, const ReadOptions& options,
                              const Place& place) {
  const auto key = std::tuple(RealName(path), options.smooth.value_or(-1), options.ignoreNormals,
                              options.time.value_or(std::numeric_limits<double>::infinity()),
                              options.duration, options.scene, options.variant);
  const auto [request, isNew] = requests_.emplace(key, int(items_.size()));
  if (isNew) items_.push_back({path, options, place, {}, {}});
  return request->second;
}

// Scenes that take in each other, or too much of everything.
bool InclusionLibrary::MayRead(Reader& reader, const Item& item, const std::string& real) {
  Inclusion& inclusion = *reader.inclusion;
  const std::string name = item.path.filename().string();
  if (std::ranges::find(inclusion.open, real) != inclusion.open.end()) {
    reader.Report(fmt::format("{} includes itself", QuotedName(name)), item.place);
  } else if (inclusion.open.size() > MaxInclusionDepth) {
    reader.Report(fmt::format("files are included more than {} deep", MaxInclusionDepth),
                  item.place);
  } else if (++inclusion.files > reader.limits.includes) {
    reader.Report(
        fmt::format("more than {} files are included", WithCommas(reader.limits.includes)),
        item.place, LiftedBy(&ReadLimits::includes));
  } else {
    return true;
  }
  return false;
}

void InclusionLibrary::Read(Reader& reader, Item& item, const WarningSink& warn) {
  Inclusion& inclusion = *reader.inclusion;
  ReadOptions options = item.options;
  const bool ownTime = options.time.has_value();
  if (!ownTime) options.time = reader.time;
  options.limits = reader.limits;
  options.folders = reader.folders;
  options.inclusion = reader.inclusion;
  try {
    item.contents = ReadContents(item.path, options, warn);
  } catch (const Error& error) {
    // A mistake in a native scene stands at its own place; others are told where the file is named
    for (const Diagnostic& cause : error.diagnostics()) {
      const bool isNative = FormatOf(cause.place.file) == Format::Toml && cause.place.line > 0;
      const bool isMesh = FormatOf(item.path) == Format::Mesh;
      reader.Report(isNative ? cause.message
                             : fmt::format("cannot {} {}: {}", isMesh ? "use the mesh" : "include",
                                           cause.place.file.empty() ? item.path.string()
                                                                    : ToString(cause.place),
                                           cause.message),
                    isNative ? cause.place : item.place, cause.hint);
    }
    return;
  }

  scene::Scene& scene = item.contents.scene;
  inclusion.things += scene.objects.size() + scene.lights.size();
  if (inclusion.things > reader.limits.objects)
    reader.Report(fmt::format("the included files have more than {} objects and lights",
                              WithCommas(reader.limits.objects)),
                  item.place, LiftedBy(&ReadLimits::objects));
  if (ownTime && !item.contents.animated)
    reader.Warn(fmt::format("{} has no animations: the time changes nothing",
                            QuotedName(item.path.filename().string())),
                item.place);
  reader.animated |= item.contents.animated;
  // glTF's candela, lux and nits count as watts, as they do where nothing but the file is shown
  if (FormatOf(item.path) == Format::Gltf)
    for (scene::Light& light : scene.lights) light.strength *= LumensPerWatt;
}

void InclusionLibrary::Load(Reader& reader, const WarningSink& warn) {
  for (Item& item : items_) {
    const std::string real = RealName(item.path);
    if (!MayRead(reader, item, real)) continue;
    Read(reader, item, warn);
    scene::Scene& scene = item.contents.scene;
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
      item.materials.emplace_back(scene.materials[i].name, int(reader.scene.materials.size() + i));
    AppendResources(scene, reader.scene);
  }
}

}  // namespace snell::io
