// SPDX-License-Identifier: Apache-2.0
//
// snell merge: films that were rendered apart become one picture.
#include <fmt/format.h>

#include "api/snell.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/render_options.h"
#include "cli/render_summary.h"
#include "cli/signals.h"
#include "cli/values.h"
#include "util/file.h"
#include "util/text.h"

namespace snell::cli {

namespace {

constexpr const char* Details =
    "Adds up films of one picture: ranges of its samples, parts of it, or both, rendered in any "
    "order and anywhere. The sum is that of one render, to the bit. Films of other scenes, other "
    "settings or the same samples are refused.\n\n"
    "  snell render scene.toml --spp 64 --samples 0:32 --film a.snell-film\n"
    "  snell render scene.toml --spp 64 --samples 32:64 --film b.snell-film\n"
    "  snell merge a.snell-film b.snell-film -o scene.exr";

struct MergeArguments {
  std::vector<std::string> films;
  RenderArguments pictures;  // only their options are declared
  std::optional<std::string> film;
  bool quiet = false;
};

int RunMerge(const MergeArguments& arguments) {
  if (arguments.pictures.outputs.empty() && !arguments.film)
    throw UsageError("what to write is missing: name a picture by -o or a film by --film");
  std::vector<Output> outputs;
  if (!arguments.pictures.outputs.empty()) outputs = OutputsOf(arguments.pictures);
  IgnoreWriteSignals();
  for (const Output& output : outputs) CheckPictureWritable(output.path, output.options);
  if (arguments.film) CheckFileWritable(*arguments.film);

  const std::vector<std::filesystem::path> films(arguments.films.begin(), arguments.films.end());
  const MergeResult result =
      MergeFilms(films, arguments.film.value_or(std::string()), DenoiserOf(arguments.pictures));
  if (result.emptyPixels > 0 && !arguments.quiet)
    PrintWarning({fmt::format("no film has samples of {}; black there",
                              Plural(result.emptyPixels, "pixel"))});

  std::vector<std::string> written;
  bool allInPlace = true;
  for (Output& output : outputs) {
    output.options.exposure = arguments.pictures.exposure.value_or(result.exposure);
    output.options.view =
        arguments.pictures.view.value_or(result.view.empty() ? "srgb" : result.view);
    output.options.metadata = {
        {"Software", "Snell " + Version()},
        {"Scene", Printable(std::filesystem::path(result.scene).filename().string())},
        {"Samples", SamplesText(result.samplesPerPixel)}};
    if (output.denoised) output.options.metadata.emplace_back("Denoiser", result.denoiser);
    const Written file = WriteOrRescue(output, output.denoised ? *result.denoised : result.picture);
    PrintFaults(output, file);
    if (!file.path.empty()) written.push_back(file.path.string());
    allInPlace = allInPlace && file.faults.empty();
  }
  if (arguments.film) written.push_back(*arguments.film);
  if (!arguments.quiet)
    PrintNote(fmt::format("{} × {} pixels, {} samples per pixel; written: {}", result.picture.width,
                          result.picture.height, SamplesText(result.samplesPerPixel),
                          fmt::join(written, ", ")));
  return allInPlace ? Succeeded : Failed;
}

}  // namespace

void AddMergeCommand(Program& program) {
  const auto arguments = std::make_shared<MergeArguments>();
  CLI::App& command = AddCommand<MergeArguments>(
      program, "merge", "Add up films that were rendered apart", Details, arguments, RunMerge);
  AddArguments(command, "FILM", arguments->films, "A film that 'snell render --film' has written");
  command.option_defaults()->group("Output");
  AddOutputOptions(command, arguments->pictures);
  AddValue<std::string>(command, "--film", "FILE", ReadText, arguments->film,
                        "Write the sum as a film, too");
  command.option_defaults()->group("Running");
  AddFlag(command, "-q,--quiet", arguments->quiet, "Say nothing but errors");
}

}  // namespace snell::cli
