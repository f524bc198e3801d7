// SPDX-License-Identifier: Apache-2.0
//
// snell manual: the manual page.
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/man_page.h"

namespace snell::cli {

namespace {

struct ManualArguments {
  const CLI::App* program = nullptr;
};

int RunManual(const ManualArguments& arguments) {
  PrintOut(ManPage(Describe(*arguments.program)));
  return Succeeded;
}

}  // namespace

void AddManualCommand(Program& program) {
  const auto arguments = std::make_shared<ManualArguments>(ManualArguments{&program.app});
  AddCommand<ManualArguments>(program, "manual", "Print the manual page",
                              "In roff; to read it:\n\n  snell manual | man -l -", arguments,
                              RunManual);
}

}  // namespace snell::cli
