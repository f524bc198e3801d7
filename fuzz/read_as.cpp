// SPDX-License-Identifier: Apache-2.0
#include "fuzz/read_as.h"

#include <algorithm>
#include <filesystem>

#include "fuzz/check.h"
#include "fuzz/png_checksums.h"
#include "image/read.h"
#include "io/grid/nanovdb.h"
#include "io/ies/ies.h"
#include "io/read_scene.h"
#include "support/scratch_folder.h"

namespace snell::fuzz {

namespace {

constexpr const char* Pictures[] = {"exr", "hdr", "jpeg", "png", "webp"};

// Where the file lies that is read, as "a" with its extension, and those that it may name.
class Folder : public test::ScratchFolder {
 public:
  Folder() {
    std::filesystem::copy(std::filesystem::path(SNELL_SOURCE_DIR) / "fuzz" / "beside", folder_);
  }
};

// Warnings must be fit to print.
void Ignore(const Diagnostic& warning) { CheckText(ToString(warning)); }

void ReadScene(const std::string& target, std::string_view bytes) {
  static const Folder folder;
  folder.Write("a." + target, std::string(bytes));

  // A material library shows in a mesh that names it
  io::ReadOptions options;
  options.time = 0.5;
  options.duration = 0.5;
  const std::string name = target == "mtl" ? "with_mtl.obj" : "a." + target;
  CheckScene(io::ReadScene(folder.Path(name), options, Ignore));
}

void ReadPicture(const std::string& target, std::string_view bytes) {
  const std::string file = target == "png" ? WithPngChecksums(bytes) : std::string(bytes);
  image::Metadata metadata;
  CheckPicture(image::DecodeImage(file, "a." + target, {}, &metadata), metadata);
}

void ReadGrid(std::string_view bytes) {
  CheckGrid(io::ReadNanoVdb(std::string(bytes), "a.nvdb", ""));
}

void ReadProfile(std::string_view bytes) { CheckProfile(io::ReadIes(bytes, "a.ies")); }

}  // namespace

void ReadAs(const std::string& target, std::string_view bytes) {
  try {
    if (std::ranges::count(Pictures, target) > 0) return ReadPicture(target, bytes);
    if (target == "nvdb") return ReadGrid(bytes);
    if (target == "ies") return ReadProfile(bytes);
    ReadScene(target, bytes);
  } catch (const Error& error) {
    CheckText(error.what());
    throw;
  }
}

}  // namespace snell::fuzz
