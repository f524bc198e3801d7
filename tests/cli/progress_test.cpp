// SPDX-License-Identifier: Apache-2.0
//
// Progress: one line that is redrawn at a terminal, plain lines elsewhere.
#include <csignal>

#include "scratch.h"

namespace snell::test {
namespace {

class ProgressDisplay : public InScratchFolder {
 protected:
  ProgressDisplay() {
    Write("spheres.nff", SpheresScene());
    here_.folder = folder_;
  }

  // What is shown of a render that is stopped once `text` has been seen.
  std::string ShownUntil(const std::string& text) {
    Child child(EndlessRender, here_);
    EXPECT_TRUE(child.WaitFor(text));
    child.Send(SIGINT);
    return child.Wait().err;
  }

  Surroundings here_;
};

TEST_F(ProgressDisplay, ATerminalGetsABar) {
  here_.terminal = true;
  const std::string shown = ShownUntil(" left");
  EXPECT_NE(shown.find("\rrendering   0% [  "), std::string::npos) << shown;
  EXPECT_NE(shown.find(" Mrays/s, "), std::string::npos) << shown;
  EXPECT_EQ(shown.find('\x1b'), std::string::npos) << shown;

  // Each drawing fits the terminal's 80 columns, and the last one is wiped out
  const std::size_t summary = shown.find("snell: spheres.nff: ");
  ASSERT_NE(summary, std::string::npos);
  const std::string bars = shown.substr(0, summary);
  std::istringstream drawings(bars.substr(bars.find('\r')));
  for (std::string drawing; std::getline(drawings, drawing, '\r');)
    EXPECT_TRUE(!drawing.starts_with("rendering") || drawing.size() < 80) << drawing;
  EXPECT_NE(bars.find("\r" + std::string(79, ' ') + "\r"), std::string::npos);
}

TEST_F(ProgressDisplay, APipeGetsPlainLines) {
  const std::string shown = ShownUntil(" left");
  EXPECT_EQ(shown.find('\r'), std::string::npos);
  EXPECT_NE(shown.find("snell: rendering 0 %, "), std::string::npos) << shown;
  EXPECT_NE(shown.find(" Mrays/s, "), std::string::npos) << shown;
}

TEST_F(ProgressDisplay, ADumbTerminalGetsPlainLines) {
  here_.terminal = true;
  here_.terminalKind = "dumb";
  const std::string shown = ShownUntil(" left");
  EXPECT_NE(shown.find("snell: rendering 0 %, "), std::string::npos) << shown;
  EXPECT_EQ(shown.find("% ["), std::string::npos) << shown;
}

TEST_F(ProgressDisplay, AShortRenderSaysNothingBeforeItsSummary) {
  const Result result = Run({"render", "spheres.nff", "-o", "a.png", "--size", "8"}, here_);
  EXPECT_EQ(result.err.find('%'), std::string::npos) << result.err;
}

TEST_F(ProgressDisplay, QuietShowsNothingAtATerminal) {
  here_.terminal = true;
  EXPECT_EQ(Run({"render", "spheres.nff", "--quiet"}, here_).err, "");
}

}  // namespace
}  // namespace snell::test
