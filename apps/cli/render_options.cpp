// SPDX-License-Identifier: Apache-2.0
#include "cli/render_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>
#include <sstream>

#include "cli/values.h"
#include "util/file.h"

namespace snell::cli {

namespace fs = std::filesystem;

namespace {

constexpr int MaxSamples = std::numeric_limits<int>::max();
constexpr int MaxThreads = 4096;
constexpr float MaxStops = 100;

// "albedo,normal".
std::vector<std::string> ReadAovs(const std::string& text) {
  const std::vector<std::string> known = KnownAovs();
  std::vector<std::string> aovs;
  std::istringstream list(text);
  for (std::string name; std::getline(list, name, ',');) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw BadValue(fmt::format("must be some of {}", fmt::join(known, ", ")));
    aovs.push_back(name);
  }
  return aovs;
}

}  // namespace

void AddOutputOptions(CLI::App& command, RenderArguments& a) {
  AddValues(
      command, "-o,--output", "FILE", ReadText, a.outputs,
      "Write the picture to FILE, whose extension names the format: " + KnownPictureExtensions() +
          ". May be given several times. Without it, SCENE's name with .png in the current folder");
  AddChoice(command, "--bits", "8|16", a.bits, "PNG: bits per channel (8)");
  AddFlag(command, "--float", a.exrFloat, "EXR: 32-bit floats instead of 16-bit ones");
  AddValue(command, "--quality", "N", WholeNumber(1, 100), a.quality,
           fmt::format("JPEG: quality from 1 to 100 ({})", PictureOptions{}.jpegQuality));
  AddValue(
      command, "--exposure", "STOPS", Number(-MaxStops, MaxStops), a.exposure,
      "PNG and JPEG: brighten by this many factors of two (the scene's, or 0); EXR and HDR stay "
      "linear");
  AddChoice(command, "--view", "srgb|agx|neutral|aces|false-color|raw", a.view,
            "PNG and JPEG: how light brighter than white is shown (the scene's, or \"srgb\")");
  AddFlag(command, "--denoise", a.denoise,
          "Write each picture a second time, without noise, with .denoised before its extension");
  AddChoice(command, "--denoiser", "nfor|oidn", a.denoiser,
            "The same by the built-in denoiser or by Open Image Denoise (the latter if it is "
            "installed)");
}

void AddViewOptions(CLI::App& command, RenderArguments& a) {
  AddValue<std::pair<int, int>>(
      command, "--size", "WxH", ReadSize, a.size,
      "Width and height in pixels (the scene's, or 800x600); one alone, 1200 or x900, keeps the "
      "proportions");
  AddValue<std::string>(command, "--camera", "NAME", ReadText, a.camera,
                        "The scene's camera of this name instead of its first one");
}

void AddSamplesPerPixelOption(CLI::App& command, RenderArguments& a) {
  AddValue(command, "--spp", "N", WholeNumber(1, MaxSamples), a.spp,
           "Samples per pixel; for paths 64 (the scene's, or 16)");
}

void AddTransportOptions(CLI::App& command, RenderArguments& a) {
  AddChoice(command, "--integrator", "whitted|path", a.integrator,
            "How light is followed (the scene's, or path where a material is physical)");
  AddValue(command, "--max-depth", "N", WholeNumber(1, MaxSamples), a.maxDepth,
           "Longest chain of rays, 1: from the camera only (the scene's, or 16)");
  AddValue(command, "--max-diffuse-depth", "N", WholeNumber(0, MaxSamples), a.maxDiffuseDepth,
           "Path tracer: reflections by matt surfaces along a path, 1: they show direct light only "
           "(the scene's, or any)");
  AddValue(command, "--max-specular-depth", "N", WholeNumber(0, MaxSamples), a.maxSpecularDepth,
           "Path tracer: the same by mirrors, smooth or glossy");
  AddValue(command, "--max-transmission-depth", "N", WholeNumber(0, MaxSamples),
           a.maxTransmissionDepth, "Path tracer: the same of passages through surfaces");
  AddChoice(command, "--caustics", "full|regularized|none", a.caustics,
            "Path tracer: light that mirrors and glass throw onto rough surfaces, regularized: "
            "blurred for less noise (the scene's, or full)");
  AddValue(command, "--min-contribution", "X", Number(0, 1), a.minContribution,
           "Follow no ray that adds less than this to its pixel (the scene's, or 0.002)");
  AddValue(command, "--clamp-indirect", "X", Number(0, 1e9f), a.clampIndirect,
           "Path tracer: the most that indirect light adds to a pixel at once (the scene's, or 0: "
           "any); removes fireflies, and some light");
}

namespace {

void AddPartOptions(CLI::App& command, RenderArguments& a) {
  AddValue<std::array<int, 4>>(command, "--crop", "X0,Y0,X1,Y1", ReadCrop, a.crop,
                               "Render only this part of the picture, in pixels from its top left "
                               "corner; X1 and Y1 are left out");
}

void AddQualityOptions(CLI::App& command, RenderArguments& a) {
  AddSamplesPerPixelOption(command, a);
  AddEndOptions(command, a.film);
  AddValue<std::pair<std::uint32_t, std::uint32_t>>(
      command, "--samples", "A:B", ReadSampleRange, a.samples,
      "Only the samples from number A up to B, which is left out");
  AddTransportOptions(command, a);
}

void AddRunOptions(CLI::App& command, RenderArguments& a) {
  AddValue(
      command, "--threads", "N", WholeNumber(1, MaxThreads), a.threads,
      "Threads to work with; all processors without it. The picture is the same for any number");
  AddValue<std::string>(command, "--device", "DEVICE", ReadText, a.device,
                        "Where to render: cpu, gpu, gpu:N or a part of a GPU's name as 'snell "
                        "devices' lists them (auto: "
                        "a GPU, if there is one that is no software, else the processor)");
  AddFlag(command, "--gpu-debug", a.gpuDebug,
          "Let Vulkan's validation layer watch; what it finds are warnings");
  AddFlag(command, "-q,--quiet", a.quiet, "Say nothing but errors");
  AddValue<std::string>(
      command, "--stats", "FILE", ReadText, a.stats,
      "Write times, counts of rays and memory as JSON; '-' is the standard output");
}

bool AnyIs(const std::vector<Output>& outputs, std::initializer_list<const char*> extensions) {
  return std::any_of(outputs.begin(), outputs.end(), [&](const Output& output) {
    return std::count(extensions.begin(), extensions.end(), LowerExtension(output.path)) > 0;
  });
}

// What is written last must not replace a picture or the scene.
void CheckStatistics(const std::string& name, const std::string& scene,
                     const std::set<fs::path>& pictures) {
  std::error_code ignored;
  const bool isPicture = pictures.count(fs::path(name).lexically_normal()) > 0;
  const bool isScene = fs::equivalent(name, scene, ignored);
  if (isPicture || isScene)
    throw UsageError(fmt::format("--stats names '{}', which is {}", name,
                                 isPicture ? "a picture" : "the scene"));
}

}  // namespace

void AddRenderOptions(CLI::App& command, RenderArguments& arguments) {
  AddArgument(command, "SCENE", arguments.scene,
              "A scene or a mesh (" + KnownSceneExtensions() + ")");
  command.option_defaults()->group("Output");
  AddOutputOptions(command, arguments);
  AddValue<std::vector<std::string>>(
      command, "--aov", "LIST", ReadAovs, arguments.aovs,
      fmt::format(
          "Layers to write into EXRs, or beside other pictures (the scene's, or none), with commas "
          "between them: {}",
          fmt::join(KnownAovs(), ", ")));
  command.option_defaults()->group("View");
  AddViewOptions(command, arguments);
  AddPartOptions(command, arguments);
  command.option_defaults()->group("Quality");
  AddQualityOptions(command, arguments);
  AddLoadOptions(command, arguments.load);
  command.option_defaults()->group("Long renders");
  AddFilmOptions(command, arguments.film);
  command.option_defaults()->group("Running");
  AddRunOptions(command, arguments);
}

RenderOptions RenderOptionsOf(const RenderArguments& arguments,
                              const std::vector<Output>& outputs) {
  RenderOptions options;
  const auto [width, height] = arguments.size.value_or(std::pair(0, 0));
  if (width > 0) options.width = width;
  if (height > 0) options.height = height;
  options.spp = arguments.spp;
  options.maxDepth = arguments.maxDepth;
  options.maxDiffuseDepth = arguments.maxDiffuseDepth;
  options.maxSpecularDepth = arguments.maxSpecularDepth;
  options.maxTransmissionDepth = arguments.maxTransmissionDepth;
  options.caustics = arguments.caustics;
  options.minContribution = arguments.minContribution;
  options.clampIndirect = arguments.clampIndirect;
  options.integrator = arguments.integrator;
  options.camera = arguments.camera;
  options.crop = arguments.crop;
  options.samples = arguments.samples;
  options.aovs = arguments.aovs;
  options.denoiser = DenoiserOf(arguments);
  options.seconds = arguments.film.seconds;
  options.noise = arguments.film.noise;
  options.exposure = arguments.exposure;
  options.film = FilmOptionsOf(arguments.film, outputs, arguments.scene);
  options.threads = arguments.threads.value_or(0);
  options.device = arguments.device.value_or("auto");
  options.gpuDebug = arguments.gpuDebug;
  return options;
}

Denoiser DenoiserOf(const RenderArguments& arguments) {
  if (arguments.denoiser) return *arguments.denoiser == "oidn" ? Denoiser::Oidn : Denoiser::Nfor;
  return arguments.denoise ? Denoiser::Automatic : Denoiser::None;
}

std::vector<Output> OutputsOf(const RenderArguments& arguments) {
  std::vector<Output> outputs;
  std::set<fs::path> seen;
  std::vector<std::string> names = arguments.outputs;
  if (names.empty() && !arguments.film.film)
    names.push_back(fs::path(arguments.scene).stem().string() + ".png");
  for (const std::string& name : names) {
    if (!seen.insert(fs::path(name).lexically_normal()).second)
      throw UsageError("--output names '" + name + "' twice");
    Output output{ReadFor<std::string>("--output", "FILE", ReadPictureName, name), {}};
    // Formats without a choice take what they have
    if (arguments.bits == "16" && LowerExtension(name) == "png") output.options.bits = 16;
    output.options.exrFloat = arguments.exrFloat;
    output.options.jpegQuality = arguments.quality.value_or(output.options.jpegQuality);
    outputs.push_back(output);
    if (!arguments.denoise && !arguments.denoiser) continue;
    output.denoised = true;
    output.path.replace_extension(".denoised" + output.path.extension().string());
    if (!seen.insert(output.path.lexically_normal()).second)
      throw UsageError("--output names '" + output.path.string() +
                       "', where the denoised picture goes");
    outputs.push_back(std::move(output));
  }

  if (arguments.stats) CheckStatistics(*arguments.stats, arguments.scene, seen);

  // An option that changes nothing is a misunderstanding
  const auto require = [&](bool given, const char* option,
                           std::initializer_list<const char*> extensions) {
    if (given && !AnyIs(outputs, extensions))
      throw UsageError(std::string(option) + " is for ." + *extensions.begin() +
                       " files, and none is written");
  };
  require(arguments.bits.has_value(), "--bits", {"png"});
  require(arguments.exrFloat, "--float", {"exr"});
  require(arguments.view.has_value(), "--view", {"png", "jpg", "jpeg"});
  require(arguments.quality.has_value(), "--quality", {"jpg", "jpeg"});
  require(arguments.exposure.has_value(), "--exposure", {"png", "jpg", "jpeg"});
  return outputs;
}

}  // namespace snell::cli
