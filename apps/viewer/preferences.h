// SPDX-License-Identifier: Apache-2.0
//
// What the viewer remembers from one time to the next, in $XDG_CONFIG_HOME/snell/viewer.conf: lines "name = value". What
// is missing or makes no sense there is as it would be the first time.
#pragma once

#include <filesystem>

namespace snell::viewer {

struct Preferences {
  bool dark = true;
  bool showsPanel = true;
  int width = 1280;  // of the window
  int height = 800;
};

// Where they are kept; empty if the system does not say.
std::filesystem::path PreferencesFile();

Preferences ReadPreferences(const std::filesystem::path& path);
// Faults are no matter: the viewer then does not remember.
void WritePreferences(const std::filesystem::path& path, const Preferences& preferences);

}  // namespace snell::viewer
