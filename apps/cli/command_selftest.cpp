// SPDX-License-Identifier: Apache-2.0
//
// snell selftest: whether light behaves as physics says, as a table.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "api/snell.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/values.h"
#include "util/json.h"
#include "util/text.h"
#include "util/timer.h"

namespace snell::cli {

namespace {

constexpr const char* Details =
    "Renders scenes whose pictures are known, and tests samples against their densities. Each "
    "line of the table has what is expected, what was measured, how far apart they may be, and "
    "\"ok\" or \"FAILED\". The numbers are the same in every run. Of a statistical test the "
    "p-value is measured, of which all but the least are right. Without a GROUP all run.\n\n"
    "The exit status is 1 if a check fails.";

struct SelftestArguments {
  std::vector<std::string> groups;
  bool list = false;
  bool json = false;
  std::optional<float> tolerance;
};

// The groups to run, in the order of the list.
std::vector<SelftestGroup> GroupsOf(const SelftestArguments& arguments) {
  std::vector<SelftestGroup> all = SelftestGroups();
  for (const std::string& name : arguments.groups) {
    if (std::ranges::count(all, name, &SelftestGroup::name) > 0) continue;
    std::vector<std::string> names;
    for (const SelftestGroup& group : all) names.push_back(group.name);
    throw UsageError(
        fmt::format("unknown group '{}'; the groups are: {}", name, fmt::join(names, ", ")));
  }
  if (!arguments.groups.empty())
    std::erase_if(all, [&](const SelftestGroup& group) {
      return std::ranges::count(arguments.groups, group.name) == 0;
    });
  return all;
}

constexpr const char* Row = "{:<12} {:<72} {:>11} {:>11} {:>10}  {}\n";

std::string RowOf(const SelftestCheck& check) {
  return fmt::format(Row, check.group, check.name, fmt::format("{:.6g}", check.expected),
                     fmt::format("{:.6g}", check.measured), fmt::format("{:.2g}", check.tolerance),
                     check.passed ? "ok" : "FAILED");
}

std::string JsonOf(const std::vector<SelftestCheck>& checks, std::uint64_t failed) {
  JsonWriter json;
  json.BeginArray("checks");
  for (const SelftestCheck& check : checks) {
    json.BeginObject("");
    json.Add("group", check.group);
    json.Add("name", check.name);
    json.Add("expected", check.expected);
    json.Add("measured", check.measured);
    json.Add("tolerance", check.tolerance);
    json.Add("passed", check.passed);
    json.End();
  }
  json.End();
  json.Add("failed", failed);
  return json.Finish();
}

int RunSelftestCommand(const SelftestArguments& arguments) {
  const std::vector<SelftestGroup> groups = GroupsOf(arguments);
  if (arguments.list) {
    for (const SelftestGroup& group : groups)
      PrintOut(fmt::format("{:<12} {}\n", group.name, group.meaning));
    return Succeeded;
  }
  const Timer timer;
  if (!arguments.json)
    PrintOut(fmt::format(Row, "group", "check", "expected", "measured", "tolerance", ""));
  std::vector<SelftestCheck> checks;
  for (const SelftestGroup& group : groups) {
    RunSelftest(group.name, [&](SelftestCheck check) {
      if (arguments.tolerance) {
        check.tolerance *= double(*arguments.tolerance);
        check.passed = std::abs(check.measured - check.expected) <= check.tolerance;
      }
      if (!arguments.json) PrintOut(RowOf(check));
      checks.push_back(check);
    });
  }
  const std::uint64_t failed =
      std::uint64_t(std::ranges::count(checks, false, &SelftestCheck::passed));
  PrintOut(arguments.json
               ? JsonOf(checks, failed)
               : fmt::format("{} in {:.1f} s: {} ok, {} failed\n", Plural(checks.size(), "check"),
                             timer.Seconds(), checks.size() - failed, failed));
  return failed == 0 ? Succeeded : Failed;
}

}  // namespace

void AddSelftestCommand(Program& program) {
  const auto arguments = std::make_shared<SelftestArguments>();
  CLI::App& command =
      AddCommand<SelftestArguments>(program, "selftest", "Check light against closed forms",
                                    Details, arguments, RunSelftestCommand);
  AddArguments(command, "GROUP", arguments->groups, "Groups of checks to run; --list names them")
      ->required(false);
  AddFlag(command, "--list", arguments->list, "Name the groups and run nothing");
  AddFlag(command, "--json", arguments->json, "As JSON, with all digits");
  AddValue<float>(command, "--tolerance", "FACTOR", Number(0, 1e6f), arguments->tolerance,
                  "Allow so many times each tolerance; below 1 is stricter");
}

}  // namespace snell::cli
