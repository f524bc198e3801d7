// SPDX-License-Identifier: Apache-2.0
#include "cli/outputs.h"

#include <fmt/format.h>

#include <system_error>

#include "cli/console.h"
#include "util/file.h"

namespace snell::cli {

namespace fs = std::filesystem;

namespace {

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
