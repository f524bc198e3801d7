// SPDX-License-Identifier: Apache-2.0
#include "viewer/preferences.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <fstream>
#include <string>
#include <system_error>

#include "util/error.h"
#include "util/file.h"

namespace snell::viewer {

namespace fs = std::filesystem;

namespace {

constexpr int SmallestWindow = 200;
constexpr int LargestWindow = 16384;

void Take(const std::string& name, const std::string& value, Preferences& preferences) {
  int number = 0;
  const auto [end, fault] = std::from_chars(value.data(), value.data() + value.size(), number);
  if (fault != std::errc() || end != value.data() + value.size()) return;
  const bool isSize = number >= SmallestWindow && number <= LargestWindow;
  if (name == "dark") preferences.dark = number != 0;
  if (name == "panel") preferences.showsPanel = number != 0;
  if (name == "width" && isSize) preferences.width = number;
  if (name == "height" && isSize) preferences.height = number;
}

}  // namespace

fs::path PreferencesFile() {
  if (const char* folder = std::getenv("XDG_CONFIG_HOME"); folder && fs::path(folder).is_absolute())
    return fs::path(folder) / "snell" / "viewer.conf";
  if (const char* home = std::getenv("HOME"); home && *home)
    return fs::path(home) / ".config" / "snell" / "viewer.conf";
  return {};
}

Preferences ReadPreferences(const fs::path& path) {
  Preferences preferences;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    const std::size_t equals = line.find(" = ");
    if (equals != std::string::npos)
      Take(line.substr(0, equals), line.substr(equals + 3), preferences);
  }
  return preferences;
}

void WritePreferences(const fs::path& path, const Preferences& preferences) {
  if (path.empty()) return;
  std::error_code fault;
  fs::create_directories(path.parent_path(), fault);
  try {
    WriteFile(path,
              fmt::format("dark = {}\npanel = {}\nwidth = {}\nheight = {}\n", int(preferences.dark),
                          int(preferences.showsPanel), preferences.width, preferences.height));
  } catch (const Error&) {
  }
}

}  // namespace snell::viewer
