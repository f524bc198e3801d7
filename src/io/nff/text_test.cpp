// SPDX-License-Identifier: Apache-2.0
//
// The NFF reader's dealings with text: blanks, line ends, and what wrong files are told, with the place.
#include <gtest/gtest.h>

#include <fstream>
#include <glm/vec3.hpp>
#include <random>

#include "io/nff/nff.h"

namespace snell::io {
namespace {

using scene::vec3;

const std::string Ball = "s 0 0 0 1\n";

std::string ErrorOf(const std::string& text) {
  try {
    ParseNff(text, "t.nff", {});
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Nff, LineEndsCommentsAndBlanksMeanNothing) {
  const std::string words = "f 1 0 0 1 0 0 0 0 # red\ns 1e0 +2 -.5 5E-1#small\n\n#end";
  std::string crLf, cr;
  for (const char c : words) {
    crLf += c == '\n' ? "\r\n" : std::string(1, c);
    cr += c == '\n' ? '\r' : c;
  }
  for (const std::string& text : {words, crLf, cr, "\xEF\xBB\xBF" + words, "\t\f" + words}) {
    const scene::Scene scene = ParseNff(text, "t.nff", {});
    const scene::Sphere sphere = std::get<scene::Sphere>(scene.objects.at(0).geometry);
    EXPECT_EQ(sphere.center, vec3(1, 2, -0.5f));
    EXPECT_EQ(sphere.radius, 0.5f);
    EXPECT_EQ(scene.objects[0].place.line, 2);
  }
}

TEST(Nff, ErrorsNameThePlaceAndTheForm) {
  EXPECT_EQ(ErrorOf("s 0 0 0\ns 1 1 1 1\n"),
            "t.nff:2:1: expected a number, found 's'; the form is: s X Y Z RADIUS");
  EXPECT_EQ(ErrorOf("\n  s 0 zero 0 1\n"),
            "t.nff:2:7: expected a number, found 'zero'; the form is: s X Y Z RADIUS");
  EXPECT_EQ(
      ErrorOf("l 1 2"),
      "t.nff:1:6: expected a number, found the end of the file; the form is: l X Y Z [RED GREEN "
      "BLUE]");
  EXPECT_EQ(ErrorOf("l 1 2 3 1\n" + Ball),
            "t.nff:2:1: expected a number, found 's'; the form is: l X Y Z [RED GREEN BLUE]");
  EXPECT_EQ(ErrorOf("s 0 0 0 1 7\n"),
            "t.nff:1:11: '7' is a number too many; the form is: s X Y Z RADIUS");
  EXPECT_EQ(ErrorOf("x 1 2 3\n"),
            "t.nff:1:1: unknown entity 'x'; NFF has v, b, l, f, s, c, p and pp");
  EXPECT_EQ(ErrorOf("angle 45\n"),
            "t.nff:1:1: 'angle' stands outside of a view; a view begins with 'v'");
}

TEST(Nff, ErrorsOfValues) {
  const std::string fill = "the form is: f RED GREEN BLUE KD KS SHINE T INDEX";
  EXPECT_EQ(ErrorOf("f 1 1 1 -1 0 0 0 0\n"), "t.nff:1:9: -1 must not be negative; " + fill);
  EXPECT_EQ(
      ErrorOf("f 1 1 1 0 0 0 0.5 0\n"),
      "t.nff:1:19: a surface that light passes through needs an index of refraction; 1 lets light "
      "pass straight on");
  for (const char* number : {"nan", "inf", "1e39", "-1e999", "1..2", "0x10", "1,5", "-", "+", "1f"})
    EXPECT_NE(ErrorOf(std::string("s 0 0 ") + number + " 1\n").find("t.nff:1:7: "),
              std::string::npos)
        << number;
  EXPECT_EQ(
      ErrorOf("p 2 0 0 0 1 1 1\n"),
      "t.nff:1:3: expected a whole number from 3 to 10000, found '2'; the form is: p COUNT, then X "
      "Y Z of each corner");
  EXPECT_NE(ErrorOf("p 2000000000 0 0 0\n").find("from 3 to 10000"), std::string::npos);
  EXPECT_NE(ErrorOf("p 3.5 0 0 0\n").find("whole number"), std::string::npos);
  EXPECT_EQ(ErrorOf("c 1 2 3 1 1 2 3 1\n"),
            "t.nff:1:1: the cone's base and apex are the same point");
  EXPECT_EQ(ErrorOf("c 1 2 3 1 1 2 4 -1\n"), "t.nff:1:1: the cone's radii must not differ in sign");
}

TEST(Nff, ErrorsOfViews) {
  const std::string rest = " at 0 0 0 up 0 1 0 angle 45\n" + Ball;
  EXPECT_NE(ErrorOf("v" + rest).find("t.nff:1:1: the view has no 'from'"), std::string::npos);
  EXPECT_NE(
      ErrorOf("v from 0 0 1 from 0 0 2" + rest).find("t.nff:1:14: the view has a second 'from'"),
      std::string::npos);
  EXPECT_EQ(ErrorOf("v from 0 0 0" + rest),
            "t.nff:1:1: the view's 'from' and 'at' are the same point");
  EXPECT_EQ(ErrorOf("v from 0 3 0" + rest),
            "t.nff:1:1: the view's 'up' has no length or points along the view");
  EXPECT_EQ(ErrorOf("v from 0 0 5 at 0 0 0 up 0 1 0 angle 180\n" + Ball),
            "t.nff:1:38: the angle must lie between 0 and 179 degrees, not 180");
  EXPECT_NE(ErrorOf("v resolution 0 5" + rest).find("from 1 to 65536, found '0'"),
            std::string::npos);
  EXPECT_NE(ErrorOf("v resolution 1e9 5" + rest).find("from 1 to 65536"), std::string::npos);
}

TEST(Nff, AllErrorsOfAFileAreTold) {
  const std::string text =
      "v\nfrom 0 0 x\nat 0 0 0\nup 0 1 0\nangle 45\nl 1 2 3\nb 0 0 red\nq\ns 0 0 0 1 2 3\n" + Ball;
  try {
    ParseNff(text, "t.nff", {});
    FAIL();
  } catch (const Error& error) {
    std::vector<int> lines;
    for (const Diagnostic& diagnostic : error.diagnostics()) lines.push_back(diagnostic.place.line);
    EXPECT_EQ(lines, (std::vector<int>{2, 7, 8, 9}));
  }

  std::string many;
  for (int i = 0; i < 1000; ++i) many += "what is this\n";
  try {
    ParseNff(many, "t.nff", {});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.diagnostics().size(), 20u);
  }
}

TEST(Nff, OtherFilesAreRefused) {
  EXPECT_EQ(ErrorOf(""), "t.nff: nothing to see: no sphere, cone or polygon in this NFF file");
  EXPECT_EQ(ErrorOf("nff\nversion 2.0\n"),
            "t.nff:1:1: this is WorldToolKit's file format of the same name, not Haines' NFF");
  EXPECT_EQ(ErrorOf(std::string("s 0 0\0 0 1", 10)),
            "t.nff, byte 5: this is not an NFF file, which is text");
  const std::string strange = ErrorOf("\x01\x02\xff" + std::string(100, 'x') + "\n");
  EXPECT_EQ(strange,
            "t.nff:1:1: unknown entity '???xxxxxxxxxxxxxxxxxxxxx...'; NFF has v, b, l, f, s, c, p "
            "and pp");
  EXPECT_THROW(ReadNff("/no/such/file.nff", {}), Error);
}

TEST(Nff, ReadsFiles) {
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / "snell_nff_test.nff";
  std::ofstream(path) << "f 1 1 1 1 0 0 0 0\n" << Ball;
  const scene::Scene scene = ReadNff(path, {});
  EXPECT_EQ(scene.name, "snell_nff_test.nff");
  EXPECT_EQ(scene.objects.size(), 1u);
  std::filesystem::remove(path);
}

TEST(Nff, DamagedFilesGiveAResultOrAnError) {
  const std::string whole =
      "v\nfrom 1 2 3\nat 0 0 0\nup 0 0 1\nangle 45\nhither 1\nresolution 64 64\nb 0 0 1\nl 1 2 3\n"
      "f 1 1 1 0.5 0.5 10 0.2 1.5\ns 0 0 0 1\nc 0 0 0 1 0 0 1 0.5\n"
      "p 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\npp 3\n0 0 0 0 0 2\n1 0 0 0 3 4\n0 1 0 0 0 0\n";
  const auto tryIt = [](const std::string& text) {
    try {
      ParseNff(text, "t.nff", {});
    } catch (const Error&) {
    }
  };
  for (std::size_t length = 0; length <= whole.size(); ++length) tryIt(whole.substr(0, length));

  const std::string letters = "0123456789.-+eEvblfscp# \n\r\tx\xff";
  std::mt19937 random(3);
  for (int i = 0; i < 5000; ++i) {
    std::string text = whole;
    for (int k = 0; k < 1 + i % 8; ++k)
      text[random() % text.size()] = letters[random() % letters.size()];
    tryIt(text);
  }
}

}  // namespace
}  // namespace snell::io
