// SPDX-License-Identifier: Apache-2.0
//
// What all parts of the pbrt reader work on: the scene that is being made, the files it may read, and what is
// to be reported.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "image/chromaticity.h"
#include "io/find_file.h"
#include "io/findings.h"
#include "io/images.h"
#include "io/pbrt/spectra.h"
#include "io/read_options.h"
#include "scene/scene.h"
#include "util/error.h"

namespace snell::io {

struct PbrtContext {
  PbrtContext(const std::filesystem::path& path, const ReadOptions& how, const WarningSink& sink)
      : file(path.string()),
        folder(path.parent_path()),
        options(how),
        warn(sink),
        files(FoldersOf(path, how)),
        images(FoldersOf(path, how), warn, how.limits) {}

  std::string file;
  std::filesystem::path folder;  // names in all files are relative to the first one's
  ReadOptions options;
  WarningSink warn;
  FileFinder files;
  ImageLoader images;
  Findings findings;
  scene::Scene scene;

  image::Chromaticities colorSpace;                // of the rgb values that follow
  std::map<std::string, PbrtTable> spectrumFiles;  // that have been read, by name
  int environmentMaps = 0;                         // that have been read
};

}  // namespace snell::io
