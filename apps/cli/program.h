// SPDX-License-Identifier: Apache-2.0
//
// The program as a set of commands: what a command is declared with, how the command line is carried out,
// and the exit statuses. The definitions of CLI11 are the only description of commands and options; help,
// man page and completions are made from them (definitions.h).
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>

namespace snell::cli {

enum ExitStatus {
  Succeeded = 0,
  Failed = 1,      // the world's fault: a file, a device, memory
  WrongUse = 2,    // of the command line
  Signalled = 128  // plus the signal's number
};

struct Program {
  Program();

  CLI::App app;
  std::function<int()> run;  // the command that was given; returns the exit status
};

// Declare a command. `run` gets the options as they were given.
//
// Texts follow one style: the summary is a phrase without a full stop; `details` are whole sentences in
// paragraphs parted by empty lines, and a paragraph that begins with "  " is shown as it is.
template <class Options>
CLI::App& AddCommand(Program& program, const std::string& name, const std::string& summary,
                     const std::string& details, const std::shared_ptr<Options>& options,
                     int (*run)(const Options&)) {
  CLI::App* command = program.app.add_subcommand(name, summary);
  command->footer(details);
  command->callback(
      [&program, options, run] { program.run = [options, run] { return run(*options); }; });
  return *command;
}

// Carry out a command line. Prints every error; returns the exit status.
int Run(Program& program, int argc, const char* const* argv);

}  // namespace snell::cli
