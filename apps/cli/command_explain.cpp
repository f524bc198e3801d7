// SPDX-License-Identifier: Apache-2.0
//
// snell explain: the rays behind a sample of a pixel, or the causes of what a pixel looks like.
#include <fmt/format.h>

#include <limits>

#include "api/snell.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/load_options.h"
#include "cli/outputs.h"
#include "cli/render_options.h"
#include "cli/values.h"

namespace snell::cli {

namespace {

constexpr int Most = std::numeric_limits<int>::max();

constexpr const char* Details =
    "Follows one sample of the pixel X Y, counted from the upper left corner, just as 'snell "
    "render' with the same options does, and prints the tree of its rays: what each met, which "
    "lights were asked there and what was in their way, how the path went on, and the terms that "
    "the sample's radiance is the sum of, to the bit.\n\n"
    "--why looks at many samples instead and sorts the causes. What is printed of a sample can "
    "also be written as data, as a drawing, and as lines that a viewer of glTF shows over the "
    "scene.";

struct ExplainArguments {
  RenderArguments render;  // those of its options that samples depend on
  std::string x;
  std::string y;
  std::optional<int> sample;
  std::optional<std::string> json;
  std::optional<std::string> svg;
  std::optional<std::string> gltf;
  std::optional<std::string> why;
  std::optional<int> samples;
};

PixelQuestion QuestionOf(const std::string& why) {
  if (why == "black") return PixelQuestion::Black;
  return why == "bright" ? PixelQuestion::Bright : PixelQuestion::Noisy;
}

int RunExplain(const ExplainArguments& arguments) {
  const int x = ReadFor<int>("X", "X", WholeNumber(0, Most), arguments.x);
  const int y = ReadFor<int>("Y", "Y", WholeNumber(0, Most), arguments.y);
  if (arguments.why && (arguments.sample || arguments.json || arguments.svg || arguments.gltf))
    throw UsageError("--why looks at many samples; --sample and files are of one");
  if (arguments.samples && !arguments.why) throw UsageError("--samples is for --why");

  const PixelExplainer explainer(Load(arguments.render.scene, arguments.render.load, PrintWarning),
                                 RenderOptionsOf(arguments.render, {}));
  if (arguments.why) {
    PrintOut(Printable(explainer.Why(QuestionOf(*arguments.why), x, y,
                                     std::uint32_t(arguments.samples.value_or(64)))));
    return Succeeded;
  }
  const SampleExplanation told =
      explainer.Explain(x, y, std::uint32_t(arguments.sample.value_or(0)));
  if (arguments.json) WriteText(*arguments.json, told.json);
  if (arguments.svg) WriteText(*arguments.svg, told.svg);
  if (arguments.gltf) WriteText(*arguments.gltf, told.gltf);
  const bool isPrinted = arguments.json == "-" || arguments.svg == "-" || arguments.gltf == "-";
  if (!isPrinted) PrintOut(Printable(told.text));
  return Succeeded;
}

}  // namespace

void AddExplainCommand(Program& program) {
  const auto arguments = std::make_shared<ExplainArguments>();
  CLI::App& command = AddCommand<ExplainArguments>(
      program, "explain", "Tell how a pixel came about", Details, arguments, RunExplain);
  AddArgument(command, "SCENE", arguments->render.scene,
              "A scene or a mesh (" + KnownSceneExtensions() + ")");
  AddArgument(command, "X", arguments->x, "The pixel's column, from 0 at the left");
  AddArgument(command, "Y", arguments->y, "Its row, from 0 at the top");
  command.option_defaults()->group("Question");
  AddValue(command, "--sample", "N", WholeNumber(0, Most), arguments->sample,
           "The number of the sample to follow (0)");
  AddChoice(command, "--why", "black|bright|noisy", arguments->why,
            "Sort the causes of what the pixel looks like");
  AddValue(command, "--samples", "N", WholeNumber(1, 1 << 20), arguments->samples,
           "How many samples --why looks at (64)");
  command.option_defaults()->group("Output");
  AddValue<std::string>(command, "--json", "FILE", ReadText, arguments->json,
                        "Write all of it as JSON; '-' is the standard output");
  AddValue<std::string>(command, "--svg", "FILE", ReadText, arguments->svg,
                        "Draw the rays from above and from the side");
  AddValue<std::string>(command, "--gltf", "FILE", ReadText, arguments->gltf,
                        "Write the rays as coloured lines in the scene's space");
  command.option_defaults()->group("View");
  AddViewOptions(command, arguments->render);
  command.option_defaults()->group("Quality");
  AddSamplesPerPixelOption(command, arguments->render);
  AddTransportOptions(command, arguments->render);
  AddLoadOptions(command, arguments->render.load);
}

}  // namespace snell::cli
