// SPDX-License-Identifier: Apache-2.0
//
// snell completion: scripts that let shells complete command lines of snell.
#include "cli/commands.h"
#include "cli/completion.h"
#include "cli/console.h"
#include "cli/values.h"

namespace snell::cli {

namespace {

constexpr const char* Details =
    "Installed with the program; to try it at once:\n\n"
    "  bash   source <(snell completion bash)\n"
    "  zsh    source <(snell completion zsh)\n"
    "  fish   snell completion fish | source";

struct CompletionArguments {
  const CLI::App* program = nullptr;
  std::optional<std::string> shell;
};

int RunCompletion(const CompletionArguments& arguments) {
  const Definitions definitions = Describe(*arguments.program);
  if (arguments.shell == "bash") PrintOut(BashCompletion(definitions));
  if (arguments.shell == "zsh") PrintOut(ZshCompletion(definitions));
  if (arguments.shell == "fish") PrintOut(FishCompletion(definitions));
  return Succeeded;
}

}  // namespace

void AddCompletionCommand(Program& program) {
  const auto arguments = std::make_shared<CompletionArguments>();
  arguments->program = &program.app;
  CLI::App& command = AddCommand<CompletionArguments>(program, "completion",
                                                      "Print a completion script for a shell",
                                                      Details, arguments, RunCompletion);
  AddChoice(command, "SHELL", "bash|zsh|fish", arguments->shell, "The shell")->required();
}

}  // namespace snell::cli
