// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <string>

#include "io/mesh/test_files.h"

namespace snell::io {
namespace {

using scene::Mesh;
using scene::vec2;
using scene::vec3;

constexpr const char* Square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

MeshResult ReadObjText(const std::string& text) { return ReadText("test.obj", text); }

TEST(MeshObj, ReadsTrianglesAndNothingElse) {
  const MeshResult result = ReadObjText("# a comment\n\nv 0 0 0\n  v 1 0 0\nv\t0 1 0\nf 1 2 3\n");
  EXPECT_EQ(result.error, "");
  EXPECT_TRUE(result.warnings.empty());
  EXPECT_TRUE(IsSound(result.mesh));
  EXPECT_EQ(result.mesh.positions.size(), 3u);
  EXPECT_EQ(result.mesh.triangles.size(), 1u);
  EXPECT_TRUE(result.mesh.uvs.empty());
  EXPECT_EQ(result.mesh.normals.at(0), vec3(0, 0, 1));
  EXPECT_EQ(result.mesh.name, "test");
}

TEST(MeshObj, EveryLineEndIsTheSame) {
  const std::string source = std::string(Square) + "f 1 2 \\\n 3 4\n# end \\\nf 1 2 3";
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string text;
    for (const char c : source) text += c == '\n' ? end : std::string(1, c);
    const MeshResult result = ReadObjText(text);
    EXPECT_EQ(result.error, "");
    EXPECT_EQ(result.mesh.triangles.size(), 3u);
    EXPECT_DOUBLE_EQ(AreaVector(result.mesh).z, 1.5);
  }
}

TEST(MeshObj, ByteOrderMarkAndTrailingComments) {
  const MeshResult result =
      ReadObjText("\xef\xbb\xbfv 0 0 0 # origin\nv 1 0 0#\nv 0 1 0\nf 1 2 3 # all\n");
  EXPECT_EQ(result.error, "test.obj:2: '0#' is not a number");
  const MeshResult good =
      ReadObjText("\xef\xbb\xbfv 0 0 0 # origin\nv 1 0 0\nv 0 1 0\nf 1 2 3 # all\n");
  EXPECT_EQ(good.error, "");
  EXPECT_EQ(good.mesh.triangles.size(), 1u);
}

TEST(MeshObj, NumbersInAllSpellings) {
  const MeshResult result =
      ReadObjText("v +1 2. .5\nv -1e2 +.25E-2 3.125e+1\nv 1234567.875 0 -0\nf 1 2 3\n");
  ASSERT_EQ(result.error, "");
  EXPECT_EQ(result.mesh.positions[0], vec3(1, 2, 0.5f));
  EXPECT_EQ(result.mesh.positions[1], vec3(-100, 0.0025f, 31.25f));
  EXPECT_EQ(result.mesh.positions[2], vec3(1234567.875f, 0, 0));
}

TEST(MeshObj, NegativeIndicesCountBack) {
  const MeshResult result =
      ReadObjText(std::string(Square) + "f -4 -3 -2 -1\nv 0 0 1\nf -1 -5 -4\n");
  ASSERT_EQ(result.error, "");
  EXPECT_EQ(result.mesh.triangles.size(), 3u);
  EXPECT_DOUBLE_EQ(AreaVector(result.mesh).z, 1.0);
  EXPECT_DOUBLE_EQ(AreaVector(result.mesh).y, -0.5);
}

TEST(MeshObj, VerticesMayFollowTheirFaces) {
  const MeshResult result = ReadObjText("f 1 2 3 4\n" + std::string(Square));
  ASSERT_EQ(result.error, "");
  EXPECT_DOUBLE_EQ(AreaVector(result.mesh).z, 1.0);
}

TEST(MeshObj, ConcavePolygonsKeepTheirArea) {
  // An arrow head, both as a quadrilateral with each corner first and with a corner more
  const std::string head = "v 0 0 0\nv 4 2 0\nv 0 4 0\nv 1 2 0\nv 2 3 0\n";
  for (const char* face : {"f 1 2 3 4", "f 2 3 4 1", "f 3 4 1 2", "f 4 1 2 3", "f 1 2 5 3 4"}) {
    const MeshResult result = ReadObjText(head + face);
    ASSERT_EQ(result.error, "");
    EXPECT_DOUBLE_EQ(AreaVector(result.mesh).z, 6.0) << face;
    EXPECT_DOUBLE_EQ(Area(result.mesh), 6.0) << face;
  }
}

TEST(MeshObj, NormalsWithoutUvs) {
  const MeshResult result =
      ReadObjText(std::string(Square) + "vn 0 0 2\nvn 0.6 0 0.8\nf 1//1 2//1 3//2 4//-1\n");
  ASSERT_EQ(result.error, "");
  ASSERT_EQ(result.mesh.normals.size(), 4u);
  EXPECT_TRUE(result.mesh.uvs.empty());
  EXPECT_EQ(result.mesh.normals[0], vec3(0, 0, 1));
  EXPECT_NEAR(result.mesh.normals[3].x, 0.6f, 1e-6f);
}

TEST(MeshObj, SeamsSplitVerticesButNotNormals) {
  // Two squares that meet at x = 1 with different uvs there
  const MeshResult result = ReadObjText(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0.2\nv 2 1 0.2\n"
      "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
      "f 1/1 2/2 3/3 4/4\nf 2/1 5/2 6/3 3/4\n");
  ASSERT_EQ(result.error, "");
  ASSERT_EQ(result.mesh.positions.size(), 8u);
  ASSERT_EQ(result.mesh.uvs.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t j = 0; j < 8; ++j) {
      if (result.mesh.positions[i] != result.mesh.positions[j]) continue;
      EXPECT_EQ(result.mesh.normals[i], result.mesh.normals[j]);
    }
}

TEST(MeshObj, EqualCornersShareVertices) {
  const MeshResult result = ReadObjText(std::string(Square) +
                                        "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n"
                                        "f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/4/1\n");
  ASSERT_EQ(result.error, "");
  EXPECT_EQ(result.mesh.positions.size(), 4u);
  EXPECT_EQ(result.mesh.uvs[2], vec2(1, 1));
}

TEST(MeshObj, FacesWithoutNormalsBesideOthersGetThem) {
  const MeshResult result =
      ReadObjText(std::string(Square) + "v 0 0 1\nvn 1 0 0\nf 1//1 2//1 3//1 4//1\nf 1 5 2\n");
  ASSERT_EQ(result.error, "");
  EXPECT_TRUE(IsSound(result.mesh));
  ASSERT_EQ(result.mesh.normals.size(), 7u);
  EXPECT_EQ(result.mesh.normals[0], vec3(1, 0, 0));
  EXPECT_EQ(result.mesh.normals[6], vec3(0, 1, 0));
}

TEST(MeshObj, OptionsForNormals) {
  const std::string text = std::string(Square) + "vn 1 0 0\nf 1//1 2//1 3//1 4//1\n";
  EXPECT_EQ(ReadText("a.obj", text).mesh.normals.at(0), vec3(1, 0, 0));
  EXPECT_EQ(ReadText("a.obj", text, {.ignoreFileNormals = true}).mesh.normals.at(0), vec3(0, 0, 1));
  EXPECT_TRUE(ReadText("a.obj", text, {.smoothDegrees = 0, .ignoreFileNormals = true})
                  .mesh.normals.empty());
}

TEST(MeshObj, IndicesOfMissingAttributesAreIgnoredWithAWarning) {
  const MeshResult result = ReadObjText(std::string(Square) + "vt 0 0\nf 1/1/1 2/2/2 3/3/3\n");
  ASSERT_EQ(result.error, "");
  EXPECT_TRUE(IsSound(result.mesh));
  ASSERT_EQ(result.warnings.size(), 2u);
  EXPECT_NE(result.warnings[0].message.find("at 2 corners"), std::string::npos);
  EXPECT_NE(result.warnings[1].message.find("at 3 corners"), std::string::npos);
}

TEST(MeshObj, EmptyIndicesAreAbsent) {
  for (const char* face : {"f 1/ 2/ 3/", "f 1// 2// 3//", "f 1/1/ 2/1/ 3/1/", "f 1//1 2//1 3//1"}) {
    const MeshResult result = ReadObjText(std::string(Square) + "vt 0 0\nvn 0 0 1\n" + face + "\n");
    EXPECT_EQ(result.error, "") << face;
    EXPECT_TRUE(result.warnings.empty()) << face;
    EXPECT_EQ(result.mesh.positions.size(), 3u) << face;
  }
}

TEST(MeshObj, UndefinedCoordinatesTakeTheirFacesAway) {
  for (const char* bad : {"nan", "-inf", "2e18", "1e39", "1e999", "1.#INF", "+NaN"}) {
    const MeshResult result =
        ReadObjText(std::string(Square) + "v 0 " + bad + " 0\nf 1 2 3\nf 1 2 5\nf 5 4 3 2\n");
    ASSERT_EQ(result.error, "") << bad;
    EXPECT_TRUE(IsSound(result.mesh)) << bad;
    EXPECT_EQ(result.mesh.triangles.size(), 1u) << bad;
    ASSERT_EQ(result.warnings.size(), 1u) << bad;
    EXPECT_EQ(result.warnings[0].message,
              "2 faces with infinite, huge or undefined coordinates left out");
  }
}

TEST(MeshObj, DegenerateFacesAreHarmless) {
  const MeshResult result =
      ReadObjText(std::string(Square) +
                  "v 0.5 0 0\nf 1 2 3\nf 1 2 3\nf 1 1 2\nf 1 5 2\nf 1 1 1\nf 1 2\nf\nf 3\n");
  ASSERT_EQ(result.error, "");
  EXPECT_TRUE(IsSound(result.mesh));
  EXPECT_DOUBLE_EQ(Area(result.mesh), 1.0);
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_EQ(result.warnings[0].message, "3 degenerate faces left out, the first one 'f'");
  EXPECT_EQ(result.warnings[0].place.line, 11);
}

TEST(MeshObj, SaysWhatItLeavesOut) {
  const MeshResult result = ReadObjText(
      "mtllib a.mtl\nusemtl b\no one\ng some group\ns off\nvp 0.5\ncstype bezier\np 1\nl 1 "
      "2\nbleh\n"
      "v 0 0 0 1 0 0\nv 1 0 0 1 1 1\nv 0 1 0 0 0 0\nf 1 2 3\n");
  ASSERT_EQ(result.error, "");
  EXPECT_EQ(result.mesh.name, "one");
  std::vector<std::string> messages;
  for (const Diagnostic& warning : result.warnings) messages.push_back(warning.message);
  EXPECT_EQ(messages,
            (std::vector<std::string>{"1 point statement left out, the first one 'p'",
                                      "1 line statement left out, the first one 'l'",
                                      "2 free-form statements left out, the first one 'vp'",
                                      "1 unknown statement left out, the first one 'bleh'",
                                      "the file's materials are not read"}));
}

TEST(MeshObj, ErrorsNameTheLine) {
  const std::string square = Square;
  EXPECT_EQ(ReadObjText(square + "f 1 2 x\n").error.substr(0, 42),
            "test.obj:5: 'x' is no corner of a face; co");
  EXPECT_EQ(ReadObjText(square + "f 1 0 2\n").error,
            "test.obj:5: index 0 in '0': OBJ counts from 1");
  EXPECT_EQ(ReadObjText(square + "f 1 2 3/4/5/6\n").error.substr(0, 33),
            "test.obj:5: '3/4/5/6' is no corne");
  EXPECT_EQ(ReadObjText(square + "f 1 2 4294967297\n").error,
            "test.obj:5: the index in '4294967297' is too large");
  EXPECT_EQ(ReadObjText(square + "f 1 2 5\nf 1 2 3\n").error,
            "test.obj:5: the face refers to vertex 5, but 4 are defined");
  EXPECT_EQ(ReadObjText(square + "f 1 2 \\\n -5\n").error,
            "test.obj:5: the face refers to vertex -5, but 4 are defined so far");
  EXPECT_EQ(ReadObjText(square + "f 1 \\\n 2 3\nv bleh 0 0\n").error,
            "test.obj:7: 'bleh' is not a number");
  EXPECT_EQ(ReadObjText(square + "v 1,5 0 0\n").error, "test.obj:5: '1,5' is not a number");
  EXPECT_EQ(ReadObjText(square + "vn 1 0").error,
            "test.obj:5: 'vn' needs three numbers, not 2; the file may be cut short");
  EXPECT_EQ(ReadObjText(square + "vt\n").error, "test.obj:5: 'vt' needs at least one number");
}

TEST(MeshObj, FilesWithoutFacesSayWhatTheyHave) {
  EXPECT_EQ(ReadObjText("").error,
            "test.obj: there are no faces to render; the file has no vertices");
  EXPECT_EQ(ReadObjText(std::string(Square) + "l 1 2 3\np 1\np 2\n").error,
            "test.obj: there are no faces to render; the file has 4 vertex statements, 2 point "
            "statements, 1 line statement");
  EXPECT_EQ(ReadObjText("v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 1 2\nf 1 2 3\n").error,
            "test.obj: no face has an area and finite coordinates");
  EXPECT_EQ(ReadObjText(std::string("v 0 0 0\0f", 9)).error,
            "test.obj: not a text file in ASCII or UTF-8: it holds zero bytes");
}

// As 16-bit units after their mark, in the order of bytes that the mark tells.
static std::string AsUtf16(std::u16string_view text, bool little) {
  std::string bytes;
  for (const char16_t unit : u"\ufeff" + std::u16string(text)) {
    const char low = char(unit & 0xff), high = char(unit >> 8);
    bytes += little ? low : high;
    bytes += little ? high : low;
  }
  return bytes;
}

TEST(MeshObj, Utf16IsRead) {
  constexpr std::u16string_view text =
      u"o h\u00fct\u20ac\U0001f3a9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  for (const bool little : {true, false}) {
    const MeshResult result = ReadObjText(AsUtf16(text, little));
    EXPECT_EQ(result.error, "");
    EXPECT_EQ(result.mesh.name, "h\xc3\xbct\xe2\x82\xac\xf0\x9f\x8e\xa9");
    EXPECT_EQ(result.mesh.triangles.size(), 1u);
  }
  // Half of a pair and half of a unit
  const std::string lone =
      AsUtf16(std::u16string(u"o a") + char16_t(0xd83c) + u"\nv 0 0 0\n", true) + "x";
  EXPECT_NE(ReadObjText(lone).error, "");
  EXPECT_EQ(ReadObjText(AsUtf16(std::u16string_view(u"v 0\0", 4), false)).error,
            "test.obj: not a text file in ASCII or UTF-8: it holds zero bytes");
}

TEST(MeshObj, LimitsHold) {
  const std::string text = std::string(Square) + "f 1 2 3 4\n";
  EXPECT_EQ(
      ReadText("a.obj", text, {.limits = {.triangles = 1}}).error,
      "a.obj: the file has 2 triangles; the limit is 1; --limit triangles=N raises the limit");
  EXPECT_EQ(ReadText("a.obj", text, {.limits = {.triangles = 2}}).error, "");
  EXPECT_NE(ReadText("a.obj", text, {.limits = {.fileBytes = 10}}).error, "");
}

TEST(MeshObj, ManyCornersOfOnePolygon) {
  // A comb with 500 teeth: concave at every other corner
  std::string text, face = "f";
  constexpr int Teeth = 500;
  for (int i = 0; i < Teeth; ++i)
    text += "v " + std::to_string(2 * i) + " 0 0\nv " + std::to_string(2 * i + 1) + " 0 0\nv " +
            std::to_string(2 * i + 1) + " 9 0\nv " + std::to_string(2 * i + 2) + " 9 0\n";
  text += "v " + std::to_string(2 * Teeth) + " 10 0\nv 0 10 0\n";
  for (int i = 1; i <= 4 * Teeth + 2; ++i) face += " " + std::to_string(i);
  const MeshResult result = ReadObjText(text + face + "\n");
  ASSERT_EQ(result.error, "");
  EXPECT_TRUE(result.warnings.empty());
  EXPECT_DOUBLE_EQ(Area(result.mesh), 2.0 * Teeth + 9.0 * Teeth);
  EXPECT_DOUBLE_EQ(AreaVector(result.mesh).z, 2.0 * Teeth + 9.0 * Teeth);
}

TEST(MeshObj, RemembersWhichTrianglesWereOnePolygon) {
  const std::string vertices =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 2 1\nv 0 0 0\nv 1 0 0\nv 2 0 0\n";
  const auto joinsOf = [&](const std::string& faces) {
    return ReadText("a.obj", vertices + faces).mesh.joins;
  };
  // The third face has no area and gives no triangle
  EXPECT_EQ(joinsOf("f 1 2 3 4\nf 1 2 5\nf 1 1 2 2\nf 4 3 2 1\n").size(),
            ReadText("a.obj", vertices + "f 1 2 3 4\nf 1 2 5\nf 1 1 2 2\nf 4 3 2 1\n")
                .mesh.triangles.size());
  EXPECT_EQ(joinsOf("f 1 2 5\nf 1 2 3 4\nf 3 4 5\n"),
            (std::vector<bool>{false, false, true, false}));
  EXPECT_TRUE(joinsOf("f 1 2 5\nf 3 4 5\n").empty());
}

}  // namespace
}  // namespace snell::io
