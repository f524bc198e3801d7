// SPDX-License-Identifier: Apache-2.0
#include "spd/counts.h"

#include <unistd.h>

#include <fmt/format.h>
#include <filesystem>
#include <fstream>

#include "api/render.h"
#include "api/scene.h"

namespace snell::spd {

namespace {

// An NFF file that exists while the object lives.
class NffFile {
 public:
  explicit NffFile(const Database& database)
      : path_(std::filesystem::temp_directory_path() /
              fmt::format("snell-{}-{}.nff", database.name, ::getpid())) {
    std::ofstream file(path_, std::ios::binary);
    file << database.generate(database.usualSize);
    file.close();
    if (!file) throw Error("the file cannot be written", {path_.string()});
  }
  ~NffFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  NffFile(const NffFile&) = delete;
  NffFile& operator=(const NffFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace

RayCounts CountRays(const Database& database, int side) {
  const NffFile file(database);
  RenderOptions options;
  options.width = options.height = side;
  const RenderReport report = Render(LoadScene(file.path()), options).report;
  return {std::int64_t(report.cameraRays), std::int64_t(report.reflectedRays),
          std::int64_t(report.refractedRays), std::int64_t(report.shadowRays)};
}

}  // namespace snell::spd
