// SPDX-License-Identifier: Apache-2.0
//
// snell reference: the language of native scenes, from the table that their reader uses.
#include "api/snell.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/values.h"

namespace snell::cli {

namespace {

constexpr const char* Details =
    "Every key of a native scene file (.toml) with its meaning, unit and default. Editors "
    "that know JSON Schema complete and check scene files by what --schema prints.";

struct ReferenceArguments {
  bool markdown = false;
  bool schema = false;
};

int RunReference(const ReferenceArguments& arguments) {
  if (arguments.markdown && arguments.schema)
    throw UsageError("--markdown and --schema cannot be printed at once; choose one");
  PrintOut(arguments.schema ? SceneSchema() : SceneReference());
  return Succeeded;
}

}  // namespace

void AddReferenceCommand(Program& program) {
  const auto arguments = std::make_shared<ReferenceArguments>();
  CLI::App& command = AddCommand<ReferenceArguments>(program, "reference",
                                                     "Print the reference of the scene language",
                                                     Details, arguments, RunReference);
  command.option_defaults()->group("Form");
  AddFlag(command, "--markdown", arguments->markdown,
          "As a page in Markdown, which is the default");
  AddFlag(command, "--schema", arguments->schema, "As JSON Schema");
}

}  // namespace snell::cli
