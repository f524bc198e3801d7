// SPDX-License-Identifier: Apache-2.0
//
// The program "snell-viewer", which "snell view" starts: a window that shows a scene, sharper the longer one looks.
// docs/viewer.md
#include <fmt/format.h>
#include <imgui.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "api/snell.h"
#include "util/timer.h"
#include "viewer/input.h"
#include "viewer/panels.h"
#include "viewer/viewer.h"
#include "viewer/window.h"

namespace snell::viewer {

namespace {

constexpr double WhileBusy = 0.03;  // seconds between frames
constexpr double AtRest = 0.2;
constexpr int MostPixels = 16384;  // of a texture's side

struct Arguments {
  std::string scene;
  RenderOptions options;
};

// The picture as large as the free area allows.
Area FittedPicture(const Area& area, int width, int height) {
  const float scale = std::min(area.width / float(width), area.height / float(height));
  const float w = float(width) * scale, h = float(height) * scale;
  return {area.x + (area.width - w) / 2, area.y + (area.height - h) / 2, w, h};
}

// What the texture holds, so that it is made anew only if something of it changes.
struct Shown {
  const float* pixels = nullptr;
  int samples = -1;
  bool isResult = false;
  float exposure = 0;
  std::string view;

  bool operator==(const Shown&) const = default;
};

void UpdateTexture(Window& window, const Viewer& viewer, Shown& shown) {
  const Picture& picture = viewer.picture();
  if (picture.width == 0) return;
  const Shown now{picture.rgb.data(), viewer.samples(), viewer.showsResult(), viewer.exposure(),
                  viewer.displayView()};
  if (now == shown) return;
  shown = now;
  PictureOptions options;
  options.exposure = now.exposure;
  options.view = now.view;
  window.SetPicture(DisplayBytes(picture, options), picture.width, picture.height);
}

void DrawPicture(const Window& window, const Viewer& viewer, const Area& area) {
  if (viewer.picture().width == 0) return;
  ImGui::GetBackgroundDrawList()->AddImage(
      (ImTextureID)window.texture(),  // a pointer or a number, by ImGui's version
      ImVec2(area.x, area.y), ImVec2(area.x + area.width, area.y + area.height));
}

void Show(const Arguments& arguments, StateLog& log) {
  const std::filesystem::path preferencesFile = PreferencesFile();
  Interface interface;
  interface.preferences = ReadPreferences(preferencesFile);
  Window window(interface.preferences.width, interface.preferences.height, "Snell");
  Viewer viewer(arguments.options, log);
  if (!arguments.scene.empty()) viewer.Open(arguments.scene);

  Input input;
  Shown shown;
  Timer timer;
  double lastFrame = 0;
  std::filesystem::path titled;
  while (!window.ShouldClose()) {
    window.Wait(viewer.Busy() ? WhileBusy : AtRest);
    viewer.Update();
    if (viewer.path() != titled) {
      titled = viewer.path();
      window.SetTitle(titled.filename().string() + " - Snell");
    }
    window.BeginFrame();
    ApplyTheme(interface.preferences.dark);
    DrawPanels(viewer, interface, window.scale());
    if (viewer.isOpen()) {
      interface.picture = FittedPicture(interface.free, viewer.finalWidth(), viewer.finalHeight());
      const auto pixels = [&](float units) {
        return std::clamp(int(units * window.pixelsPerUnit() + 0.5f), 1, MostPixels);
      };
      viewer.SetSize(pixels(interface.picture.width), pixels(interface.picture.height));
    }
    const double now = timer.Seconds();
    input.Handle(window, viewer, interface, now - lastFrame);
    lastFrame = now;
    UpdateTexture(window, viewer, shown);
    DrawPicture(window, viewer, interface.picture);
    window.EndFrame(interface.preferences.dark);
  }
  interface.preferences.width = window.width();
  interface.preferences.height = window.height();
  WritePreferences(preferencesFile, interface.preferences);
  log.Say("closed");
}

int Run(int argc, char** argv) {
  CLI::App app("A window that shows a scene", "snell-viewer");
  Arguments arguments;
  RenderOptions& options = arguments.options;
  int width = 0, height = 0;
  app.add_option("SCENE", arguments.scene, "A scene or a mesh (" + KnownSceneExtensions() + ")");
  app.add_option("--width", width, "Of the final picture, pixels")->check(CLI::Range(1, 65536));
  app.add_option("--height", height, "Of the same")->check(CLI::Range(1, 65536));
  app.add_option("--camera", options.camera, "The scene's camera of this name");
  app.add_option("--spp", options.spp, "Samples per pixel")->check(CLI::PositiveNumber);
  app.add_option("--integrator", options.integrator, "How light is followed")
      ->check(CLI::IsMember({"whitted", "path"}));
  app.add_option("--threads", options.threads, "Processors to use")->check(CLI::PositiveNumber);
  app.add_option("--device", options.device, "What final pictures are rendered on");
  app.set_version_flag("-V,--version", Version());
  CLI11_PARSE(app, argc, argv);
  if (width > 0) options.width = width;
  if (height > 0) options.height = height;

  try {
    const char* logFile = std::getenv("SNELL_VIEWER_LOG");
    StateLog log(logFile ? logFile : "");
    Show(arguments, log);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "snell: error: {}\n", error.what());
    return 1;
  }
}

}  // namespace

}  // namespace snell::viewer

int main(int argc, char** argv) { return snell::viewer::Run(argc, argv); }
