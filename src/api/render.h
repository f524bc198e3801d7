// SPDX-License-Identifier: Apache-2.0
//
// Snell's public interface: rendering. Installed as <snell/api/render.h>.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../util/progress.h"
#include "picture.h"
#include "scene.h"

namespace snell {

// Films: files that hold all that a render has found, to go on with it or to merge it with others
// (api/merge.h). docs/long-renders.md
struct FilmOptions {
  std::filesystem::path
      checkpoint;                // saved now and then, and when the render is stopped; empty: never
  double interval = 60;          // seconds between
  bool resume = false;           // go on with the checkpoint, if there is one
  std::filesystem::path output;  // saved at the end; empty: not
};
// How to take noise out of pictures: "nfor" is built in; "oidn" is Open Image Denoise, if its library is installed.
enum class Denoiser { None, Automatic, Nfor, Oidn };

// Where a camera stands, and what it looks at: metres. Its vertical angle of view stands for the height of the view at
// lookAt where a camera is orthographic; panoramas and fisheyes keep their own.
struct CameraView {
  std::array<double, 3> position{0, 0, 5};
  std::array<double, 3> lookAt{};
  std::array<double, 3> up{0, 1, 0};
  double fovDegrees = 40;
};

// Overrides what the scene says; whatever is empty stays as the scene has it.
struct RenderOptions {
  std::optional<int> width;
  std::optional<int> height;
  std::optional<int> spp;
  std::optional<int> maxDepth;
  // Path tracer: of the bends along a path, those by kind
  std::optional<int> maxDiffuseDepth;
  std::optional<int> maxSpecularDepth;
  std::optional<int> maxTransmissionDepth;
  std::optional<std::string> caustics;  // "full", "regularized" or "none"
  std::optional<float> minContribution;
  std::optional<float> clampIndirect;
  std::optional<std::string> integrator;  // "whitted" or "path"; else by the materials
  std::optional<std::string> camera;      // by name; else the first one
  std::optional<CameraView> cameraView;   // another place for that camera, where it stands still
  std::optional<std::array<int, 4>>
      crop;  // x0, y0, x1, y1 in pixels; the picture has just these pixels
  std::optional<std::pair<std::uint32_t, std::uint32_t>>
      samples;                                   // [first, last) instead of [0, spp)
  std::optional<std::vector<std::string>> aovs;  // layers of the picture (docs/aovs.md), "all"
  Denoiser denoiser = Denoiser::None;            // Automatic: Open Image Denoise, else nfor
  // The render ends at the first of these. With one of them and without `spp`, the scene's spp does not count.
  std::optional<double> seconds;  // since Render was called; each pixel gets a sample at least
  std::optional<float> noise;     // standard error of each pixel as it shows, 1 is white; above 0
  std::optional<float> exposure;  // stops at which that counts; else the scene's
  FilmOptions film;
  int threads = 0;  // 0: all processors
  // "cpu"; "gpu", the best one; "gpu:N" or a part of a name (api/devices.h); "auto", the best GPU that is hardware,
  // or, if there is none or it fails, the processor
  std::string device = "auto";
  bool gpuDebug = false;  // let Vulkan's validation layer watch; what it finds are warnings
};

// The names of AOVs, for messages.
SNELL_EXPORT std::vector<std::string> KnownAovs();

// Why a render ended.
enum class RenderEnd { Samples, Noise, Time, Stopped, Fault };

// How sure a picture is, where noise was asked for.
struct NoiseReport {
  double rms = 0;            // of the pixels' standard errors as they show, 1 is white
  double largest = 0;        // of them
  std::uint64_t pixels = 0;  // that have not reached what was asked
};

struct RenderReport {
  std::string device;
  int threads = 0;
  RenderEnd end = RenderEnd::Samples;
  std::string fault;             // of the device, that ended the render; "" without
  bool stopped = false;          // by the stop flag, before all samples were done
  double samplesPerPixel = 0;    // of the picture, the mean over its pixels
  double resumedSamples = 0;     // of these, those that were there before
  bool checkpointSaved = false;  // by this render
  std::string filmFault;         // why the film at the end could not be saved; "" if it was
  std::optional<NoiseReport> noise;
  double heldBack = 0;  // share of all light that clampIndirect has removed
  std::uint64_t cameraRays = 0;
  std::uint64_t reflectedRays = 0;
  std::uint64_t refractedRays = 0;
  std::uint64_t shadowRays = 0;
  double prepareSeconds = 0;  // flattening the scene
  double buildSeconds = 0;    // the BVH
  double renderSeconds = 0;
  double denoiseSeconds = 0;
  std::string denoiser;  // that was used
  std::uint64_t sceneBytes = 0;
  std::uint64_t bvhBytes = 0;
  std::uint64_t filmBytes = 0;
  std::vector<std::string>
      warnings;  // of what happened while rendering: samples that were not finite, …

  std::uint64_t Rays() const { return cameraRays + reflectedRays + refractedRays + shadowRays; }
};

struct RenderResult {
  Picture picture;
  std::optional<Picture> denoised;  // if that was asked for
  RenderReport report;
};

// Render a scene. `progress` and `stop` may be null; raising `stop` ends the render early with the picture
// so far. Throws Error.
SNELL_EXPORT RenderResult Render(const Scene& scene, const RenderOptions& options = {},
                                 Progress* progress = nullptr, const StopFlag* stop = nullptr);

}  // namespace snell
