// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/completion.h"

namespace snell::cli {

namespace {

constexpr const char* Head =
    R"(# Completion of snell for bash 4 and newer; made by "snell completion bash".

# Files with one of the extensions $1 ("png|jpg"; all files if it is empty), and folders.
_snell_files() {
  local file plain=${cur//\\/}
  plain=${plain#[\"\']}
  compopt -o filenames 2>/dev/null
  while IFS= read -r file; do
    if [[ -z $1 || -d ${file/#\~/$HOME} || ${file,,} =~ \.($1)$ ]]; then COMPREPLY+=("$file"); fi
  done < <(compgen -f -- "$plain")
}

_snell_words() {
  local word
  while IFS= read -r word; do COMPREPLY+=("$word"); done < <(compgen -W "$1" -- "$cur")
}

_snell() {
  local cur=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
  COMPREPLY=()

  # "--option=value" comes as three words
  if [[ $cur == '=' ]]; then
    cur=''
  elif [[ $previous == '=' ]]; then
    previous=${COMP_WORDS[COMP_CWORD - 2]}
  fi

)";

// The call that completes a value; nothing for values that cannot be guessed.
std::string CallFor(const Argument& argument) {
  if (!argument.words.empty())
    return fmt::format("_snell_words '{}'", fmt::join(argument.words, " "));
  switch (FileKindOf(argument.value)) {
    case FileKind::Any: return "_snell_files ''";
    case FileKind::Scene: return fmt::format("_snell_files '{}'", FilePattern(FileKind::Scene));
    case FileKind::Picture: return fmt::format("_snell_files '{}'", FilePattern(FileKind::Picture));
    case FileKind::None: return ":";
  }
  return ":";
}

// The branch of one command: values of its options, its options, its arguments.
std::string Branch(const Command& command) {
  std::string names, values;
  for (const Argument& argument : command.arguments) {
    if (!argument.IsOption()) continue;
    names += fmt::format("{}{}", names.empty() ? "" : " ", fmt::join(argument.names, " "));
    if (!argument.IsFlag())
      values += fmt::format("        {}) {}; return ;;\n", fmt::join(argument.names, " | "),
                            CallFor(argument));
  }
  std::string branch = fmt::format("    {})\n", command.ShortName());
  if (!values.empty()) branch += "      case $previous in\n" + values + "      esac\n";
  branch += fmt::format("      if [[ $cur == -* ]]; then _snell_words '{}'", names);
  for (const Argument& argument : command.Positionals()) {
    branch += "; else " + CallFor(argument);
    break;
  }
  return branch + "; fi\n      ;;\n";
}

}  // namespace

std::string BashCompletion(const Definitions& definitions) {
  std::string commands;
  for (const Command& command : definitions.commands) commands += command.ShortName() + " ";
  for (const Argument& argument : definitions.program.arguments)
    commands += fmt::format("{} ", fmt::join(argument.names, " "));
  commands.pop_back();

  std::string script = Head;
  script += fmt::format(
      "  if ((COMP_CWORD == 1)); then\n    _snell_words '{}'\n    return\n  fi\n"
      "  case ${{COMP_WORDS[1]}} in\n",
      commands);
  for (const Command& command : definitions.commands) script += Branch(command);
  return script + "  esac\n}\n\ncomplete -F _snell snell\n";
}

}  // namespace snell::cli
