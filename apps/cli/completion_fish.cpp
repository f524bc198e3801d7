// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/completion.h"

namespace snell::cli {

namespace {

std::string Quote(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "'";
}

// The line for an option or an argument, where `condition` holds.
std::string Line(const Argument& argument, const std::string& condition) {
  std::string line = "complete -c snell -n " + Quote(condition);
  for (const std::string& name : argument.names)
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  const bool takesFile = FileKindOf(argument.value) != FileKind::None;
  if (argument.IsOption() && !argument.IsFlag()) line += takesFile ? " -r -F" : " -x";
  if (!argument.IsOption() && takesFile) line += " -F";
  if (!argument.words.empty())
    line += fmt::format(" -a {}", Quote(fmt::format("{}", fmt::join(argument.words, " "))));
  if (argument.IsOption()) line += " -d " + Quote(argument.text);
  return line + "\n";
}

}  // namespace

std::string FishCompletion(const Definitions& definitions) {
  std::string script =
      "# Completion of snell for fish; made by \"snell completion fish\".\n\ncomplete -c snell "
      "-f\n";
  for (const Argument& argument : definitions.program.arguments)
    script += Line(argument, "__fish_use_subcommand");
  for (const Command& command : definitions.commands) {
    const std::string name = command.ShortName();
    script += fmt::format("\ncomplete -c snell -n __fish_use_subcommand -a {} -d {}\n", name,
                          Quote(command.summary));
    for (const Argument& argument : command.arguments)
      script += Line(argument, "__fish_seen_subcommand_from " + name);
  }
  return script;
}

}  // namespace snell::cli
