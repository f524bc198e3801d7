// SPDX-License-Identifier: Apache-2.0
#include "viewer/explanation_tree.h"

#include <gtest/gtest.h>

#include "api/snell.h"

namespace snell::viewer {
namespace {

TEST(ExplanationTree, TakesBranchesForDepths) {
  const auto lines = LinesOfExplanation(
      "a pixel\n\n1. camera ray\n│    meets 'x'\n├ 2. refracted ray\n└ 3. reflected ray\n       1 "
      "term\n");
  ASSERT_EQ(lines.size(), 6u);
  EXPECT_EQ(lines[0].text, "a pixel");
  EXPECT_EQ(lines[1].text, "1. camera ray");
  EXPECT_TRUE(lines[1].isRay);
  EXPECT_EQ(lines[2].text, "meets 'x'");
  EXPECT_EQ(lines[2].depth, 5);
  EXPECT_FALSE(lines[2].isRay);
  EXPECT_EQ(lines[3].depth, 2);
  EXPECT_TRUE(lines[4].isRay);
  EXPECT_EQ(lines[5].depth, 7);
}

TEST(ExplanationTree, ReadsWhatIsExplained) {
  RenderOptions options;
  options.width = 64;
  const PixelExplainer explainer(LoadScene(SNELL_SOURCE_DIR "/scenes/gallery/refraction.toml"),
                                 options);
  int rays = 0, deepest = 0;
  for (const ExplanationLine& line : LinesOfExplanation(explainer.Explain(30, 25, 0).text)) {
    if (line.isRay) ++rays, deepest = std::max(deepest, line.depth);
    EXPECT_EQ(line.text.find("│"), std::string::npos) << line.text;
  }
  EXPECT_GT(rays, 3);
  EXPECT_GT(deepest, 2);
}

}  // namespace
}  // namespace snell::viewer
