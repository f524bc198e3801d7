// SPDX-License-Identifier: Apache-2.0
//
// snell compare: how far a picture is from a reference.
#include <fmt/format.h>

#include <limits>

#include "api/snell.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/values.h"

namespace snell::cli {

namespace {

constexpr const char* Details =
    "Prints the differences between two pictures of the same size. FLIP and PSNR are taken of "
    "the pictures as they are displayed, the other figures of linear values. With --tolerance "
    "the exit status is 1 if the pictures are farther apart than that.";

struct CompareArguments {
  std::string reference;
  std::string picture;
  std::optional<std::array<int, 4>> crop;
  std::optional<std::string> output;
  std::optional<float> tolerance;
  std::optional<std::string> metric;
};

// A figure of the comparison. All but PSNR grow with the difference.
struct Metric {
  const char* name;
  const char* title;
  double PictureDifference::*value;
  const char* unit;
  const char* meaning;
};

constexpr Metric Metrics[] = {
    {"flip", "FLIP", &PictureDifference::meanFlip, "",
     "mean, as displayed; 0 is equal, 1 the most"},
    {"rmse", "RMSE", &PictureDifference::rmse, "", "root of the mean squared difference"},
    {"relmse", "relMSE", &PictureDifference::relMse, "",
     "mean of the squared difference relative to the reference"},
    {"psnr", "PSNR", &PictureDifference::psnr, " dB", "as displayed; inf is equal"},
    {"max", "max", &PictureDifference::maxAbs, "", "largest difference of a channel"},
};

const Metric& MetricOf(const CompareArguments& arguments) {
  for (const Metric& metric : Metrics)
    if (arguments.metric.value_or(Metrics[0].name) == metric.name) return metric;
  return Metrics[0];
}

// What is not a number is never within.
bool IsWithin(const Metric& metric, double value, double tolerance) {
  const bool growsWithLikeness = metric.value == &PictureDifference::psnr;
  return growsWithLikeness ? value >= tolerance : value <= tolerance;
}

int RunCompare(const CompareArguments& arguments) {
  if (arguments.metric && !arguments.tolerance)
    throw UsageError("--metric names what --tolerance limits, and needs it");
  if (arguments.output) CheckPictureWritable(*arguments.output);

  Picture reference = ReadPicture(arguments.reference);
  Picture picture = ReadPicture(arguments.picture);
  if (arguments.crop) {
    reference = CropPicture(reference, *arguments.crop);
    picture = CropPicture(picture, *arguments.crop);
  }
  const PictureDifference difference = ComparePictures(reference, picture);
  for (const Metric& metric : Metrics) {
    const std::string figure = fmt::format("{:.6g}{}", difference.*metric.value, metric.unit);
    PrintOut(fmt::format("{:<7} {:<12}  {}\n", metric.title, figure, metric.meaning));
  }
  PrintOut(fmt::format("mean    {:<12.6g}  of all channels, linear; of the reference {:.6g}\n",
                       difference.meanTest, difference.meanReference));
  if (arguments.output) WritePicture(*arguments.output, DifferencePicture(reference, picture));

  // Judge
  if (!arguments.tolerance) return Succeeded;
  const Metric& metric = MetricOf(arguments);
  const double value = difference.*metric.value;
  if (IsWithin(metric, value, double(*arguments.tolerance))) return Succeeded;
  PrintNote(fmt::format("the pictures differ: {} is {:.6g}{}, the tolerance is {:g}", metric.title,
                        value, metric.unit, *arguments.tolerance));
  return Failed;
}

}  // namespace

void AddCompareCommand(Program& program) {
  const auto arguments = std::make_shared<CompareArguments>();
  CLI::App& command = AddCommand<CompareArguments>(
      program, "compare", "Tell how far two pictures are apart", Details, arguments, RunCompare);
  AddArgument(command, "REFERENCE", arguments->reference,
              "A picture (" + KnownPictureExtensions() + ")");
  AddArgument(command, "PICTURE", arguments->picture, "The picture to compare with it");
  std::string names;
  for (const Metric& metric : Metrics)
    names += (names.empty() ? "" : "|") + std::string(metric.name);
  command.option_defaults()->group("Comparing");
  AddValue<std::string>(command, "-o,--output", "FILE", ReadPictureName, arguments->output,
                        "Write a picture of the FLIP error of each pixel in false colours");
  AddValue<std::array<int, 4>>(command, "--crop", "X0,Y0,X1,Y1", ReadCrop, arguments->crop,
                               "Compare only these pixels, counted from the top left");
  AddValue(command, "--tolerance", "X", Number(0, std::numeric_limits<float>::max()),
           arguments->tolerance, "Exit with 1 if the metric is above X, or for PSNR below it");
  AddChoice(command, "--metric", names, arguments->metric, "What --tolerance limits (flip)");
}

}  // namespace snell::cli
