// SPDX-License-Identifier: Apache-2.0
#include "cli/help.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "api/snell.h"

namespace snell::cli {

namespace {

constexpr std::size_t LineWidth = 92;
constexpr std::size_t TextColumn = 26;  // where descriptions begin

// Characters, not bytes, of a UTF-8 text.
std::size_t Length(const std::string& text) {
  return std::size_t(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

// "  heading      text", the text on a line of its own if the heading is long.
std::string Entry(const std::string& heading, const std::string& text) {
  std::string entry = "  " + heading;
  const std::size_t end = Length(entry);
  if (end + 2 > TextColumn)
    entry += "\n" + std::string(TextColumn, ' ');
  else
    entry += std::string(TextColumn - end, ' ');
  return entry + Wrap(text, TextColumn, LineWidth - TextColumn) + "\n";
}

std::string DetailsText(const Command& command) {
  std::string text;
  for (const std::string& paragraph : command.details) {
    const bool asItIs = paragraph.starts_with(' ');
    text += "\n" + (asItIs ? paragraph : Wrap(paragraph, 0, LineWidth)) + "\n";
  }
  return text;
}

}  // namespace

std::string Wrap(const std::string& text, std::size_t indent, std::size_t width) {
  std::istringstream words(text);
  std::string wrapped;
  std::size_t column = 0;
  for (std::string word; words >> word;) {
    const std::size_t length = Length(word);
    if (column > 0 && column + 1 + length > width) {
      wrapped += "\n" + std::string(indent, ' ');
      column = 0;
    } else if (column > 0) {
      wrapped += ' ';
      ++column;
    }
    wrapped += word;
    column += length;
  }
  return wrapped;
}

std::string OverviewText(const Definitions& definitions) {
  std::string text = fmt::format("Snell {}: {}\n", Version(), definitions.program.summary);
  text += DetailsText(definitions.program);
  text += "\nCommands\n";
  for (const Command& command : definitions.commands)
    text += Entry(command.ShortName(), command.summary);
  text += "\nOptions\n";
  for (const Argument& argument : definitions.program.arguments)
    text += Entry(Heading(argument), argument.text);
  return text + "\n'snell help COMMAND' tells more about a command.\n";
}

std::string HelpText(const Command& command) {
  std::string text =
      fmt::format("{}: {}\n\n  {}\n", command.name, command.summary, command.Synopsis());
  text += DetailsText(command);

  if (!command.Positionals().empty()) text += "\nArguments\n";
  for (const Argument& argument : command.Positionals())
    text += Entry(argument.value, argument.text);
  for (const std::string& group : command.Groups()) {
    text += "\n" + group + "\n";
    for (const Argument& argument : command.OptionsIn(group))
      text += Entry(Heading(argument), argument.text);
  }
  return text;
}

}  // namespace snell::cli
