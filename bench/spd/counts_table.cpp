// SPDX-License-Identifier: Apache-2.0
//
// snell-spd-counts: prints how many rays Snell follows in the Standard Procedural Databases beside the
// published numbers, as a table in Markdown. Exit codes: 0; 1 if a database cannot be rendered; 2 for wrong
// use.
#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <string_view>

#include "spd/counts.h"
#include "util/error.h"
#include "util/text.h"

using namespace snell;

static constexpr std::string_view Usage =
    "usage: snell-spd-counts\n\n"
    "Prints how many rays Snell follows in the Standard Procedural Databases, beside\n"
    "the published numbers, as a table in Markdown.\n";

static void PrintRow(std::string_view database, std::string_view kind, std::int64_t ours,
                     std::int64_t published) {
  const std::string difference =
      published > 0 ? fmt::format("{:+.2f} %", 100.0 * double(ours - published) / double(published))
                    : "";
  fmt::print("| {} | {} | {} | {} | {} |\n", database, kind, WithCommas(std::uint64_t(ours)),
             WithCommas(std::uint64_t(published)), difference);
  std::fflush(stdout);
}

int main(int argc, char** argv) {
  const std::string_view first = argc > 1 ? argv[1] : "";
  if (first == "--help" || first == "-h") {
    fmt::print("{}", Usage);
    return 0;
  }
  if (argc > 1) {
    fmt::print(stderr, "{}", Usage);
    return 2;
  }

  try {
    fmt::print("| database | rays | Snell | published | difference |\n|---|---|--:|--:|--:|\n");
    for (const spd::Database& database : spd::Databases()) {
      const spd::RayCounts counts = spd::CountRays(database);
      PrintRow(database.name, "reflected", counts.reflected, database.published.reflectedRays);
      PrintRow(database.name, "refracted", counts.refracted, database.published.refractedRays);
      PrintRow(database.name, "shadow", counts.shadow, database.published.shadowRays);
    }
  } catch (const Error& error) {
    fmt::print(stderr, "snell-spd-counts: {}\n", error.what());
    return 1;
  }
  return 0;
}
