// SPDX-License-Identifier: Apache-2.0
//
// Help, man page and completions: made from the definitions, so that no option is missing in one of them.
#include <fstream>
#include <set>
#include <sstream>

#include "scratch.h"

namespace snell::test {
namespace {

const char* const CommandNames[] = {"render", "merge",  "compare",   "info",     "explain",
                                    "view",   "check",  "reference", "selftest", "devices",
                                    "help",   "manual", "completion"};

std::string Output(const std::vector<std::string>& arguments) {
  const Result result = RunSnell(arguments);
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");
  return result.out;
}

// The long options that a help page lists.
std::set<std::string> OptionsOf(const std::string& help) {
  std::set<std::string> options;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.find("--");
    if (!line.starts_with("  -") || begin == line.npos) continue;
    options.insert(line.substr(begin, line.find_first_of(" ,", begin) - begin));
  }
  return options;
}

using Documents = InScratchFolder;

TEST_F(Documents, TheOverviewNamesEveryCommandAndTwoExamples) {
  const std::string overview = Output({});
  EXPECT_EQ(Output({"help"}), overview);
  EXPECT_EQ(Output({"--help"}), overview);
  EXPECT_EQ(Output({"-h"}), overview);
  for (const std::string name : CommandNames)
    EXPECT_NE(overview.find("\n  " + name + " "), std::string::npos) << name;
  EXPECT_NE(overview.find("\n  snell render bunny.ply\n"), std::string::npos);
  EXPECT_NE(overview.find("\n  snell render scene.toml -o scene.png"), std::string::npos);
}

TEST_F(Documents, EachCommandHasAPage) {
  for (const std::string name : CommandNames) {
    const std::string page = Output({"help", name});
    EXPECT_EQ(Output({name, "--help"}), page);
    EXPECT_TRUE(page.starts_with("snell " + name + ": ")) << page;
    EXPECT_TRUE(OptionsOf(page).count("--help")) << page;
    std::istringstream lines(page);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
  }
  EXPECT_EQ(OptionsOf(Output({"help", "render"})),
            (std::set<std::string>{"--output",
                                   "--bits",
                                   "--float",
                                   "--quality",
                                   "--exposure",
                                   "--view",
                                   "--denoise",
                                   "--denoiser",
                                   "--aov",
                                   "--size",
                                   "--crop",
                                   "--camera",
                                   "--spp",
                                   "--samples",
                                   "--integrator",
                                   "--max-depth",
                                   "--max-diffuse-depth",
                                   "--max-specular-depth",
                                   "--max-transmission-depth",
                                   "--caustics",
                                   "--min-contribution",
                                   "--clamp-indirect",
                                   "--up",
                                   "--smooth",
                                   "--time",
                                   "--environment",
                                   "--noise",
                                   "--resume",
                                   "--checkpoint",
                                   "--checkpoint-interval",
                                   "--no-checkpoint",
                                   "--film",
                                   "--at",
                                   "--allow",
                                   "--limit",
                                   "--threads",
                                   "--device",
                                   "--gpu-debug",
                                   "--quiet",
                                   "--stats",
                                   "--help"}));
}

TEST_F(Documents, TheReadmesSceneIsRight) {
  std::ostringstream readme;
  readme << std::ifstream(SNELL_SOURCE_DIR "/README.md").rdbuf();
  const std::string text = readme.str();
  const std::size_t begin = text.find("```toml\n") + 8;
  Write("first.toml", text.substr(begin, text.find("```", begin) - begin));
  const Result result = Run({"check", "first.toml"});
  EXPECT_EQ(result.out, "first.toml: ok\n");
  EXPECT_EQ(result.err, "");
}

// The default that the reference of scenes gives for a key of [render]: "16".
std::string SceneDefault(const std::string& reference, const std::string& key) {
  const std::size_t row = reference.find("| `" + key + "` |", reference.find("## `[render]`\n"));
  const std::string line = reference.substr(row, reference.find('\n', row) - row);
  const std::size_t begin = line.find('`', line.find('`', 4) + 1) + 1;
  return line.substr(begin, line.find('`', begin) - begin);
}

TEST_F(Documents, RenderTellsTheDefaultsOfScenes) {
  const std::string reference = Output({"reference"});
  std::string help = Output({"help", "render"});
  for (std::size_t at; (at = help.find("\n                          ")) != help.npos;)
    help.replace(at, 27, " ");
  EXPECT_EQ(SceneDefault(reference, "size"), "[800, 600]");
  for (const auto& [option, value] :
       {std::pair("--size", std::string("800x600")),
        std::pair("--spp", SceneDefault(reference, "spp")),
        std::pair("--max-depth", SceneDefault(reference, "max_depth")),
        std::pair("--min-contribution", SceneDefault(reference, "min_contribution")),
        std::pair("--view", SceneDefault(reference, "view")),
        std::pair("--exposure", SceneDefault(reference, "exposure"))}) {
    const std::size_t begin = help.find("\n  " + std::string(option) + " ");
    const std::string line = help.substr(begin, help.find('\n', begin + 1) - begin);
    EXPECT_NE(line.find("(the scene's, or " + value + ")"), std::string::npos) << line;
  }
}

TEST_F(Documents, TheManPageHasEveryOptionAndIsCleanRoff) {
  const std::string page = Output({"manual"});
  Write("snell.1", page);
  for (const std::string name : CommandNames) {
    EXPECT_NE(page.find(".SS \"snell " + name), std::string::npos);
    for (std::string option : OptionsOf(Output({"help", name}))) {
      for (std::size_t i = 0; (i = option.find('-', i)) != option.npos; i += 2)
        option.insert(i, "\\");
      EXPECT_NE(page.find("\\fB" + option + "\\fR"), std::string::npos) << option;
    }
  }
  std::string complaints;
  const int status =
      RunOther({"groff", "-man", "-Tutf8", "-ww", "-z", Path("snell.1")}, &complaints);
  if (status < 0) GTEST_SKIP() << "groff is not installed";
  EXPECT_EQ(status, 0);
  EXPECT_EQ(complaints, "");
}

TEST_F(Documents, BashCompletes) {
  Write("snell.bash", Output({"completion", "bash"}));
  ASSERT_EQ(RunOther({"bash", "-n", Path("snell.bash")}), 0);
  Write("a scene.nff", "");
  Write("picture.png", "");
  Write("notes.txt", "");
  // The words of a command line, the last of which is being typed
  const auto complete = [&](const std::string& words) {
    std::string reply;
    RunOther(
        {"bash", "-c",
         "cd '" + folder_.string() + "'; source snell.bash; COMP_WORDS=(snell " + words +
             "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _snell; printf '%s;' \"${COMPREPLY[@]}\""},
        &reply);
    return reply;
  };
  EXPECT_EQ(complete("re"), "render;reference;");
  EXPECT_EQ(complete("render --s"), "--size;--spp;--samples;--smooth;--stats;");
  EXPECT_EQ(complete("render --up ''"), "y;z;");
  EXPECT_EQ(complete("render --up = z"), "z;");
  EXPECT_EQ(complete("render --spp ''"), ";");
  EXPECT_EQ(complete("render ''"), "a scene.nff;");
  EXPECT_EQ(complete("render 'a\\ s'"), "a scene.nff;");
  EXPECT_EQ(complete("compare p"), "picture.png;");
  EXPECT_EQ(complete("render -o n"), "notes.txt;");
  EXPECT_EQ(complete("help ma"), "manual;");
  EXPECT_EQ(complete("completion ''"), "bash;zsh;fish;");
}

TEST_F(Documents, ZshAndFishScriptsParse) {
  int found = 0;
  for (const std::string shell : {"zsh", "fish"}) {
    const std::string script = Output({"completion", shell});
    Write(shell, script);
    for (const std::string& option : OptionsOf(Output({"help", "render"})))
      EXPECT_NE(script.find(shell == "fish" ? " -l " + option.substr(2) + " " : option),
                std::string::npos);
    std::string complaints;
    const int status = RunOther({shell, "-n", Path(shell)}, &complaints);
    if (status < 0) continue;
    ++found;
    EXPECT_EQ(status, 0) << complaints;
  }
  if (found < 2) GTEST_SKIP() << "zsh and fish are not both installed; " << found << " was tried";
}

}  // namespace
}  // namespace snell::test
