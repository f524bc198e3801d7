// SPDX-License-Identifier: Apache-2.0
#include "cli/outputs.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
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

// Whether it must be written to as it is, not replaced: a pipe or a device, such as /dev/null.
bool IsSpecial(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored) && !fs::is_regular_file(path, ignored) &&
         !fs::is_directory(path, ignored);
}

void WriteToSpecial(const fs::path& path, std::string_view text) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "w"),
                                                             std::fclose);
  if (!file || std::fwrite(text.data(), 1, text.size(), file.get()) != text.size() ||
      std::fflush(file.get()) != 0)
    throw Error(fmt::format("cannot write: {}", std::strerror(errno)), {path.string()});
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

void CheckTextWritable(const std::string& name) {
  if (name != "-" && !IsSpecial(name)) AtomicFile attempt{fs::path(name)};
}

void WriteText(const std::string& name, std::string_view text) {
  if (name == "-")
    PrintOut(text);
  else if (IsSpecial(name))
    WriteToSpecial(name, text);
  else
    WriteFile(name, text);
}

}  // namespace snell::cli
