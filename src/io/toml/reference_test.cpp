// SPDX-License-Identifier: Apache-2.0
//
// The reference page and the schema that are checked in are the ones that the code makes.
#include <gtest/gtest.h>

#include "io/toml/scene.h"
#include "util/file.h"

namespace snell::io {
namespace {

const std::filesystem::path Docs = std::filesystem::path(SNELL_SOURCE_DIR) / "docs";

TEST(TomlReference, PageIsUpToDate) {
  EXPECT_TRUE(ReadFile(Docs / "scene-reference.md") == SceneReferenceMarkdown())
      << "run: ./snell reference --markdown > docs/scene-reference.md";
}

TEST(TomlReference, SchemaIsUpToDate) {
  EXPECT_TRUE(ReadFile(Docs / "snell-scene.schema.json") == SceneJsonSchema())
      << "run: ./snell reference --schema > docs/snell-scene.schema.json";
}

TEST(TomlReference, PageStartsWithASceneThatCanBeRead) {
  const std::string page = SceneReferenceMarkdown();
  const std::string fence = "```toml\n";
  const std::size_t begin = page.find(fence) + fence.size();
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / "snell-reference-test.toml";
  WriteFile(file, page.substr(begin, page.find("```\n", begin) - begin));
  const scene::Scene scene = ReadToml(file, {}, {}).scene;
  std::filesystem::remove(file);
  EXPECT_EQ(scene.objects.size(), 2u);
  EXPECT_EQ(scene.lights.size(), 1u);
}

TEST(TomlReference, SchemaHasItsBracesInPairs) {
  int depth = 0;
  bool inString = false;
  const std::string schema = SceneJsonSchema();
  for (std::size_t i = 0; i < schema.size(); ++i) {
    if (inString && schema[i] == '\\')
      ++i;
    else if (schema[i] == '"')
      inString = !inString;
    else if (!inString && (schema[i] == '{' || schema[i] == '['))
      ++depth;
    else if (!inString && (schema[i] == '}' || schema[i] == ']'))
      --depth;
    ASSERT_GE(depth, 0) << i;
  }
  EXPECT_EQ(depth, 0);
  EXPECT_FALSE(inString);
}

}  // namespace
}  // namespace snell::io
