// SPDX-License-Identifier: Apache-2.0
//
// The options of "snell render" as they are given.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "api/snell.h"
#include "cli/film_options.h"
#include "cli/load_options.h"
#include "cli/outputs.h"

namespace snell::cli {

struct RenderArguments {
  std::string scene;
  std::vector<std::string> outputs;
  std::optional<std::string> bits;  // "8" or "16"
  bool exrFloat = false;
  std::optional<int> quality;
  std::optional<float> exposure;
  std::optional<std::string> view;
  std::optional<std::vector<std::string>> aovs;
  bool denoise = false;
  std::optional<std::string> denoiser;  // "nfor" or "oidn"; asks for denoising, too

  std::optional<std::pair<int, int>> size;  // 0: not given
  std::optional<std::array<int, 4>> crop;
  std::optional<std::string> camera;

  std::optional<int> spp;
  std::optional<std::pair<std::uint32_t, std::uint32_t>> samples;
  std::optional<std::string> integrator;
  std::optional<int> maxDepth;
  std::optional<int> maxDiffuseDepth;
  std::optional<int> maxSpecularDepth;
  std::optional<int> maxTransmissionDepth;
  std::optional<std::string> caustics;
  std::optional<float> minContribution;
  std::optional<float> clampIndirect;

  LoadArguments load;
  FilmArguments film;

  std::optional<int> threads;
  std::optional<std::string> device;
  bool gpuDebug = false;
  bool quiet = false;
  std::optional<std::string> stats;
};

// Declare the options. `arguments` must live until the command line has been parsed.
void AddRenderOptions(CLI::App& command, RenderArguments& arguments);
// Some of them alone, which other commands have, too: of pictures,
void AddOutputOptions(CLI::App& command, RenderArguments& arguments);
// --size and --camera, --spp,
void AddViewOptions(CLI::App& command, RenderArguments& arguments);
void AddSamplesPerPixelOption(CLI::App& command, RenderArguments& arguments);
// and how light is followed.
void AddTransportOptions(CLI::App& command, RenderArguments& arguments);

// `outputs` are the pictures that will be written.
RenderOptions RenderOptionsOf(const RenderArguments& arguments, const std::vector<Output>& outputs);

Denoiser DenoiserOf(const RenderArguments& arguments);

// The pictures to write, none if only a film is, without what is known only later (exposure, metadata). Throws UsageError if an
// option has nothing to work on.
std::vector<Output> OutputsOf(const RenderArguments& arguments);

}  // namespace snell::cli
