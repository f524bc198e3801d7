// SPDX-License-Identifier: Apache-2.0
//
// snell view: starts the viewer, a program of its own that lies beside this one. So all other commands work where there
// are no windows.
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "api/snell.h"
#include "cli/commands.h"
#include "cli/render_options.h"
#include "cli/values.h"
#include "util/error.h"

namespace snell::cli {

namespace fs = std::filesystem;

namespace {

constexpr const char* Details =
    "Opens a window that shows the scene at once, and sharper the longer one looks. The mouse "
    "moves "
    "the camera; a click on a pixel explains it; R renders with the final settings. The scene is "
    "read again whenever its file changes. F1 shows all keys.";

// The viewer lies beside this program.
fs::path ViewerPath() {
  std::error_code fault;
  const fs::path self = fs::read_symlink("/proc/self/exe", fault);
  return fault ? fs::path() : self.parent_path() / "snell-viewer";
}

std::vector<std::string> WordsOf(const RenderArguments& render) {
  std::vector<std::string> words = {"snell-viewer"};
  const auto add = [&](const std::string& name, const std::string& value) {
    words.push_back(name + "=" + value);
  };
  if (render.size && render.size->first > 0) add("--width", std::to_string(render.size->first));
  if (render.size && render.size->second > 0) add("--height", std::to_string(render.size->second));
  if (render.camera) add("--camera", *render.camera);
  if (render.spp) add("--spp", std::to_string(*render.spp));
  if (render.integrator) add("--integrator", *render.integrator);
  words.push_back("--");
  words.push_back(render.scene);
  return words;
}

int RunView(const RenderArguments& arguments) {
  const fs::path viewer = ViewerPath();
  if (viewer.empty() || ::access(viewer.c_str(), X_OK) != 0)
    throw Error("the viewer is not there: Snell was built without it", {viewer.string()},
                "it is built where GLFW and Dear ImGui are installed (libglfw3-dev, libimgui-dev)");
  std::vector<std::string> words = WordsOf(arguments);
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::execv(viewer.c_str(), pointers.data());
  throw Error("cannot be started: " + std::generic_category().message(errno), {viewer.string()});
}

}  // namespace

void AddViewCommand(Program& program) {
  const auto arguments = std::make_shared<RenderArguments>();
  CLI::App& command = AddCommand<RenderArguments>(program, "view", "Show a scene in a window",
                                                  Details, arguments, RunView);
  AddArgument(command, "SCENE", arguments->scene,
              "A scene or a mesh (" + KnownSceneExtensions() + ")");
  command.option_defaults()->group("View");
  AddViewOptions(command, *arguments);
  command.option_defaults()->group("Quality");
  AddSamplesPerPixelOption(command, *arguments);
  AddChoice(command, "--integrator", "whitted|path", arguments->integrator,
            "How light is followed (the scene's, or path where a material is physical)");
}

}  // namespace snell::cli
