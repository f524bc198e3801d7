// SPDX-License-Identifier: Apache-2.0
#include "cli/program.h"

#include <new>
#include <vector>

#include "cli/console.h"
#include "cli/help.h"
#include "cli/usage.h"
#include "cli/values.h"

namespace snell::cli {

namespace {

void PrintHelp(const CLI::App& program) {
  const std::vector<CLI::App*> chosen = program.get_subcommands();
  const Definitions definitions = Describe(program);
  for (const Command& command : definitions.commands) {
    if (!chosen.empty() && command.ShortName() == chosen.front()->get_name())
      return PrintOut(HelpText(command));
  }
  PrintOut(OverviewText(definitions));
}

// Set `program.run` from the command line. Throws UsageError.
void Parse(Program& program, const std::vector<std::string>& words) {
  try {
    program.app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::CallForHelp&) {
    program.run = [&program] { return PrintHelp(program.app), Succeeded; };
  } catch (const CLI::ParseError& error) {
    throw UsageError(ComplaintText(program.app, error, words));
  } catch (const UsageError& error) {
    throw UsageError(UnknownOptionText(program.app).value_or(error.what()));
  }
  if (!program.run) program.run = [&program] { return PrintHelp(program.app), Succeeded; };
}

}  // namespace

Program::Program()
    : app("a ray tracer that opens a scene or a mesh and returns a picture", "snell") {
  app.set_help_flag("-h,--help", "Print this help");
  app.require_subcommand(0, 1);
  app.footer(
      "Snell opens native scenes (.toml), glTF, pbrt and NFF files and bare meshes, and writes "
      "PNG, "
      "JPEG, HDR and "
      "EXR. The same scene with the same options gives the same picture, bit for bit, on any "
      "number of threads.\n\n"
      "  snell render bunny.ply\n"
      "      a mesh, framed and lit, becomes bunny.png\n"
      "  snell render scene.toml -o scene.png -o scene.exr --size 1920x1080 --spp 64\n"
      "      a scene becomes two pictures, to look at and to work on");
}

int Run(Program& program, int argc, const char* const* argv) {
  ReserveStandardStreams();
  try {
    Parse(program, std::vector<std::string>(argv + (argc > 0), argv + argc));
    return program.run();
  } catch (const UsageError& error) {
    PrintNote(error.what());
    return WrongUse;
  } catch (const Error& error) {
    PrintError(error);
  } catch (const std::bad_alloc&) {
    PrintError("there is not enough memory for this");
  } catch (const std::exception& error) {
    PrintError(error.what());
  }
  return Failed;
}

}  // namespace snell::cli
