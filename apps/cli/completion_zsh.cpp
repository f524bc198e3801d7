// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/completion.h"

namespace snell::cli {

namespace {

// Text within single quotes and, for _arguments, within brackets or between colons.
std::string Escape(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\'')
      escaped += "'\\''";
    else if (c == '[' || c == ']' || c == ':' || c == '\\')
      escaped += std::string("\\") + c;
    else
      escaped += c;
  }
  return escaped;
}

// ":message:action" for a value.
std::string Action(const Argument& argument) {
  std::string action;
  const FileKind kind = FileKindOf(argument.value);
  if (!argument.words.empty())
    action = fmt::format("({})", fmt::join(argument.words, " "));
  else if (kind == FileKind::Any)
    action = "_files";
  else if (kind != FileKind::None)
    action = fmt::format("_files -g \"*.(#i)({})(-.)\"", FilePattern(kind));
  const std::string message = argument.words.empty() ? argument.value : "value";
  return fmt::format(":{}:{}", Escape(message), action);
}

// One argument of _arguments: "'(-q --quiet)'{-q,--quiet}'[text]'".
std::string Specification(const Argument& argument) {
  if (!argument.IsOption())
    return fmt::format("'{}{}'", argument.repeated ? "*" : "", Action(argument));
  std::string names = argument.names.front();
  if (argument.names.size() > 1) names = fmt::format("'{{{}}}'", fmt::join(argument.names, ","));
  const std::string before =
      argument.repeated ? "*" : fmt::format("({})", fmt::join(argument.names, " "));
  return fmt::format("'{}{}[{}]{}'", before, names, Escape(argument.text),
                     argument.IsFlag() ? "" : Action(argument));
}

std::string Specifications(const Command& command, const std::string& indent) {
  std::string list;
  for (const Argument& argument : command.arguments)
    list += " \\\n" + indent + Specification(argument);
  return list;
}

}  // namespace

std::string ZshCompletion(const Definitions& definitions) {
  std::string commands, branches;
  for (const Command& command : definitions.commands) {
    const std::string name = command.ShortName();
    commands += fmt::format("        '{}:{}'\n", name, Escape(command.summary));
    branches += fmt::format("        {}) _arguments -s{} ;;\n", name,
                            Specifications(command, "            "));
  }
  return fmt::format(R"(#compdef snell
# Completion of snell for zsh; made by "snell completion zsh".

_snell() {{
  local context state state_descr line
  typeset -A opt_args
  _arguments -C{} \
      '1:command:->command' '*::argument:->argument'
  case $state in
    command)
      local -a commands=(
{}      )
      _describe command commands
      ;;
    argument)
      case $line[1] in
{}      esac
      ;;
  esac
}}

# Work as a file of $fpath and when sourced.
if [[ $funcstack[1] == _snell ]]; then _snell "$@"; else compdef _snell snell; fi
)",
                     Specifications(definitions.program, "      "), commands, branches);
}

}  // namespace snell::cli
