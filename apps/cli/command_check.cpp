// SPDX-License-Identifier: Apache-2.0
//
// snell check: whether scenes can be read and make sense.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "api/snell.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/load_options.h"
#include "cli/values.h"
#include "util/text.h"

namespace snell::cli {

namespace {

constexpr const char* Details =
    "Reads each file and says \"ok\", or prints every error and warning with its place. Of a "
    "folder, every scene and mesh in it and below is read; then the errors go to standard error "
    "and a table of all files to standard output. The exit status is 1 if a file has errors.";

struct CheckArguments {
  std::vector<std::string> scenes;
  LoadArguments load;
};

// The files to read: those that are named, and all scenes within the folders that are, in order of their names.
std::vector<std::string> FilesOf(const std::vector<std::string>& names) {
  namespace fs = std::filesystem;
  std::vector<std::string> files;
  for (const std::string& name : names) {
    if (!fs::is_directory(name)) {
      files.push_back(name);
      continue;
    }
    std::vector<std::string> found;
    try {
      for (const fs::directory_entry& entry : fs::recursive_directory_iterator(name))
        if (HasSceneExtension(entry.path()) && entry.is_regular_file())
          found.push_back(entry.path().string());
    } catch (const fs::filesystem_error& error) {
      throw Error("the folder cannot be read: " + error.code().message(), {name});
    }
    if (found.empty())
      throw Error("the folder holds no scene", {name}, "scenes are " + KnownSceneExtensions());
    std::ranges::sort(found);
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

// Whether it can be read. A table has a line for what cannot, too.
bool CheckScene(const std::string& scene, const LoadArguments& arguments, bool table) {
  std::uint64_t warnings = 0;
  const auto warn = [&](const Diagnostic& warning) {
    ++warnings;
    PrintWarning(warning);
  };
  try {
    Load(scene, arguments, warn);
  } catch (const Error& error) {
    PrintError(error);
    if (table)
      PrintOut(Printable(scene) + ": " + Plural(error.diagnostics().size(), "error") + "\n");
    return false;
  }
  const std::string remark = warnings > 0 ? ", with " + Plural(warnings, "warning") : "";
  PrintOut(Printable(scene) + ": ok" + remark + "\n");
  return true;
}

int RunCheck(const CheckArguments& arguments) {
  const std::vector<std::string> files = FilesOf(arguments.scenes);
  const bool table = std::ranges::any_of(
      arguments.scenes, [](const auto& name) { return std::filesystem::is_directory(name); });
  std::size_t good = 0;
  for (const std::string& file : files) good += CheckScene(file, arguments.load, table);
  if (table)
    PrintOut(fmt::format("{} read: {} ok, {} with errors\n", Plural(files.size(), "file"), good,
                         files.size() - good));
  return good == files.size() ? Succeeded : Failed;
}

}  // namespace

void AddCheckCommand(Program& program) {
  const auto arguments = std::make_shared<CheckArguments>();
  CLI::App& command = AddCommand<CheckArguments>(program, "check", "Check whether scenes are right",
                                                 Details, arguments, RunCheck);
  AddArguments(command, "SCENE", arguments->scenes,
               "Scenes or meshes, or folders of them (" + KnownSceneExtensions() + ")");
  AddLoadOptions(command, arguments->load);
}

}  // namespace snell::cli
