// SPDX-License-Identifier: Apache-2.0
//
// The object files of the traversals define nothing but their tables: a function compiled out of line for
// AVX-512 under a name that other files share might be the copy that the linker keeps, and would stop older
// processors.
#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <sstream>
#include <string>

namespace snell::bvh {
namespace {

// The output of a shell command, or "" if it fails.
std::string OutputOf(const std::string& command) {
  std::FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) return "";
  std::string output;
  char buffer[4096];
  while (const std::size_t got = std::fread(buffer, 1, sizeof buffer, pipe))
    output.append(buffer, got);
  return pclose(pipe) == 0 ? output : "";
}

TEST(TraversalObjects, DefineNothingThatOthersShare) {
#ifdef SNELL_SANITIZED
  GTEST_SKIP() << "sanitizers add symbols of their own";
#endif
  if (OutputOf("nm --version 2>/dev/null").empty()) GTEST_SKIP() << "there is no nm";
  int traversals = 0;
  std::istringstream objects(SNELL_BVH_OBJECTS);
  for (std::string object; std::getline(objects, object, '|');) {
    if (object.find("traverse_") == std::string::npos) continue;
    ++traversals;
    std::istringstream symbols(OutputOf("nm -C -g --defined-only '" + object + "'"));
    int tables = 0;
    for (std::string line; std::getline(symbols, line);) {
      if (line.ends_with("::traversal")) {
        ++tables;
      } else {
        ADD_FAILURE() << object << " defines " << line;
      }
    }
    EXPECT_EQ(tables, 1) << object;
  }
  EXPECT_GE(traversals, 1);
}

}  // namespace
}  // namespace snell::bvh
