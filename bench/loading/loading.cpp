// SPDX-License-Identifier: Apache-2.0
//
// Times how long Snell and Assimp take to read the same mesh, in turn: into a valid scene here, into Assimp's own
// records there, with and without finding the vertices that corners share, which Snell always does.
#include <fmt/format.h>

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <vector>

#include "io/read_scene.h"
#include "loading/terrain.h"
#include "support/scratch_folder.h"
#include "util/error.h"
#include "util/timer.h"

namespace {

constexpr int Repetitions = 5;

double Seconds(const std::function<void()>& work) {
  const snell::Timer timer;
  work();
  return timer.Seconds();
}

double Median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

void ReadByAssimp(const std::string& path, unsigned flags) {
  Assimp::Importer importer;
  if (importer.ReadFile(path, flags) == nullptr) throw snell::Error(importer.GetErrorString());
}

// One line of the table.
void Compare(const std::string& path) {
  std::vector<double> snell, plain, joined;
  for (int i = 0; i < Repetitions; ++i) {
    snell.push_back(Seconds([&] { snell::io::ReadScene(path, {}, {}); }));
    plain.push_back(Seconds([&] { ReadByAssimp(path, aiProcess_Triangulate); }));
    joined.push_back(Seconds(
        [&] { ReadByAssimp(path, aiProcess_Triangulate | aiProcess_JoinIdenticalVertices); }));
  }
  fmt::print("| {} | {:.0f} | {:.2f} | {:.2f} | {:.2f} |\n",
             std::filesystem::path(path).filename().string(),
             double(std::filesystem::file_size(path)) * 1e-6, Median(snell), Median(plain),
             Median(joined));
}

}  // namespace

int main(int count, char** arguments) {
  try {
    const snell::test::ScratchFolder folder;
    std::vector<std::string> files(arguments + 1, arguments + count);
    if (files.empty()) {
      constexpr std::uint32_t Side = 709;  // a million triangles
      files = {folder.Path("terrain.obj"), folder.Path("terrain.glb")};
      snell::bench::WriteTerrainObj(files[0], Side);
      snell::bench::WriteTerrainGlb(files[1], Side);
    }
    fmt::print("| file | MB | Snell, s | Assimp, s | Assimp joining vertices, s |\n");
    fmt::print("|---|--:|--:|--:|--:|\n");
    for (const std::string& file : files) Compare(file);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    fmt::print(stderr, "snell-loading: {}\n", error.what());
    return EXIT_FAILURE;
  }
}
