// SPDX-License-Identifier: Apache-2.0
//
// Arrows between the rooms point down: every #include of the product is read and compared with the table.
// Unit tests beside the code keep to their room's row too; besides, they may use tests/support.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "structure/tree.h"

namespace snell::structure {

namespace {

// Who may include whom; every room may include itself.
const std::map<std::string, std::set<std::string>> MayInclude = {
    {"kernel", {}},
    {"util", {}},
    {"image", {"util", "kernel"}},
    {"bvh", {"util", "kernel"}},
    {"scene", {"util", "kernel", "image"}},
    {"tessellate", {"scene", "image", "kernel", "util"}},
    {"render", {"scene", "image", "kernel", "util"}},
    {"io", {"scene", "image", "util"}},
    {"cpu", {"render", "tessellate", "scene", "bvh", "image", "kernel", "util"}},
    {"gpu", {"cpu", "render", "scene", "bvh", "image", "kernel", "util"}},
    {"selftest", {"cpu", "render", "scene", "bvh", "image", "kernel", "util"}},
    {"explain", {"cpu", "render", "scene", "bvh", "image", "kernel", "util"}},
    {"api",
     {"explain", "selftest", "io", "cpu", "gpu", "render", "tessellate", "scene", "image", "bvh",
      "kernel", "util"}},
    {"apps", {"api", "util"}},
    {"python", {"api", "util"}},
};

// What rooms at the bottom may include of other libraries, besides the standard library, by how the name
// begins; others may include what CMake links to them.
const std::map<std::string, std::vector<std::string>> Libraries = {
    {"kernel", {"glm/"}},
    {"util", {"fmt/", "tbb/", "sys/", "fcntl.h", "unistd.h"}},
};

// "kernel" for "src/kernel/math.h", "apps" for "apps/cli/main.cpp".
std::string RoomOf(const std::string& path) {
  const std::size_t first = path.starts_with("src/") ? 4 : 0;
  return path.substr(first, path.find('/', first) - first);
}

bool IsTest(const std::string& path) { return path.ends_with("_test.cpp"); }

// The file that an #include "name" means: beside the file that includes it, or below a root. Configured
// headers count if their template exists; what the build makes ends in .inc and is its room's own.
std::optional<std::string> Resolve(const std::string& from, const std::string& name) {
  if (name.ends_with(".inc")) return from;
  for (const std::string& path :
       {Beside(from, name), "src/" + name, "apps/" + name, "tests/" + name}) {
    if (Exists(path) || Exists(path + ".in")) return path;
  }
  return std::nullopt;
}

// What is wrong with an #include "name", or "".
std::string FaultOf(const std::string& from, const std::string& name) {
  if (name.ends_with(".inc") && name.find('/') == std::string::npos)
    return "";  // the build makes it
  const std::optional<std::string> target = Resolve(from, name);
  if (!target) return "names no file of the repository";
  const std::string room = RoomOf(from);
  const std::string other = RoomOf(*target);
  if (other == "tests")
    return IsTest(from) && target->starts_with("tests/support/") ? "" : "leads into the tests";
  if (other == room || MayInclude.at(room).contains(other)) return "";
  return fmt::format("is an arrow from {} to {}, which the table does not have", room, other);
}

// What is wrong with an #include <name>, or "".
std::string FaultOfLibrary(const std::string& from, const std::string& name) {
  const auto allowed = Libraries.find(RoomOf(from));
  if (allowed == Libraries.end() || (IsTest(from) && name.starts_with("gtest/"))) return "";
  const bool standard = name.find_first_of("./") == std::string::npos;
  const auto begins = [&](const std::string& library) { return name.starts_with(library); };
  if (standard || std::ranges::any_of(allowed->second, begins)) return "";
  return fmt::format("is a library that {} may not use", RoomOf(from));
}

// The name in #include "name" or #include <name> with its opening mark: "\"name" or "<name"; "" for others.
std::string IncludedBy(std::string line) {
  std::erase(line, ' ');
  if (!line.starts_with("#include\"") && !line.starts_with("#include<")) return "";
  const std::string name = line.substr(8);
  return name.substr(0, name.find_first_of("\">", 1));
}

// All faults of a file, a line each.
std::string FaultsOf(const TextFile& file) {
  std::string faults;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    const std::string included = IncludedBy(file.lines[i]);
    if (included.empty()) continue;
    const std::string name = included.substr(1);
    const std::string fault =
        included[0] == '"' ? FaultOf(file.path, name) : FaultOfLibrary(file.path, name);
    if (!fault.empty()) faults += fmt::format("{}:{}: {} {}\n", file.path, i + 1, name, fault);
  }
  return faults;
}

class Includes : public testing::TestWithParam<std::string> {};

TEST_P(Includes, FollowTheArrows) {
  const std::string folder = GetParam();
  for (const TextFile& file : CodeBelow(folder)) {
    ASSERT_TRUE(MayInclude.contains(RoomOf(file.path)))
        << file.path << " is in a room without a row";
    EXPECT_EQ(FaultsOf(file), "");
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Includes, testing::Values("src", "apps", "python"),
                         [](const auto& folder) { return folder.param; });

TEST(IncludeRule, ForbidsWhatItShould) {
  EXPECT_NE(FaultOf("src/kernel/math.h", "util/check.h"), "");
  EXPECT_NE(FaultOf("src/util/file.h", "kernel/math.h"), "");
  EXPECT_NE(FaultOf("src/cpu/flatten.h", "io/format.h"), "");
  EXPECT_NE(FaultOf("src/scene/scene.h", "../cpu/flatten.h"), "");
  EXPECT_NE(FaultOf("apps/cli/main.cpp", "scene/scene.h"), "");
  EXPECT_NE(FaultOf("src/scene/scene.h", "structure/tree.h"), "");
  EXPECT_NE(FaultOf("src/scene/scene.h", "scene/no_such_file.h"), "");
  EXPECT_NE(FaultOfLibrary("src/kernel/math.h", "fmt/format.h"), "");
  EXPECT_NE(FaultOfLibrary("src/util/text.h", "glm/vec3.hpp"), "");
}

TEST(IncludeRule, AllowsWhatItShould) {
  EXPECT_EQ(FaultOf("src/kernel/math.h", "kernel/dialect.h"), "");
  EXPECT_EQ(FaultOf("src/cpu/flatten.h", "kernel/math.h"), "");
  EXPECT_EQ(FaultOf("src/scene/scene.h", "../util/error.h"), "");
  EXPECT_EQ(FaultOf("apps/cli/main.cpp", "util/error.h"), "");
  EXPECT_EQ(FaultOfLibrary("src/kernel/dialect.h", "cmath"), "");
  EXPECT_EQ(FaultOfLibrary("src/kernel/dialect.h", "glm/vec3.hpp"), "");
  EXPECT_EQ(FaultOfLibrary("src/kernel/math_test.cpp", "gtest/gtest.h"), "");
}

}  // namespace

}  // namespace snell::structure
