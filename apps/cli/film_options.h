// SPDX-License-Identifier: Apache-2.0
//
// The options of "snell render" about when a render ends and about its film: checkpoints, resuming, parts.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "api/snell.h"
#include "cli/outputs.h"

namespace snell::cli {

struct FilmArguments {
  std::optional<double> seconds;
  std::optional<float> noise;

  std::optional<std::string> checkpoint;
  std::optional<float> interval;
  bool noCheckpoint = false;
  bool resume = false;
  std::optional<std::string> film;
};

// Declare the options: of the end in the present group, of films in one of their own. `arguments` must live until the
// command line has been parsed.
void AddEndOptions(CLI::App& command, FilmArguments& arguments);
void AddFilmOptions(CLI::App& command, FilmArguments& arguments);

// Where films are read and saved: the checkpoint beside the first picture unless it is named. Throws UsageError if
// options do not go together or a name is taken by a picture or the scene.
FilmOptions FilmOptionsOf(const FilmArguments& arguments, const std::vector<Output>& outputs,
                          const std::string& scene);

}  // namespace snell::cli
