// SPDX-License-Identifier: Apache-2.0
//
// The options of all commands that open scenes, as they are given.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "api/snell.h"

namespace snell::cli {

struct LoadArguments {
  std::optional<std::string> up;  // "y" or "z"
  std::optional<float> smooth;
  std::optional<float> time;
  std::optional<std::string> environment;  // a file
  std::vector<std::string> folders;
  std::vector<std::string> limits;  // "NAME=VALUE"
};

// Declare the options. `arguments` must live until the command line has been parsed.
void AddLoadOptions(CLI::App& command, LoadArguments& arguments);

// Open a scene. `warn` also hears of options that change nothing for this file.
Scene Load(const std::string& scene, const LoadArguments& arguments, WarningSink warn);

}  // namespace snell::cli
