// SPDX-License-Identifier: Apache-2.0
//
// The program "snell". What it can do is declared here, one command after the other; Run() takes the
// command line apart, carries the command out and turns whatever goes wrong into one line and a status.
#include "cli/commands.h"
#include "cli/program.h"

int main(int argc, char** argv) {
  using namespace snell::cli;
  Program program;

  // Pictures
  AddRenderCommand(program);   // a scene becomes pictures
  AddMergeCommand(program);    // parts that were rendered apart become one
  AddCompareCommand(program);  // how far two pictures are apart

  // Scenes
  AddInfoCommand(program);       // what is in one
  AddExplainCommand(program);    // how its pixels come about
  AddViewCommand(program);       // a window that shows one
  AddCheckCommand(program);      // whether files are right
  AddReferenceCommand(program);  // the language that they are written in

  // The program itself
  AddSelftestCommand(program);  // whether its light is right
  AddDevicesCommand(program);   // what it can render on
  AddHelpCommand(program);
  AddManualCommand(program);
  AddCompletionCommand(program);
  AddVersionOption(program);

  return Run(program, argc, argv);
}
