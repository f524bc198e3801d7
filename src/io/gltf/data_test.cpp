// SPDX-License-Identifier: Apache-2.0
//
// glTF's accessors of every kind, seen through the meshes that they make.
#include <gtest/gtest.h>

#include "io/gltf/test_files.h"

namespace snell::io {
namespace {

using scene::vec2;
using scene::vec3;

TEST(GltfData, IntegersNormalizedAndNot) {
  GltfBuilder builder;
  builder.Add(BytesOf(std::vector<std::int8_t>{0, 0, 0, 0, 127, 0, 0, 0, 0, -128, 64, 0}), Byte,
              "VEC3", 3, R"(, "byteStride": 4)", R"(, "normalized": true)");
  builder.Add(BytesOf(std::vector<std::uint16_t>{0, 65535, 32768, 0, 13107, 0}), UnsignedShort,
              "VEC2", 3, "", R"(, "normalized": true)");
  GltfResult result =
      ReadGltfText(builder.Mesh(R"({"attributes": {"POSITION": 0, "TEXCOORD_0": 1}})"));
  ASSERT_EQ(result.error, "");
  EXPECT_EQ(result.mesh().positions.at(1), vec3(1, 0, 0));
  EXPECT_EQ(result.mesh().positions.at(2), vec3(0, -1, float(64.0 / 127.0)));
  // v from the bottom
  EXPECT_EQ(result.mesh().uvs.at(0), vec2(0, 0));
  EXPECT_EQ(result.mesh().uvs.at(1), vec2(float(32768.0 / 65535.0), 1));

  GltfBuilder plain;
  plain.Add(BytesOf(std::vector<std::int16_t>{0, 0, 0, 0, 500, 0, 0, 0, 0, -7, 0, 0}), Short,
            "VEC3", 3, R"(, "byteStride": 8)");
  result = ReadGltfText(plain.Mesh(R"({"attributes": {"POSITION": 0}})"));
  ASSERT_EQ(result.error, "");
  EXPECT_EQ(result.mesh().positions.at(1), vec3(500, 0, 0));
}

TEST(GltfData, Interleaved) {
  GltfBuilder builder;
  const int view =
      builder.AddView(BytesOf(std::vector<float>{0, 0, 0, 9, 8, 1, 0, 0, 7, 6, 0, 1, 0, 5, 4}),
                      R"(, "byteStride": 20)");
  builder.AddAccessor(
      fmt::format(R"("bufferView": {}, "componentType": 5126, "type": "VEC3", "count": 3)", view));
  builder.AddAccessor(fmt::format(
      R"("bufferView": {}, "byteOffset": 12, "componentType": 5126, "type": "VEC2", "count": 3)",
      view));
  const GltfResult result =
      ReadGltfText(builder.Mesh(R"({"attributes": {"POSITION": 0, "TEXCOORD_0": 1}})"));
  ASSERT_EQ(result.error, "");
  EXPECT_EQ(result.mesh().positions.at(2), vec3(0, 1, 0));
  EXPECT_EQ(result.mesh().uvs.at(1), vec2(7, 1 - 6));
}

TEST(GltfData, IndicesOfEveryType) {
  for (const auto& [bytes, type] :
       {std::pair(BytesOf(std::vector<std::uint8_t>{2, 1, 0}), UnsignedByte),
        {BytesOf(std::vector<std::uint16_t>{2, 1, 0}), UnsignedShort},
        {BytesOf(std::vector<std::uint32_t>{2, 1, 0}), UnsignedInt}}) {
    GltfBuilder builder;
    builder.AddTriangle();
    builder.Add(bytes, type, "SCALAR", 3);
    const GltfResult result =
        ReadGltfText(builder.Mesh(R"({"attributes": {"POSITION": 0}, "indices": 1})"));
    ASSERT_EQ(result.error, "");
    EXPECT_LT(AreaVector(result.mesh()).z, 0);
  }
}

TEST(GltfData, Sparse) {
  GltfBuilder builder;
  const int base = builder.AddView(BytesOf(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}));
  const int indices = builder.AddView(BytesOf(std::vector<std::uint16_t>{2}));
  const int values = builder.AddView(BytesOf(std::vector<float>{0, 5, 6}));
  const auto accessor = [&](const std::string& view, const std::string& at) {
    return fmt::format(
        R"({}"componentType": 5126, "type": "VEC3", "count": 3, "sparse": {{"count": 1, "indices":
{{"bufferView": {}, "componentType": {}}}, "values": {{"bufferView": {}}}}})",
        view, indices, at, values);
  };
  builder.AddAccessor(accessor(fmt::format(R"("bufferView": {}, )", base), "5123"));
  builder.AddAccessor(accessor("", "5123"));
  builder.AddAccessor(accessor("", "5126"));
  GltfResult result = ReadGltfText(builder.Mesh(R"({"attributes": {"POSITION": 0}})"));
  ASSERT_EQ(result.error, "");
  EXPECT_EQ(result.mesh().positions.at(1), vec3(1, 0, 0));
  EXPECT_EQ(result.mesh().positions.at(2), vec3(0, 5, 6));
  result = ReadGltfText(builder.Mesh(R"({"attributes": {"POSITION": 1}})"));
  ASSERT_EQ(result.error, "");
  EXPECT_EQ(result.mesh().positions.at(1), vec3(0));
  EXPECT_EQ(result.mesh().positions.at(2), vec3(0, 5, 6));
  result = ReadGltfText(builder.Mesh(R"({"attributes": {"POSITION": 2}})"));
  EXPECT_EQ(result.error, "a.gltf: accessor 2: the sparse indices are not of a type for indices");
}

// Accessors of one triangle's view of 36 bytes that reach too far, or ask for too much.
TEST(GltfData, BoundsAreChecked) {
  const std::pair<const char*, const char*> cases[] = {
      {R"("bufferView": 0, "count": 4)", "beyond the 36 bytes of buffer view 0"},
      {R"("bufferView": 0, "byteOffset": 4, "count": 3)", "beyond the 36 bytes"},
      {R"("bufferView": 0, "byteOffset": 18446744073709551612, "count": 3)", "beyond the 36 bytes"},
      {R"("bufferView": 0, "count": 1537228672809129302)", "beyond the 36 bytes"},
      {R"("bufferView": 0, "count": 0)", "it has no elements"},
      {R"("bufferView": 7, "count": 3)", "there is no buffer view 7"},
      {R"("count": 4000000000)", "without a buffer view; the limit is 16,777,216"}};
  for (const auto& [members, message] : cases) {
    GltfBuilder builder;
    builder.AddView(std::string(36, '\0'));
    builder.AddAccessor(std::string(members) + R"(, "componentType": 5126, "type": "VEC3")");
    const GltfResult result = ReadGltfText(builder.Mesh(R"({"attributes": {"POSITION": 0}})"));
    EXPECT_NE(result.error.find(message), std::string::npos) << members << ": " << result.error;
  }
}

TEST(GltfData, TypesAreChecked) {
  GltfBuilder builder;
  builder.AddTriangle();
  builder.AddFloats({0, 0, 1, 0, 0, 1}, "VEC2", 3);
  builder.Add(std::string(72, '\0'), 5130, "VEC3", 3);
  for (const auto& [attributes, message] :
       {std::pair(R"("POSITION": 1)", "accessor 1: 3 numbers needed in each element"),
        {R"("POSITION": 2)", "accessor 2: its component type is not one of glTF's"},
        {R"("POSITION": 9)", "there is no accessor 9"},
        {R"("POSITION": -1)", "there is no accessor -1"},
        {R"("POSITION": 0, "NORMAL": 1)", "accessor 1: 3 numbers needed"}}) {
    const GltfResult result =
        ReadGltfText(builder.Mesh(fmt::format(R"({{"attributes": {{{}}}}})", attributes)));
    EXPECT_NE(result.error.find(message), std::string::npos) << result.error;
  }
  const GltfResult result =
      ReadGltfText(builder.Mesh(R"({"attributes": {"POSITION": 0}, "indices": 0})"));
  EXPECT_EQ(result.error, "a.gltf: accessor 0: indices must be unsigned integers");
}

}  // namespace
}  // namespace snell::io
