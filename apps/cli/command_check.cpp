// SPDX-License-Identifier: Apache-2.0
//
// snell check: whether scenes can be read and make sense.
#include <fmt/format.h>

#include "api/snell.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/load_options.h"
#include "cli/values.h"
#include "util/text.h"

namespace snell::cli {

namespace {

constexpr const char* Details =
    "Reads each file and says \"ok\", or prints every error and warning with its place. The "
    "exit status is 1 if a file has errors.";

struct CheckArguments {
  std::vector<std::string> scenes;
  LoadArguments load;
};

bool CheckScene(const std::string& scene, const LoadArguments& arguments) {
  std::uint64_t warnings = 0;
  const auto warn = [&](const Diagnostic& warning) {
    ++warnings;
    PrintWarning(warning);
  };
  try {
    Load(scene, arguments, warn);
  } catch (const Error& error) {
    PrintError(error);
    return false;
  }
  const std::string remark = warnings > 0 ? ", with " + Plural(warnings, "warning") : "";
  PrintOut(Printable(scene) + ": ok" + remark + "\n");
  return true;
}

int RunCheck(const CheckArguments& arguments) {
  bool allRight = true;
  for (const std::string& scene : arguments.scenes)
    allRight = CheckScene(scene, arguments.load) && allRight;
  return allRight ? Succeeded : Failed;
}

}  // namespace

void AddCheckCommand(Program& program) {
  const auto arguments = std::make_shared<CheckArguments>();
  CLI::App& command = AddCommand<CheckArguments>(program, "check", "Check whether scenes are right",
                                                 Details, arguments, RunCheck);
  AddArguments(command, "SCENE", arguments->scenes,
               "Scenes or meshes (" + KnownSceneExtensions() + ")");
  AddLoadOptions(command, arguments->load);
}

}  // namespace snell::cli
