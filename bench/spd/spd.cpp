// SPDX-License-Identifier: Apache-2.0
//
// snell-spd NAME [SIZE]: prints a Standard Procedural Database as NFF. Exit codes: 0; 1 if the output
// cannot be written; 2 for wrong use.
#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <string>
#include <string_view>

#include "spd/generators.h"
#include "util/error.h"
#include "util/text.h"

using namespace snell;

static std::string Usage() {
  std::string text =
      "usage: snell-spd NAME [SIZE]\n\nPrints one of the Standard Procedural Databases:\n";
  for (const spd::Database& database : spd::Databases())
    text +=
        fmt::format("  {:<8}{} (usual size {}: {} primitives)\n", database.name, database.contents,
                    database.usualSize, WithCommas(std::uint64_t(database.published.primitives)));
  return text;
}

static int SizeFrom(std::string_view text) {
  int size = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), size);
  if (error != std::errc() || end != text.data() + text.size())
    throw Error(fmt::format("the size must be a whole number, not '{}'", text));
  return size;
}

int main(int argc, char** argv) {
  const std::string_view first = argc > 1 ? argv[1] : "";
  if (first == "--help" || first == "-h") {
    fmt::print("{}", Usage());
    return 0;
  }
  if (argc < 2 || argc > 3) {
    fmt::print(stderr, "{}", Usage());
    return 2;
  }

  std::string text;
  try {
    const spd::Database& database = spd::DatabaseNamed(first);
    text = database.generate(argc > 2 ? SizeFrom(argv[2]) : database.usualSize);
  } catch (const Error& error) {
    fmt::print(stderr, "snell-spd: {}\n", error.what());
    return 2;
  }
  const bool written =
      std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!written) fmt::print(stderr, "snell-spd: the output cannot be written\n");
  return written ? 0 : 1;
}
