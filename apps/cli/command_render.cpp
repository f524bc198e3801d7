// SPDX-License-Identifier: Apache-2.0
//
// snell render: check the outputs, load the scene, render it, write the pictures, sum up.
#include <fmt/format.h>

#include "api/snell.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/outputs.h"
#include "cli/progress_bar.h"
#include "cli/render_options.h"
#include "cli/render_summary.h"
#include "cli/signals.h"
#include "cli/values.h"
#include "util/file.h"
#include "util/timer.h"

namespace snell::cli {

namespace fs = std::filesystem;

namespace {

constexpr const char* Details =
    "Renders SCENE and writes one or more pictures. A mesh is framed by a camera and lit by "
    "three lights. What the scene says about size and samples is the default of these "
    "options.\n\n"
    "  snell render part.obj --up z --size 1200 -o part.jpg\n"
    "  snell render scene.toml --spp 64 -o scene.png -o scene.exr\n"
    "  snell render scene.toml --crop 100,50,300,200 -o detail.png\n\n"
    "Ctrl-C ends a render early and writes what there is; pressed again, it ends the program "
    "at once. Long renders save a checkpoint now and then, with which --resume goes on. The exit "
    "status is 0 if all is well, 1 if a file, the memory or a GPU is at fault, 2 if the command "
    "line is "
    "wrong, and 130 after Ctrl-C.";

ProgressStyle StyleOf(const RenderArguments& arguments) {
  return arguments.quiet ? ProgressStyle::None : SuitableStyle();
}

// Report everything that is wrong with the outputs while it costs nothing yet.
void CheckOutputs(const RenderArguments& arguments, const std::vector<Output>& outputs,
                  const FilmOptions& films) {
  std::vector<Diagnostic> faults;
  const auto collect = [&](const auto& check) {
    try {
      check();
    } catch (const Error& error) {
      faults.insert(faults.end(), error.diagnostics().begin(), error.diagnostics().end());
    }
  };
  for (const Output& output : outputs)
    collect([&] { CheckPictureWritable(output.path, output.options); });
  if (arguments.film.checkpoint) collect([&] { CheckFileWritable(films.checkpoint); });
  if (arguments.film.film) collect([&] { CheckFileWritable(films.output); });
  if (arguments.stats) collect([&] { CheckTextWritable(*arguments.stats); });
  if (!faults.empty()) throw Error(std::move(faults));
}

Scene Load(const RenderArguments& arguments, RenderSummary& summary) {
  ProgressBar bar(StyleOf(arguments));
  const auto warn = [&](const Diagnostic& warning) {
    summary.warnings.push_back(ToString(warning));
    if (!arguments.quiet) bar.Interrupt([&] { PrintWarning(warning); });
  };
  bar.Begin("loading", 0);
  const Timer timer;
  Scene scene = cli::Load(arguments.scene, arguments.load, warn);
  summary.loadSeconds = timer.Seconds();
  return scene;
}

// What a picture says about itself. Nothing that differs from run to run, so that the same render gives the
// same bytes.
std::vector<std::pair<std::string, std::string>> MetadataOf(const RenderArguments& arguments,
                                                            const RenderReport& report) {
  std::vector<std::pair<std::string, std::string>> metadata = {
      {"Software", "Snell " + Version()},
      {"Scene", Printable(fs::path(arguments.scene).filename().string())},
      {"Samples", SamplesText(report.samplesPerPixel)}};
  if (arguments.samples)
    metadata.emplace_back(
        "SampleRange", fmt::format("{}:{}", arguments.samples->first, arguments.samples->second));
  if (arguments.crop)
    metadata.emplace_back("Crop", fmt::format("{}", fmt::join(*arguments.crop, ",")));
  return metadata;
}

// Write every picture, and its layers as pictures of their own where a format has no room for them; false if one is not
// where it was asked for.
bool WriteAll(const std::vector<Output>& outputs, const RenderResult& result, bool withLayers,
              ProgressBar& bar, RenderSummary& summary) {
  bool allInPlace = true;
  const Timer timer;
  bar.Begin("writing", outputs.size());
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const Picture& picture = outputs[i].denoised ? *result.denoised : result.picture;
    const Written written = WriteOrRescue(outputs[i], picture);
    bar.Interrupt([&] { PrintFaults(outputs[i], written); });
    if (!written.path.empty()) summary.files.push_back(written.path.string());
    allInPlace = allInPlace && written.faults.empty();
    bar.Update(i + 1, 0);
    if (!withLayers) continue;
    for (const LayerPicture& layer : LayerPictures(outputs[i], result.picture)) {
      const Written shown = WriteOrRescue(layer.output, layer.picture);
      bar.Interrupt([&] { PrintFaults(layer.output, shown); });
      allInPlace = allInPlace && shown.faults.empty();
    }
  }
  bar.End();
  summary.writeSeconds = timer.Seconds();
  return allInPlace;
}

// Say whether the render goes on with another one's film.
void TellOfCheckpoint(const FilmOptions& films) {
  std::error_code ignored;
  const std::string name = films.checkpoint.string();
  const bool exists = !name.empty() && fs::exists(films.checkpoint, ignored);
  if (films.resume && !exists)
    PrintNote(fmt::format("there is no checkpoint '{}'; the render begins anew", name));
  else if (exists && !films.resume && films.checkpoint != films.output)
    PrintNote(fmt::format("'{}' holds a render that was stopped; --resume goes on with it", name));
}

// Once its picture is written, nobody needs a checkpoint.
void RemoveCheckpoint(const FilmOptions& films, const RenderReport& report) {
  std::error_code ignored;
  if ((films.resume || report.checkpointSaved) && films.checkpoint != films.output)
    fs::remove(films.checkpoint, ignored);
}

std::string InterruptionText(const RenderReport& report) {
  if (report.samplesPerPixel == 0)
    return "interrupted before anything was rendered; nothing is written";
  const char* gaps = report.samplesPerPixel < 1 ? "; parts of it are black" : "";
  const char* more = report.checkpointSaved ? "; --resume goes on with it" : "";
  return fmt::format("interrupted; the picture has {} samples per pixel{}{}",
                     SamplesText(report.samplesPerPixel), gaps, more);
}

std::string FaultText(const RenderReport& report) {
  return fmt::format("{}; {}{}", report.fault,
                     report.samplesPerPixel == 0
                         ? "nothing is written"
                         : fmt::format("the picture has {} samples per pixel",
                                       SamplesText(report.samplesPerPixel)),
                     report.checkpointSaved ? "; --resume goes on with it" : "");
}

int RunRender(const RenderArguments& arguments) {
  const Timer timer;
  std::vector<Output> outputs = OutputsOf(arguments);
  RenderOptions options = RenderOptionsOf(arguments, outputs);
  IgnoreWriteSignals();
  CheckOutputs(arguments, outputs, options.film);
  if (options.film.resume)
    for (const Output& output : outputs) RemoveAbandoned(output.path);

  RenderSummary summary;
  summary.scene = arguments.scene;
  const Scene scene = Load(arguments, summary);
  if (!arguments.quiet) TellOfCheckpoint(options.film);
  if (!arguments.quiet && arguments.outputs.empty() && !outputs.empty())
    PrintNote(
        fmt::format("the picture will be '{}'; -o chooses another name", outputs[0].path.string()));

  // Render until done or told to stop
  const StopOnSignal stop;
  ProgressBar bar(StyleOf(arguments), &stop.flag());
  if (options.seconds) *options.seconds -= timer.Seconds();
  const RenderResult result = Render(scene, options, &bar, &stop.flag());
  summary.report = result.report;
  summary.width = result.picture.width;
  summary.height = result.picture.height;
  for (const std::string& warning : result.report.warnings) {
    summary.warnings.push_back(warning);
    if (!arguments.quiet) PrintWarning({warning, {arguments.scene}});
  }
  if (result.report.stopped && !arguments.quiet) PrintNote(InterruptionText(result.report));
  if (!result.report.fault.empty()) PrintError(FaultText(result.report));

  // Write what there is
  for (Output& output : outputs) {
    output.options.exposure = arguments.exposure.value_or(scene.exposure());
    output.options.view = arguments.view.value_or(scene.view());
    output.options.metadata = MetadataOf(arguments, result.report);
    if (output.denoised) output.options.metadata.emplace_back("Denoiser", result.report.denoiser);
  }
  bool allInPlace = true;
  if (result.report.samplesPerPixel > 0)
    allInPlace = WriteAll(outputs, result, arguments.aovs.has_value(), bar, summary);
  if (!result.report.filmFault.empty()) {
    PrintError(result.report.filmFault);
    allInPlace = false;
  } else if (!options.film.output.empty() && result.report.samplesPerPixel > 0) {
    summary.files.push_back(options.film.output.string());
  }
  const bool isWhole = !result.report.stopped && result.report.fault.empty();
  if (allInPlace && isWhole) RemoveCheckpoint(options.film, result.report);

  // Sum up
  summary.totalSeconds = timer.Seconds();
  summary.peakBytes = PeakMemoryBytes();
  if (!arguments.quiet) PrintParagraph(SummaryText(summary));
  if (arguments.stats) WriteText(*arguments.stats, SummaryJson(summary));
  if (!allInPlace || !result.report.fault.empty()) return Failed;
  return stop.signal() ? Signalled + stop.signal() : Succeeded;
}

}  // namespace

void AddRenderCommand(Program& program) {
  const auto arguments = std::make_shared<RenderArguments>();
  CLI::App& command = AddCommand<RenderArguments>(program, "render", "Render a scene or a mesh",
                                                  Details, arguments, RunRender);
  AddRenderOptions(command, *arguments);
}

}  // namespace snell::cli
