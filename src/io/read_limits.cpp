// SPDX-License-Identifier: Apache-2.0
#include "io/read_limits.h"

#include <fmt/format.h>

#include <algorithm>

namespace snell::io {

const std::vector<LimitName>& LimitNames() {
  static const std::vector<LimitName> names = {
      {"file-bytes", &ReadLimits::fileBytes, "bytes of each file"},
      {"toml-bytes", &ReadLimits::tomlBytes, "bytes of native scenes, with all they include"},
      {"json-bytes", &ReadLimits::jsonBytes, "bytes of a glTF file's JSON, without data"},
      {"mtl-bytes", &ReadLimits::mtlBytes, "bytes of a material library"},
      {"triangles", &ReadLimits::triangles, "triangles of a file"},
      {"numbers", &ReadLimits::numbers, "numbers that a glTF file's accessors hold"},
      {"objects", &ReadLimits::objects, "objects and lights, all placed"},
      {"materials", &ReadLimits::materials, "materials of an OBJ file"},
      {"pictures", &ReadLimits::pictures, "pictures of an OBJ file"},
      {"picture-pixels", &ReadLimits::picturePixels, "pixels of one picture"},
      {"pixels", &ReadLimits::pixels, "pixels of all pictures of a file"},
      {"includes", &ReadLimits::includes, "files that objects take in"}};
  return names;
}

std::string LiftedBy(Limit limit) {
  const auto found = std::ranges::find(LimitNames(), limit, &LimitName::limit);
  return fmt::format("--limit {}=N raises the limit", found->name);
}

std::string ReadWithin(const std::filesystem::path& path, const ReadLimits& limits, Limit limit,
                       std::uint64_t used) {
  const std::uint64_t allowed = limits.*limit - std::min(used, limits.*limit);
  const bool isFileLimit = limits.fileBytes <= allowed;
  return ReadFile(path, std::min(limits.fileBytes, allowed),
                  LiftedBy(isFileLimit ? &ReadLimits::fileBytes : limit));
}

}  // namespace snell::io
