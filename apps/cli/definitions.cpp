// SPDX-License-Identifier: Apache-2.0
#include "cli/definitions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "api/snell.h"

namespace snell::cli {

namespace {

// What CLI11 calls the group of its own options, such as --help.
constexpr const char* UnnamedGroup = "Options";

std::vector<std::string> SplitAt(const std::string& text, const std::string& separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end; (end = text.find(separator, begin)) != text.npos;) {
    parts.push_back(text.substr(begin, end - begin));
    begin = end + separator.size();
  }
  parts.push_back(text.substr(begin));
  return parts;
}

// Words that are meant literally have no capitals (values.h).
bool IsChoice(const std::string& value) {
  return !value.empty() &&
         std::none_of(value.begin(), value.end(), [](unsigned char c) { return std::isupper(c); });
}

Argument DescribeOption(const CLI::Option& option) {
  Argument argument;
  for (const std::string& name : option.get_snames()) argument.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) argument.names.push_back("--" + name);
  argument.text = option.get_description();
  argument.group = option.get_group();
  argument.required = option.get_required();
  if (option.get_expected_max() == 0) return argument;
  argument.value = option.get_type_name();
  argument.repeated = option.get_expected_max() > 1;
  if (IsChoice(argument.value)) argument.words = SplitAt(argument.value, "|");
  return argument;
}

}  // namespace

std::vector<Argument> Command::Positionals() const {
  std::vector<Argument> positionals;
  for (const Argument& argument : arguments)
    if (!argument.IsOption()) positionals.push_back(argument);
  return positionals;
}

std::vector<std::string> Command::Groups() const {
  std::vector<std::string> groups;
  for (const Argument& argument : arguments) {
    const bool known = std::find(groups.begin(), groups.end(), argument.group) != groups.end();
    if (argument.IsOption() && argument.group != UnnamedGroup && !known)
      groups.push_back(argument.group);
  }
  groups.emplace_back(UnnamedGroup);
  return groups;
}

std::vector<Argument> Command::OptionsIn(const std::string& group) const {
  std::vector<Argument> options;
  for (const Argument& argument : arguments)
    if (argument.IsOption() && argument.group == group) options.push_back(argument);
  return options;
}

std::string Command::Synopsis() const {
  std::string synopsis = name;
  const bool onlyHelp = arguments.size() - Positionals().size() <= 1;
  if (!onlyHelp) synopsis += " [options]";
  for (const Argument& argument : Positionals()) {
    const std::string shown = argument.value + (argument.repeated ? " ..." : "");
    synopsis += argument.required ? " " + shown : " [" + shown + "]";
  }
  return synopsis;
}

Command Describe(const CLI::App& app, const std::string& name) {
  Command command;
  command.name = name;
  command.summary = app.get_description();
  const std::string footer = app.get_footer();
  if (!footer.empty()) command.details = SplitAt(footer, "\n\n");
  for (const CLI::Option* option : app.get_options())
    command.arguments.push_back(DescribeOption(*option));
  return command;
}

Definitions Describe(const CLI::App& program) {
  Definitions definitions;
  definitions.program = Describe(program, program.get_name());
  for (const CLI::App* command : program.get_subcommands(nullptr)) {
    definitions.commands.push_back(
        Describe(*command, program.get_name() + " " + command->get_name()));
  }

  // Arguments that stand for a command
  std::vector<std::string> names;
  for (const Command& command : definitions.commands) names.push_back(command.ShortName());
  for (Command& command : definitions.commands) {
    for (Argument& argument : command.arguments)
      if (argument.value == "COMMAND") argument.words = names;
  }
  return definitions;
}

std::string Heading(const Argument& argument) {
  std::string heading = fmt::format("{}", fmt::join(argument.names, ", "));
  if (!argument.value.empty()) heading += (heading.empty() ? "" : " ") + argument.value;
  return heading;
}

FileKind FileKindOf(const std::string& value) {
  if (value == "SCENE") return FileKind::Scene;
  if (value == "PICTURE" || value == "REFERENCE") return FileKind::Picture;
  if (value == "FILE" || value == "FILM") return FileKind::Any;
  return FileKind::None;
}

std::string FilePattern(FileKind kind) {
  const std::string list =
      kind == FileKind::Scene ? KnownSceneExtensions() : KnownPictureExtensions();
  return fmt::format("{}", fmt::join(SplitAt(list, ", "), "|"));
}

}  // namespace snell::cli
