// SPDX-License-Identifier: Apache-2.0
//
// Wrong use: one helpful line, exit status 2, and nothing is written.
#include <algorithm>

#include "scratch.h"

namespace snell::test {
namespace {

struct Mistake {
  std::vector<std::string> arguments;
  std::string line;  // what is said, without "snell: "
};

const Mistake Mistakes[] = {
    // Words that nobody knows
    {{"rendr", "a.nff"}, "unknown command 'rendr'; did you mean 'render'?"},
    {{"frobnicate"},
     "unknown command 'frobnicate'; the commands are: render, merge, compare, info, explain, "
     "view, check, "
     "reference, "
     "selftest, devices, help, "
     "manual, completion"},
    {{"scene.toml"}, "'scene.toml' is not a command; to render it: snell render scene.toml"},
    {{"help", "rendr"}, "unknown command 'rendr'; did you mean 'render'?"},
    {{"render", "a.nff", "--sp", "4"}, "unknown option '--sp'; did you mean '--spp'?"},
    {{"render", "a.nff", "--thraeds=4"}, "unknown option '--thraeds'; did you mean '--threads'?"},
    {{"render", "a.nff", "-spp", "4"}, "unknown option '-spp'; did you mean '--spp'?"},
    {{"render", "a.nff", "-x"}, "unknown option '-x'; 'snell render --help' lists the options"},
    {{"render", "a.nff", "--spp", "0", "--sp"}, "unknown option '--sp'; did you mean '--spp'?"},
    {{"version"}, "unknown command 'version'; did you mean '--version'?"},
    {{"render", "a.nff", "--version"},
     "the option '--version' comes without a command: snell --version"},
    {{"--verson"}, "unknown option '--verson'; did you mean '--version'?"},
    {{"--spp", "4", "render", "a.nff"},
     "the option '--spp' comes after its command: snell render --spp"},
    // Too many words or too few
    {{"render"}, "SCENE is missing; usage: snell render [options] SCENE"},
    {{"check"}, "SCENE is missing; usage: snell check [options] SCENE ..."},
    {{"completion"}, "SHELL is missing; usage: snell completion bash|zsh|fish"},
    {{"compare", "a.png"}, "PICTURE is missing; usage: snell compare [options] REFERENCE PICTURE"},
    {{"render", "a.nff", "b.nff"},
     "unexpected argument 'b.nff'; usage: snell render [options] SCENE"},
    {{"render", "a.nff", "-o", "a.png", "b.exr"},
     "unexpected argument 'b.exr'; name each picture by an -o of its own: -o b.exr"},
    {{"render", "a.nff", "--spp"}, "--spp needs a value: --spp N"},
    {{"render", "a.nff", "--spp="}, "--spp needs a value: --spp N"},
    {{"render", "a.nff", "--quiet=3"}, "--quiet takes no value"},
    // Values that make no sense
    {{"render", "a.nff", "--spp", "0"}, "--spp must be at least 1, not '0'"},
    {{"render", "a.nff", "--spp", "-3"}, "--spp must be at least 1, not '-3'"},
    {{"render", "a.nff", "--spp", "4x"}, "--spp must be a whole number, not '4x'"},
    {{"render", "a.nff", "--spp", "1e3"}, "--spp must be a whole number, not '1e3'"},
    {{"render", "a.nff", "--spp", "99999999999"},
     "--spp must be at most 2147483647, not '99999999999'"},
    {{"render", "a.nff", "--threads", "0"}, "--threads must be at least 1, not '0'"},
    {{"render", "a.nff", "--max-depth", "0"}, "--max-depth must be at least 1, not '0'"},
    {{"render", "a.nff", "--min-contribution", "-1"},
     "--min-contribution must be at least 0, not '-1'"},
    {{"render", "a.nff", "--min-contribution", "nan"},
     "--min-contribution must be a number, not 'nan'"},
    {{"render", "a.nff", "--exposure", "bright"}, "--exposure must be a number, not 'bright'"},
    {{"render", "a.nff", "--aov", "albedo,norml"},
     "--aov must be some of albedo, normal, depth, position, uv, crypto_object, crypto_material, "
     "direct, indirect, light_groups, sample_count, variance, all, not 'albedo,norml'"},
    {{"render", "a.nff", "-o", "a.exr", "--view", "agx"},
     "--view is for .png files, and none is written"},
    {{"render", "a.nff", "-o", "a.exr", "-o", "a.denoised.exr", "--denoise"},
     "--output names 'a.denoised.exr' twice"},
    {{"render", "a.nff", "--exposure", "inf"}, "--exposure must be at most 100, not 'inf'"},
    {{"render", "a.nff", "--smooth", "181"}, "--smooth must be at most 180, not '181'"},
    {{"render", "a.nff", "--quality", "101"}, "--quality must be at most 100, not '101'"},
    {{"render", "a.nff", "--bits", "12"}, "--bits must be '8' or '16', not '12'"},
    {{"render", "a.nff", "--up", "x"}, "--up must be 'y' or 'z', not 'x'"},
    {{"render", "a.nff", "--integrator", "bdpt"},
     "--integrator must be 'whitted' or 'path', not 'bdpt'"},
    {{"completion", "tcsh"}, "SHELL must be 'bash', 'zsh' or 'fish', not 'tcsh'"},
    {{"render", "a.nff", "--size", "0x3"},
     "--size must be like 800x600, or 800 for the width alone, up to 65536, not '0x3'"},
    {{"render", "a.nff", "--size", "3x4x5"},
     "--size must be like 800x600, or 800 for the width alone, up to 65536, not '3x4x5'"},
    {{"render", "a.nff", "--size", "x"},
     "--size must be like 800x600, or 800 for the width alone, up to 65536, not 'x'"},
    {{"render", "a.nff", "--size", "100000"},
     "--size must be like 800x600, or 800 for the width alone, up to 65536, not '100000'"},
    {{"render", "a.nff", "--crop", "1,2,3"},
     "--crop must be four pixel numbers x0,y0,x1,y1 like 100,50,300,200, not '1,2,3'"},
    {{"render", "a.nff", "--crop", "5,0,5,9"},
     "--crop must have x0 below x1 and y0 below y1, not '5,0,5,9'"},
    {{"render", "a.nff", "--samples", "4"},
     "--samples must be two sample numbers A:B like 0:16, not '4'"},
    {{"render", "a.nff", "--samples", "4:4"},
     "--samples must have A below B, the first sample that is left out, not '4:4'"},
    {{"render", "a.nff", "--camera", ""}, "--camera needs a value: --camera NAME"},
    {{"render", "a.nff", "-o", "a.gif"},
     "--output must name a picture by one of the extensions png, jpg, jpeg, hdr, exr, not 'a.gif'"},
    {{"render", "a.nff", "-o", "png"},
     "--output must name a picture by one of the extensions png, jpg, jpeg, hdr, exr, not 'png'"},
    {{"render", "a.nff", "-o=a.png"}, "--output is written -o FILE or --output=FILE, not '=a.png'"},
    // Options that contradict one another
    {{"render", "a.nff", "-o", "a.png", "-o", "./a.png"}, "--output names './a.png' twice"},
    {{"render", "a.nff", "--stats", "./a.png"}, "--stats names './a.png', which is a picture"},
    {{"render", "a.nff", "--stats", "./a.nff"}, "--stats names './a.nff', which is the scene"},
    {{"render", "a.nff", "-o", "a.jpg", "--bits", "16"},
     "--bits is for .png files, and none is written"},
    {{"render", "a.nff", "--float"}, "--float is for .exr files, and none is written"},
    {{"render", "a.nff", "--quality", "50"}, "--quality is for .jpg files, and none is written"},
    {{"render", "a.nff", "-o", "a.exr", "--exposure", "1"},
     "--exposure is for .png files, and none is written"},
    {{"compare", "a.png", "b.png", "--metric", "psnr"},
     "--metric names what --tolerance limits, and needs it"},
    {{"compare", "a.png", "b.png", "--tolerance", "1", "--metric", "ssim"},
     "--metric must be 'flip', 'rmse', 'relmse', 'psnr' or 'max', not 'ssim'"},
    {{"selftest", "furnaces"},
     "unknown group 'furnaces'; the groups are: furnace, closed, luminaires, samplers, "
     "reciprocity, "
     "scenes"},
    {{"selftest", "--tolerance", "-1"}, "--tolerance must be at least 0, not '-1'"},
    {{"reference", "--markdown", "--schema"},
     "--markdown and --schema cannot be printed at once; choose one"},
};

using Usage = InScratchFolder;

TEST_F(Usage, EveryMistakeGetsOneHelpfulLine) {
  Write("a.nff", SpheresScene());
  for (const Mistake& mistake : Mistakes) {
    const Result result = Run(mistake.arguments);
    EXPECT_EQ(result.status, 2) << mistake.line;
    EXPECT_EQ(result.err, "snell: " + mistake.line + "\n");
    EXPECT_EQ(result.out, "");
  }
  EXPECT_EQ(Files(), std::vector<std::string>{"a.nff"});
}

TEST_F(Usage, ControlCharactersDoNotReachTheTerminal) {
  const Result result = Run({"check", "a\x1b[31m\nb.nff", "c\xc2\x9b.nff", "d\xff.nff"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.err.find('\x1b'), std::string::npos);
  EXPECT_EQ(result.err.find("\xc2\x9b"), std::string::npos);
  EXPECT_NE(result.err.find("a\\x1b[31m b.nff"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("c\\x9b.nff"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("d\\xff.nff"), std::string::npos) << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 3);
}

TEST_F(Usage, AFileNamedLikeACommandOrAnOptionCanBeRead) {
  Write("info.nff", SpheresScene());
  Write("-odd.nff", SpheresScene());
  EXPECT_EQ(Run({"check", "info.nff"}).status, 0);
  EXPECT_EQ(Run({"check", "--", "-odd.nff"}).status, 0);
}

}  // namespace
}  // namespace snell::test
