// SPDX-License-Identifier: Apache-2.0
//
// The commands and options as plain records, read from the definitions of CLI11. All that describes the
// program to people and shells is made from these: help (help.h), man page (man_page.h) and completions
// (completion.h).
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace snell::cli {

// An option, flag or argument.
struct Argument {
  std::vector<std::string> names;  // "-o", "--output"; empty for arguments without a name
  std::string value;               // "FILE", "y|z"; "" for flags
  std::vector<std::string> words;  // what may be given: "y" and "z"; empty if it is not a choice
  std::string text;
  std::string group;  // the heading under which it stands
  bool required = false;
  bool repeated = false;

  bool IsFlag() const { return value.empty(); }
  bool IsOption() const { return !names.empty(); }
};

struct Command {
  std::string name;
  std::string summary;  // a phrase
  std::vector<std::string>
      details;  // paragraphs; those that begin with a space are shown as they are
  std::vector<Argument> arguments;

  // "render" of "snell render".
  std::string ShortName() const { return name.substr(name.find(' ') + 1); }
  // Arguments without a name, and then the options by heading, "Other options" last.
  std::vector<Argument> Positionals() const;
  std::vector<std::string> Groups() const;
  std::vector<Argument> OptionsIn(const std::string& group) const;
  // "snell render [options] SCENE"
  std::string Synopsis() const;
};

struct Definitions {
  Command program;  // its name is "snell"
  std::vector<Command> commands;
};

Definitions Describe(const CLI::App& program);
Command Describe(const CLI::App& command, const std::string& name);

// "-o, --output FILE"
std::string Heading(const Argument& argument);

// Which files a value stands for.
enum class FileKind { None, Any, Scene, Picture };
FileKind FileKindOf(const std::string& value);
// The extensions of scenes or pictures, "toml|nff|obj".
std::string FilePattern(FileKind kind);

}  // namespace snell::cli
