// SPDX-License-Identifier: Apache-2.0
//
// The tree behind a pixel, by the program: on the screen, in files, and the mistakes that can be made.
#include "scratch.h"

namespace snell::test {
namespace {

class ExplainCommand : public InScratchFolder {
 protected:
  ExplainCommand() { Write("spheres.nff", SpheresScene()); }
};

TEST_F(ExplainCommand, PrintsTheTreeOfASample) {
  const Result result = Run({"explain", "spheres.nff", "24", "20", "--sample", "2"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_TRUE(result.out.starts_with("spheres.nff: pixel 24,20 of 48×32, sample 2, integrator "))
      << result.out;
  EXPECT_NE(result.out.find("\n1. camera ray from (2.1, 1.7, 1.3)"), std::string::npos)
      << result.out;
  EXPECT_NE(result.out.find("asks the light"), std::string::npos) << result.out;
}

TEST_F(ExplainCommand, WritesFilesAndAnswersWhy) {
  const Result files = Run({"explain", "spheres.nff", "24", "20", "--json", "a.json", "--svg",
                            "a.svg", "--gltf", "a.gltf"});
  EXPECT_EQ(files.status, 0) << files.err;
  EXPECT_NE(Read("a.json").find("\"rays\": ["), std::string::npos);
  EXPECT_NE(Read("a.svg").find("</svg>"), std::string::npos);
  EXPECT_NE(Read("a.gltf").find("KHR_materials_unlit"), std::string::npos);
  const Result only = Run({"explain", "spheres.nff", "24", "20", "--json", "-"});
  EXPECT_EQ(only.out, Read("a.json"));
  const Result why =
      Run({"explain", "spheres.nff", "24", "20", "--why", "bright", "--samples", "9"});
  EXPECT_TRUE(why.out.starts_with("pixel 24,20: 9 samples, mean ")) << why.out;
}

TEST_F(ExplainCommand, SaysWhatIsWrong) {
  const Result outside = Run({"explain", "spheres.nff", "48", "0"});
  EXPECT_EQ(outside.status, 1);
  EXPECT_TRUE(outside.err.ends_with(
      "snell: error: pixel 48,0 lies outside of the picture of 48×32 pixels\n"))
      << outside.err;
  const Result word = Run({"explain", "spheres.nff", "left", "0"});
  EXPECT_EQ(word.status, 2);
  EXPECT_EQ(word.err, "snell: X must be a whole number, not 'left'\n");
  EXPECT_EQ(Run({"explain", "spheres.nff", "1", "1", "--samples", "3"}).status, 2);
  EXPECT_EQ(Run({"explain", "spheres.nff", "1", "1", "--why", "noisy", "--svg", "a.svg"}).status,
            2);
  EXPECT_FALSE(Exists("a.svg"));
}

}  // namespace
}  // namespace snell::test
