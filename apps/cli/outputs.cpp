// SPDX-License-Identifier: Apache-2.0
#include "cli/outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "cli/console.h"
#include "util/file.h"

namespace snell::cli {

namespace fs = std::filesystem;

namespace {

constexpr float Nowhere = 1e10f;  // the depth of the background (docs/aovs.md)

// A name in `folder` that no file has: "a.png", "a-1.png", …
fs::path FreeName(const fs::path& folder, const fs::path& name) {
  std::error_code ignored;
  fs::path path = folder / name;
  for (int number = 1; fs::exists(path, ignored); ++number) {
    path = folder / name.stem();
    path += fmt::format("-{}", number);
    path += name.extension();
  }
  return path;
}

// Where a picture may go if its own place fails: to the current folder, to the temporary one, and, in case
// the format is to blame, into the format that takes every picture.
std::vector<fs::path> RescuePlaces(const fs::path& path) {
  std::error_code fault;
  const fs::path temporary = fs::temp_directory_path(fault);
  const fs::path name = path.filename();
  std::vector<fs::path> places = {FreeName("", name)};
  if (!fault) places.push_back(FreeName(temporary, name));
  if (LowerExtension(name) != "exr") {
    fs::path linear = name;
    places.push_back(FreeName("", linear.replace_extension("exr")));
  }
  std::erase(places, path.lexically_normal());
  return places;
}

}  // namespace

Written WriteOrRescue(const Output& output, const Picture& picture) {
  Written written;
  const auto attempt = [&](const fs::path& path) {
    try {
      WritePicture(path, picture, output.options);
      written.path = path;
      return true;
    } catch (const Error& error) {
      const std::vector<Diagnostic>& faults = error.diagnostics();
      written.faults.insert(written.faults.end(), faults.begin(), faults.end());
      return false;
    }
  };
  if (attempt(output.path)) return written;
  for (const fs::path& place : RescuePlaces(output.path))
    if (attempt(place)) break;
  return written;
}

std::vector<LayerPicture> LayerPictures(const Output& output, const Picture& picture) {
  std::vector<LayerPicture> pictures;
  if (output.denoised || LowerExtension(output.path) == "exr") return pictures;
  for (const PictureLayer& layer : picture.layers) {
    LayerPicture shown{output, {picture.width, picture.height, layer.values, {}, {}}};
    std::vector<float>& values = shown.picture.rgb;
    if (!layer.isColor) {
      shown.output.options.view = "raw";
      shown.output.options.exposure = 0;
    }
    if (layer.name == "normal") {
      for (float& value : values) value = 0.5f * value + 0.5f;
    } else if (layer.name == "depth") {
      float nearest = Nowhere, farthest = 0;
      for (const float depth : layer.values) {
        if (depth >= Nowhere) continue;
        nearest = std::min(nearest, depth);
        farthest = std::max(farthest, depth);
      }
      values.clear();
      for (const float depth : layer.values) {
        const float place = (depth - nearest) / std::max(farthest - nearest, 1e-20f);
        values.insert(values.end(), 3, std::clamp(1 - place, 0.0f, 1.0f));
      }
    } else if (!layer.isColor) {
      continue;
    }
    shown.output.path.replace_extension("." + layer.name + output.path.extension().string());
    pictures.push_back(std::move(shown));
  }
  return pictures;
}

void PrintFaults(const Output& output, const Written& written) {
  if (written.faults.empty()) return;
  PrintError(ToString(written.faults.front()));
  if (written.path.empty())
    PrintError(fmt::format("{}: the picture is lost; no other place could be written either",
                           output.path.string()));
  else
    PrintNote(fmt::format("the picture is in '{}' instead", written.path.string()));
}

void CheckTextWritable(const std::string& name) {
  if (name != "-") CheckFileWritable(name);
}

void WriteText(const std::string& name, std::string_view text) {
  if (name == "-")
    PrintOut(text);
  else
    WriteFile(name, text);
}

}  // namespace snell::cli
