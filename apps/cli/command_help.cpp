// SPDX-License-Identifier: Apache-2.0
//
// snell help, and snell --version.
#include <fmt/format.h>

#include "api/snell.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/help.h"
#include "cli/usage.h"
#include "cli/values.h"

namespace snell::cli {

namespace {

struct HelpArguments {
  const CLI::App* program = nullptr;
  std::optional<std::string> command;
};

int RunHelp(const HelpArguments& arguments) {
  const Definitions definitions = Describe(*arguments.program);
  if (!arguments.command) {
    PrintOut(OverviewText(definitions));
    return Succeeded;
  }
  for (const Command& command : definitions.commands) {
    if (command.ShortName() != *arguments.command) continue;
    PrintOut(HelpText(command));
    return Succeeded;
  }
  throw UsageError(UnknownCommandText(*arguments.program, *arguments.command));
}

int PrintVersion() {
  PrintOut(fmt::format("snell {}\nbuild: {}\ninstruction sets: {} (used: {})\n", Version(),
                       BuildDescription(), fmt::join(InstructionSets(), ", "),
                       ActiveInstructionSet()));
  return Succeeded;
}

}  // namespace

void AddHelpCommand(Program& program) {
  const auto arguments = std::make_shared<HelpArguments>(HelpArguments{&program.app, {}});
  CLI::App& command =
      AddCommand<HelpArguments>(program, "help", "Explain a command", "", arguments, RunHelp);
  AddValue<std::string>(command, "COMMAND", "COMMAND", ReadText, arguments->command,
                        "The command; without it, an overview");
}

void AddVersionOption(Program& program) {
  program.app.add_flag_callback(
      "-V,--version", [&program] { program.run = PrintVersion; },
      "Print the version, the build and the instruction sets that this processor runs");
}

}  // namespace snell::cli
