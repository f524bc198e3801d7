// SPDX-License-Identifier: Apache-2.0
//
// Options with values: how they are declared and how their values are read and checked. A value that makes
// no sense is reported as "--spp must be at least 1, not '0'".
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace snell::cli {

// The command line was used wrongly. `what()` is one line for whoever typed it.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Thrown by readers; what the value must be: "must be at least 1".
class BadValue : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

template <class T>
using ValueReader = std::function<T(const std::string&)>;

// A whole number or a number from `lower` to `upper`.
ValueReader<int> WholeNumber(int lower, int upper);
ValueReader<float> Number(float lower, float upper);

// A width, a height or both, in pixels; 0 stands for what is missing: "800", "800x600", "x600".
std::pair<int, int> ReadSize(const std::string& text);
// "x0,y0,x1,y1" in pixels; x0 < x1 and y0 < y1.
std::array<int, 4> ReadCrop(const std::string& text);
// "A:B", sample numbers; A < B.
std::pair<std::uint32_t, std::uint32_t> ReadSampleRange(const std::string& text);
// Seconds of a duration: "90", "1.5s", "2m", "1h"; above 0.
double ReadDuration(const std::string& text);
// Any text. (Empty ones reach no reader.)
std::string ReadText(const std::string& text);
// The name of a picture to write, with one of the known extensions.
std::string ReadPictureName(const std::string& text);

// Declare an option with one value, shown as `value` in help: capitals stand for something ("N", "FILE"),
// small words between bars are meant literally ("y|z"). Given twice, the last one counts.
template <class T>
CLI::Option* AddValue(CLI::App& command, const std::string& names, const std::string& value,
                      ValueReader<T> read, std::optional<T>& target, const std::string& text);

// The same for a choice between the words of `value`: "y|z".
CLI::Option* AddChoice(CLI::App& command, const std::string& names, const std::string& value,
                       std::optional<std::string>& target, const std::string& text);

// An option that may be given several times, with one value each.
CLI::Option* AddValues(CLI::App& command, const std::string& names, const std::string& value,
                       ValueReader<std::string> read, std::vector<std::string>& target,
                       const std::string& text);

// Arguments without a name. All of them are required.
CLI::Option* AddArgument(CLI::App& command, const std::string& name, std::string& target,
                         const std::string& text);
CLI::Option* AddArguments(CLI::App& command, const std::string& name,
                          std::vector<std::string>& target, const std::string& text);

CLI::Option* AddFlag(CLI::App& command, const std::string& names, bool& target,
                     const std::string& text);

// Read the text that was given for the option `name`, shown as `value`, and say what is wrong with it.
template <class T>
T ReadFor(const std::string& name, const std::string& value, const ValueReader<T>& read,
          const std::string& text) {
  if (text.empty()) throw UsageError(name + " needs a value: " + name + " " + value);
  try {
    return read(text);
  } catch (const BadValue& bad) {
    throw UsageError(name + " " + bad.what() + ", not '" + text + "'");
  }
}

// The name by which messages speak of an option: the last one, which is the long one.
std::string SpokenName(const std::string& names);

template <class T>
CLI::Option* AddValue(CLI::App& command, const std::string& names, const std::string& value,
                      ValueReader<T> read, std::optional<T>& target, const std::string& text) {
  const auto take = [read = std::move(read), name = SpokenName(names), value,
                     &target](const CLI::results_t& results) {
    target = ReadFor(name, value, read, results.back());
    return true;
  };
  return command.add_option(names, take, text)
      ->type_name(value)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

}  // namespace snell::cli
