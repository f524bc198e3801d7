// SPDX-License-Identifier: Apache-2.0
#include "cli/usage.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/definitions.h"
#include "util/file.h"
#include "util/text.h"

namespace snell::cli {

namespace {

bool LooksLikeOption(const std::string& word) { return word.size() > 1 && word[0] == '-'; }

bool HasExtension(const std::string& name, FileKind kind) {
  const std::string extension = LowerExtension(name);
  return !extension.empty() &&
         ("|" + FilePattern(kind) + "|").find("|" + extension + "|") != std::string::npos;
}

// The command that the words chose; null if none.
const CLI::App* ChosenCommand(const CLI::App& program) {
  const std::vector<CLI::App*> chosen = program.get_subcommands();
  return chosen.empty() ? nullptr : chosen.front();
}

Command DescribeChosen(const CLI::App& program) {
  const CLI::App* command = ChosenCommand(program);
  if (!command) return Describe(program, program.get_name());
  return Describe(*command, program.get_name() + " " + command->get_name());
}

const Argument* Find(const Command& command, const std::string& option) {
  for (const Argument& argument : command.arguments)
    if (std::count(argument.names.begin(), argument.names.end(), option) > 0) return &argument;
  return nullptr;
}

std::vector<std::string> OptionNames(const Command& command) {
  std::vector<std::string> names;
  for (const Argument& argument : command.arguments)
    names.insert(names.end(), argument.names.begin(), argument.names.end());
  return names;
}

// `word` stands after the command `chosen`, or before any if that is null.
std::string UnknownOption(const CLI::App& program, const CLI::App* chosen,
                          const std::string& word) {
  const std::string option = word.substr(0, word.find('='));
  if (!chosen) {
    for (const Command& other : Describe(program).commands) {
      const bool meant = !ChosenCommand(program) || other.name == DescribeChosen(program).name;
      if (meant && Find(other, option))
        return fmt::format("the option '{}' comes after its command: {} {}", option, other.name,
                           option);
    }
  }
  const Command whole = Describe(program, program.get_name());
  if (chosen && Find(whole, option))
    return fmt::format("the option '{}' comes without a command: {} {}", option, whole.name,
                       option);
  const Command command = chosen ? DescribeChosen(program) : whole;
  std::string hint;
  if (option == "--time") hint = "--at names the moment of an animation";
  if (hint.empty() && option.size() > 2) hint = DidYouMean(option, OptionNames(command));
  if (hint.empty()) hint = fmt::format("'{} --help' lists the options", command.name);
  return fmt::format("unknown option '{}'; {}", option, hint);
}

std::string UnexpectedArgument(const Command& command, const std::string& word) {
  const bool isPicture = Find(command, "--output") && HasExtension(word, FileKind::Picture);
  const std::string hint = isPicture
                               ? fmt::format("name each picture by an -o of its own: -o {}", word)
                               : "usage: " + command.Synopsis();
  return fmt::format("unexpected argument '{}'; {}", word, hint);
}

// The first argument that must be given and was not.
std::string MissingArgument(const CLI::App& program, const Command& command) {
  const CLI::App* chosen = ChosenCommand(program);
  for (const CLI::Option* option : chosen->get_options()) {
    if (option->get_required() && option->count() == 0)
      return fmt::format("{} is missing; usage: {}", option->get_name(true), command.Synopsis());
  }
  return "usage: " + command.Synopsis();
}

// An option without its value, or a flag with one.
std::string MisusedOption(const Command& command, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    const std::string option = word.substr(0, word.find('='));
    const Argument* argument = Find(command, option);
    if (!argument) continue;
    if (argument->IsFlag() && option != word) return fmt::format("{} takes no value", option);
    const bool cutShort = &word == &words.back() || word == option + "=";
    if (!argument->IsFlag() && cutShort)
      return fmt::format("{} needs a value: {} {}", option, option, argument->value);
  }
  return "usage: " + command.Synopsis();
}

}  // namespace

std::optional<std::string> UnknownOptionText(const CLI::App& program) {
  const auto unknownAmong = [&](const CLI::App& app) -> std::optional<std::string> {
    for (const std::string& word : app.remaining(false))
      if (LooksLikeOption(word))
        return UnknownOption(program, &app == &program ? nullptr : &app, word);
    return {};
  };
  const CLI::App* chosen = ChosenCommand(program);
  std::optional<std::string> text = unknownAmong(program);
  if (!text && chosen) text = unknownAmong(*chosen);
  return text;
}

std::string UnknownCommandText(const CLI::App& program, const std::string& word) {
  std::error_code ignored;
  if (HasExtension(word, FileKind::Scene) || std::filesystem::is_regular_file(word, ignored))
    return fmt::format("'{}' is not a command; to render it: snell render {}", word, word);
  std::vector<std::string> names;
  for (const Command& command : Describe(program).commands) names.push_back(command.ShortName());
  std::vector<std::string> candidates = OptionNames(Describe(program, program.get_name()));
  candidates.insert(candidates.begin(), names.begin(), names.end());
  std::string hint = DidYouMean(word, candidates);
  if (hint.empty()) hint = fmt::format("the commands are: {}", fmt::join(names, ", "));
  return fmt::format("unknown command '{}'; {}", word, hint);
}

std::string ComplaintText(const CLI::App& program, const CLI::ParseError& error,
                          const std::vector<std::string>& words) {
  if (const std::optional<std::string> unknown = UnknownOptionText(program)) return *unknown;
  const Command command = DescribeChosen(program);
  const std::vector<std::string> remaining = program.remaining(true);
  if (!remaining.empty()) {
    return ChosenCommand(program) ? UnexpectedArgument(command, remaining.front())
                                  : UnknownCommandText(program, remaining.front());
  }
  if (dynamic_cast<const CLI::RequiredError*>(&error)) return MissingArgument(program, command);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error)) return MisusedOption(command, words);
  return error.what();
}

}  // namespace snell::cli
