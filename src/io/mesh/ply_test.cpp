// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

#include "io/mesh/test_files.h"

namespace snell::io {
namespace {

using scene::uvec3;
using scene::vec2;
using scene::vec3;

MeshResult ReadPlyText(const std::string& text) { return ReadText("test.ply", text); }

// A tetrahedron, in ASCII.
const std::string Tetrahedron =
    "ply\nformat ascii 1.0\ncomment by hand\nobj_info none\nelement vertex 4\n"
    "property float x\nproperty float y\nproperty float z\n"
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

// Writes numbers of any type in either byte order.
class Bytes {
 public:
  explicit Bytes(bool big) : big_(big) {}
  template <class T>
  Bytes& Add(T value) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    if (big_ == (std::endian::native == std::endian::little))
      std::reverse(bytes, bytes + sizeof(T));
    text_.append(bytes, sizeof(T));
    return *this;
  }
  const std::string& text() const { return text_; }

 private:
  bool big_;
  std::string text_;
};

TEST(MeshPly, ReadsAscii) {
  const MeshResult result = ReadPlyText(Tetrahedron);
  ASSERT_EQ(result.error, "");
  EXPECT_TRUE(result.warnings.empty());
  EXPECT_TRUE(IsSound(result.mesh));
  EXPECT_NEAR(Volume(result.mesh), 1.0 / 6, 1e-12);
  EXPECT_EQ(result.mesh.positions.size(), 12u);  // every edge is a crease
  EXPECT_EQ(ReadText("a.ply", Tetrahedron, {.smoothDegrees = 0}).mesh.positions.size(), 4u);
  EXPECT_EQ(ReadText("a.ply", Tetrahedron, {.smoothDegrees = 180}).mesh.positions.size(), 4u);
}

TEST(MeshPly, LineEndsAndBlanksDoNotMatter) {
  for (const std::string end : {"\r\n", "\r", " \n", "\n\n"}) {
    std::string text;
    for (const char c : Tetrahedron) text += c == '\n' ? end : std::string(1, c);
    if (end == "\n\n") text.erase(3, 1);  // the first line is special
    const MeshResult result = ReadPlyText(text);
    EXPECT_EQ(result.error, "");
    EXPECT_NEAR(Volume(result.mesh), 1.0 / 6, 1e-12);
  }
  EXPECT_EQ(ReadPlyText(Tetrahedron.substr(0, Tetrahedron.size() - 1)).error, "");
}

TEST(MeshPly, ReadsBothByteOrdersAndAllTypes) {
  for (const bool big : {false, true}) {
    for (const std::string end : {"\n", "\r\n", "\r"}) {
      std::string text;
      for (const std::string line :
           {"ply", big ? "format binary_big_endian 1.0" : "format binary_little_endian 1.0",
            "element vertex 4", "property uint8 skipped", "property double x",
            "property list ushort double more", "property int16 y", "property float32 z",
            "element extra 2", "property list char uint list", "property uint16 last",
            "element face 2", "property int id", "property list int8 uint vertex_index",
            "property uchar flags", "end_header"})
        text += line + end;

      Bytes body(big);
      const double x[] = {0, 1.5, 1.5, 0};
      for (int i = 0; i < 4; ++i) {
        body.Add(std::uint8_t(10)).Add(x[i]).Add(std::uint16_t(i));
        for (int k = 0; k < i; ++k) body.Add(3.0);
        body.Add(std::int16_t(i < 2 ? 0 : -300)).Add(0.5f);
      }
      body.Add(std::int8_t(1)).Add(std::uint32_t(7)).Add(std::uint16_t(1));
      body.Add(std::int8_t(0)).Add(std::uint16_t(1));
      body.Add(std::int32_t(-1)).Add(std::int8_t(4));
      for (const std::uint32_t corner : {0, 1, 2, 3}) body.Add(corner);
      body.Add(std::uint8_t(0)).Add(std::int32_t(-1)).Add(std::int8_t(2));
      for (const std::uint32_t corner : {0, 1}) body.Add(corner);
      body.Add(std::uint8_t(0));

      const MeshResult result = ReadPlyText(text + body.text());
      ASSERT_EQ(result.error, "");
      EXPECT_DOUBLE_EQ(AreaVector(result.mesh).z, -450);
      EXPECT_EQ(result.mesh.positions[2], vec3(1.5f, -300, 0.5f));
      ASSERT_EQ(result.warnings.size(), 1u);
      EXPECT_EQ(result.warnings[0].message, "1 degenerate face left out");

      // No byte may be missing
      for (std::size_t cut = 1; cut <= body.text().size(); ++cut) {
        const std::string error =
            ReadPlyText(text + body.text().substr(0, body.text().size() - cut)).error;
        EXPECT_NE(error.find("cut short"), std::string::npos) << cut;
      }
    }
  }
}

TEST(MeshPly, NormalsAndUvsOfVertices) {
  for (const auto& [u, v] : {std::pair("u", "v"), {"s", "t"}, {"texture_u", "texture_v"}}) {
    const MeshResult result = ReadPlyText(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nproperty char nx\nproperty char ny\nproperty char nz\nproperty float " +
        std::string(u) + "\nproperty float " + v +
        "\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0 0 0 127 0 0\n1 0 0 0 127 0 1 0\n0 1 0 -127 0 0 0 1\n3 0 1 2\n");
    ASSERT_EQ(result.error, "");
    EXPECT_EQ(result.mesh.normals, (std::vector<vec3>{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}));
    EXPECT_EQ(result.mesh.uvs, (std::vector<vec2>{{0, 0}, {1, 0}, {0, 1}}));
  }
}

TEST(MeshPly, UvsOfFaceCornersSplitVertices) {
  const MeshResult result = ReadPlyText(
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nelement face 3\nproperty list uchar float texcoord\n"
      "property list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
      "6 0 0 1 0 1 1 3 0 1 2\n6 0.5 0 1 1 0 1 3 0 2 3\n0 3 0 1 3\n");
  ASSERT_EQ(result.error, "");
  EXPECT_TRUE(IsSound(result.mesh));
  // Corner 0 has the uvs (0, 0), (0.5, 0) and none; corners 1 and 3 one and none; corner 2 one
  EXPECT_EQ(result.mesh.positions.size(), 8u);
}

TEST(MeshPly, TriangleStripsTurnAndRestart) {
  const MeshResult result = ReadPlyText(
      "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
      "property float z\nelement tristrips 2\nproperty list int int vertex_indices\nend_header\n"
      "0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n2 1 0\n"
      "8 1 0 3 2 -1 3 2 5\n3 2 4 5\n");
  ASSERT_EQ(result.error, "");
  EXPECT_EQ(result.mesh.triangles.size(), 4u);
  EXPECT_DOUBLE_EQ(AreaVector(result.mesh).z, 2);
  EXPECT_DOUBLE_EQ(Area(result.mesh), 2);
}

TEST(MeshPly, FacesMayComeBeforeVertices) {
  const MeshResult result = ReadPlyText(
      "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\n"
      "element vertex 5\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
      "5 0 1 2 3 4\n0 0 0\n4 2 0\n2 3 0\n0 4 0\n1 2 0\n");
  ASSERT_EQ(result.error, "");
  EXPECT_DOUBLE_EQ(AreaVector(result.mesh).z, 6);
  EXPECT_DOUBLE_EQ(Area(result.mesh), 6);
}

TEST(MeshPly, UnusedAndUndefinedVerticesGo) {
  std::string text = Tetrahedron;
  text.replace(text.find("vertex 4"), 8, "vertex 6");
  text.replace(text.find("0 0 0\n"), 6, "0 0 0\nnan nan nan\n");
  text.insert(text.find("3 0 2 1"), "1e9 0 0\n");
  for (const auto& [from, to] : {std::pair("3 0 2 1", "3 0 3 2"),
                                 {"3 0 1 3", "3 0 2 4"},
                                 {"3 0 3 2\n3 1", "3 0 4 3\n3 1"},
                                 {"3 1 2 3", "3 1 3 4"}})
    text.replace(text.rfind(from), std::strlen(from), to);
  const MeshResult result = ReadText("a.ply", text, {.smoothDegrees = 0});
  ASSERT_EQ(result.error, "");
  EXPECT_TRUE(IsSound(result.mesh));
  EXPECT_EQ(result.mesh.positions.size(), 4u);
  EXPECT_EQ(result.warnings.size(), 1u);
}

// The tetrahedron with something replaced must give the error.
void ExpectError(const std::string& from, const std::string& to, const std::string& error) {
  std::string text = Tetrahedron;
  const std::size_t at = text.find(from);
  ASSERT_NE(at, text.npos) << from;
  text.replace(at, from.size(), to);
  EXPECT_EQ(ReadPlyText(text).error, "test.ply" + error);
}

TEST(MeshPly, HeaderErrorsNameTheLine) {
  ExpectError("ply\n", "plyx\n", ":1: not a PLY file: it does not begin with 'ply'");
  ExpectError("ascii", "binary",
              ":2: unknown format 'binary'; ascii, binary_little_endian and "
              "binary_big_endian are known");
  ExpectError(" 1.0", " 2.0", ":2: unknown version '2.0' of the format; 1.0 is known");
  ExpectError("format ascii 1.0\n", "", ":10: the header has no 'format' line");
  ExpectError("vertex 4", "vertex four", ":5: 'four' is no count of elements");
  ExpectError("vertex 4", "vertex -4", ":5: '-4' is no count of elements");
  ExpectError("vertex 4", "vertex 4 4", ":5: '4' is one word too many");
  ExpectError("element vertex 4\n", "", ":5: a property without an element before it");
  ExpectError("float x", "real x", ":6: unknown type 'real'");
  ExpectError("float x", "float", ":6: a property needs a name");
  ExpectError("float x", "float w", ":5: the vertices have no property 'x'");
  ExpectError("property float x\nproperty float y\nproperty float z\n", "",
              ":5: the vertices have no property 'x'");
  ExpectError("uchar int", "float int", ":10: the length of a list must have an integer type");
  ExpectError("element face", "element vertex", ":9: a second element 'vertex'");
  ExpectError("vertex_indices", "corners", ":9: the elements 'face' have no list 'vertex_indices'");
  ExpectError("end_header\n", "", ":19: the header ends without 'end_header'");
}

TEST(MeshPly, BodyErrorsNameTheLine) {
  ExpectError("3 0 1 3", "3 0 1 4",
              ":17: face 1 refers to vertex 4, but there are 4, counted from 0");
  ExpectError("3 0 1 3", "3 0 -1 3",
              ":17: face 1 refers to vertex -1, but there are 4, counted from 0");
  ExpectError("3 0 1 3", "3 0 x 3", ":17: 'x' is not a number");
  ExpectError("3 0 1 3", "3 0 1 3 2", ":17: '2' is more than the line should hold");
  ExpectError("3 0 1 3", "-3 0 1 3", ":17: a list 'vertex_indices' of length -3");
  ExpectError("3 0 1 3", "2000000000 0 1 3",
              ":17: the file ends within its data; it may be cut short");
  ExpectError("3 1 2 3\n", "3 1 2", ":19: the file ends within its data; it may be cut short");
  ExpectError("vertex 4", "vertex 4000000000",
              ":5: the header promises 4,000,000,000 elements 'vertex', but there are only 56 B of "
              "data; the file may be cut short");
}

TEST(MeshPly, FilesWithoutFacesSayWhatTheyHave) {
  const std::string cloud =
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
      "property float z\n";
  EXPECT_EQ(ReadPlyText(cloud + "end_header\n0 0 0\n1 1 1\n").error,
            "test.ply: there are no faces to render; the file has a cloud of 2 points");
  EXPECT_EQ(ReadPlyText(cloud + "element edge 1\nproperty int vertex1\nproperty int vertex2\n"
                                "end_header\n0 0 0\n1 1 1\n0 1\n")
                .error,
            "test.ply: there are no faces to render; the file has a cloud of 2 points, 1 edge");
  EXPECT_EQ(ReadPlyText("ply\nformat ascii 1.0\nend_header\n").error,
            "test.ply: the file has no element 'vertex'");
}

TEST(MeshPly, NoiseInTheHeaderIsBounded) {
  EXPECT_EQ(ReadPlyText("ply\nformat ascii 1.0\n" + std::string(100000, '\n')).error.substr(0, 9),
            "test.ply:");
  std::string noise = "ply\n";
  for (int i = 0; i < 1000; ++i) noise += "noise\n";
  EXPECT_EQ(ReadPlyText(noise).error,
            "test.ply:18: unknown header line 'noise', and many others before");
}

}  // namespace
}  // namespace snell::io
