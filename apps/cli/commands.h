// SPDX-License-Identifier: Apache-2.0
//
// The commands of the program; each is declared and carried out in a file of its own, command_NAME.cpp.
#pragma once

#include "cli/program.h"

namespace snell::cli {

void AddRenderCommand(Program& program);
void AddMergeCommand(Program& program);
void AddInfoCommand(Program& program);
void AddCheckCommand(Program& program);
void AddCompareCommand(Program& program);
void AddExplainCommand(Program& program);
void AddViewCommand(Program& program);
void AddReferenceCommand(Program& program);
void AddSelftestCommand(Program& program);
void AddDevicesCommand(Program& program);
void AddCompletionCommand(Program& program);
void AddManualCommand(Program& program);
void AddHelpCommand(Program& program);
void AddVersionOption(Program& program);

}  // namespace snell::cli
