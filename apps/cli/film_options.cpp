// SPDX-License-Identifier: Apache-2.0
#include "cli/film_options.h"

#include <fmt/format.h>

#include <system_error>

#include "cli/values.h"

namespace snell::cli {

namespace fs = std::filesystem;

namespace {

constexpr const char* Extension = ".snell-film";
constexpr float LongestInterval = 1e6f;

// A place for the checkpoint: the film that is written anyway, or beside the first picture, unless that is a device or
// a pipe.
fs::path DefaultCheckpoint(const FilmArguments& arguments, const std::vector<Output>& outputs) {
  if (arguments.film) return *arguments.film;
  if (outputs.empty()) return {};
  fs::path path = outputs[0].path;
  std::error_code ignored;
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored)) return {};
  return path.replace_extension(Extension);
}

void CheckName(const char* option, const fs::path& name, const std::vector<Output>& outputs,
               const std::string& scene) {
  const char* taken = nullptr;
  for (const Output& output : outputs) {
    if (output.path.lexically_normal() == name.lexically_normal()) taken = "a picture";
  }
  std::error_code ignored;
  if (fs::equivalent(name, scene, ignored)) taken = "the scene";
  if (taken)
    throw UsageError(fmt::format("{} names '{}', which is {}", option, name.string(), taken));
}

}  // namespace

void AddEndOptions(CLI::App& command, FilmArguments& a) {
  AddValue<double>(command, "--time", "DURATION", ReadDuration, a.seconds,
                   "End after this time, such as 90, 45s, 2m or 1h, loading included; without "
                   "--spp, only then");
  AddValue(command, "--noise", "X", Number(1e-5f, 1), a.noise,
           "End when no pixel's standard error is above X, where 1 is the display's white; 0.02 is "
           "a draft, 0.005 fine. Pixels that are good enough rest. Without --spp, up to 65536 "
           "samples");
}

void AddFilmOptions(CLI::App& command, FilmArguments& a) {
  AddFlag(
      command, "--resume", a.resume,
      "Go on with the checkpoint of a render that was stopped or killed, if there is one: to the "
      "same picture, bit for bit");
  AddValue<std::string>(command, "--checkpoint", "FILE", ReadText, a.checkpoint,
                        "Where the checkpoint is saved (beside the first picture, .snell-film); it "
                        "is removed when the render is complete");
  AddValue(command, "--checkpoint-interval", "SECONDS", Number(0.01f, LongestInterval), a.interval,
           fmt::format("Time between checkpoints ({:g})", FilmOptions{}.interval));
  AddFlag(command, "--no-checkpoint", a.noCheckpoint, "Save none");
  AddValue<std::string>(command, "--film", "FILE", ReadText, a.film,
                        "Write the film, too: the samples, exactly, for 'snell merge' or to go on "
                        "with later. It serves as the checkpoint. Without -o, no picture is "
                        "written");
}

FilmOptions FilmOptionsOf(const FilmArguments& arguments, const std::vector<Output>& outputs,
                          const std::string& scene) {
  FilmOptions options;
  if (arguments.noCheckpoint && (arguments.resume || arguments.checkpoint || arguments.interval)) {
    const char* other = arguments.resume       ? "--resume"
                        : arguments.checkpoint ? "--checkpoint"
                                               : "--checkpoint-interval";
    throw UsageError(fmt::format("--no-checkpoint and {} contradict one another", other));
  }
  if (arguments.checkpoint)
    options.checkpoint = *arguments.checkpoint;
  else if (!arguments.noCheckpoint)
    options.checkpoint = DefaultCheckpoint(arguments, outputs);
  if (arguments.resume && options.checkpoint.empty())
    throw UsageError("--resume needs to know the checkpoint; name it by --checkpoint FILE");
  if (arguments.checkpoint) CheckName("--checkpoint", options.checkpoint, outputs, scene);
  if (arguments.film) {
    options.output = *arguments.film;
    CheckName("--film", options.output, outputs, scene);
  }
  options.interval = double(arguments.interval.value_or(float(options.interval)));
  options.resume = arguments.resume;
  return options;
}

}  // namespace snell::cli
