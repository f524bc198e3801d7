// SPDX-License-Identifier: Apache-2.0
//
// glTF documents: containers, buffers and their URIs, versions, extensions, what is malformed.
#include <gtest/gtest.h>

#include <fstream>

#include "io/gltf/test_files.h"
#include "io/gltf/uri.h"
#include "io/read_scene.h"

namespace snell::io {
namespace {

namespace fs = std::filesystem;

std::string Triangle() {
  GltfBuilder builder;
  builder.AddTriangle();
  return builder.Mesh(R"({"attributes": {"POSITION": 0}})");
}

// The same with the buffer in a place of its own.
std::string TriangleAt(const std::string& uri) {
  return fmt::format(R"({{"asset": {{"version": "2.0"}}, "buffers": [{{"byteLength": 36{}}}],
"bufferViews": [{{"buffer": 0, "byteLength": 36}}],
"accessors": [{{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3}}],
"nodes": [{{"mesh": 0}}], "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}}}]}}]}})",
                     uri.empty() ? "" : fmt::format(R"(, "uri": "{}")", uri));
}

std::string TriangleBytes() { return BytesOf(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}); }

TEST(GltfDocument, DataUrisGlbAndFilesBeside) {
  EXPECT_EQ(ReadGltfText(Triangle()).error, "");
  EXPECT_EQ(ReadGltfText("\xef\xbb\xbf" + Triangle()).error, "");
  const GltfResult glb = ReadGltfText(Glb(TriangleAt(""), TriangleBytes()), {}, "a.glb");
  EXPECT_EQ(glb.error, "");
  EXPECT_EQ(glb.mesh().triangles.size(), 1u);

  const TemporaryFile file("a.gltf", TriangleAt("my%20data.bin"));
  std::ofstream(file.path().parent_path() / "my data.bin", std::ios::binary) << TriangleBytes();
  const GltfResult beside = ReadGltfFile(file.path());
  EXPECT_EQ(beside.error, "");
  EXPECT_EQ(beside.mesh().positions.at(1), scene::vec3(1, 0, 0));
}

TEST(GltfDocument, NothingOutsideOfTheFolderIsRead) {
  const TemporaryFile outside("secret.bin", TriangleBytes());
  const TemporaryFile file("a.gltf", "");
  const fs::path folder = file.path().parent_path();
  fs::create_symlink(outside.path(), folder / "link.bin");
  const std::string relative =
      "../" + outside.path().parent_path().filename().string() + "/secret.bin";
  for (const std::string& uri :
       {relative, outside.path().string(), std::string("link.bin"), "x/../" + relative,
        "..%2F" + relative.substr(3), "file://" + outside.path().string(),
        std::string("https://example.com/a.bin")}) {
    std::ofstream(file.path(), std::ios::binary) << TriangleAt(uri);
    const GltfResult result = ReadGltfFile(file.path());
    EXPECT_NE(result.error.find("folder"), std::string::npos) << uri << ": " << result.error;
  }
}

TEST(GltfDocument, UrisAreDecoded) {
  EXPECT_EQ(DecodePercent("a%20b%2fc%"), "a b/c%");
  EXPECT_EQ(DecodePercent("%zz%4"), "%zz%4");
  EXPECT_EQ(DecodeDataUri("data:,a%20b"), "a b");
  EXPECT_EQ(DecodeDataUri("data:text/plain;base64,AAEC/w=="), std::string("\0\1\2\xff", 4));
  EXPECT_EQ(DecodeDataUri("DATA:;base64,AAEC"), std::string("\0\1\2", 3));
  EXPECT_THROW(DecodeDataUri("data:;base64,A*=="), Error);
  EXPECT_THROW(DecodeDataUri("data:nocomma"), Error);
}

TEST(GltfDocument, MistakesHaveAPlaceAndACause) {
  const std::pair<std::string, std::string> cases[] = {
      {"", "a.gltf: the file is empty"},
      {"hello", "a.gltf:1:1: the JSON is malformed here or just before"},
      {"{\"asset\":\n {\"version\" 2}}", "a.gltf:2:13: the JSON is malformed here or just before"},
      {"[]", "a.gltf: the JSON is no object"},
      {"{}", "a.gltf: there is no 'asset', which every glTF document has"},
      {R"({"asset": {"version": "1.0"}})", "a.gltf: this is glTF 1.0; Snell reads glTF 2.0"},
      {R"({"asset": {"version": "2.0", "minVersion": "2.1"}})",
       "a.gltf: this is glTF 2.1; Snell reads glTF 2.0"},
      {R"({"asset": {"version": "2.0"}, "meshes": 7})", "a.gltf: 'meshes' is not an array"},
      {TriangleAt("none.bin"),
       "a.gltf: buffer 0: none.bin: cannot read the file: No such file or directory"},
      {TriangleAt("data:;base64,AAAA"),
       "a.gltf: buffer view 0: it reaches beyond the 3 bytes of buffer 0"},
      {R"({"asset": {"version": "2.0"}, "extensionsRequired": ["ACME_magic"]})",
       "a.gltf: the file requires the extension 'ACME_magic', which Snell does not have"}};
  for (const auto& [text, error] : cases) EXPECT_EQ(ReadGltfText(text).error, error) << text;
}

TEST(GltfDocument, UnknownExtensionsAreIgnoredWithAWarning) {
  GltfBuilder builder;
  builder.AddTriangle();
  const GltfResult result =
      ReadGltfText(builder.Mesh(R"({"attributes": {"POSITION": 0}})",
                                R"(, "extensionsUsed": ["ACME_magic", "KHR_materials_ior"])"));
  EXPECT_EQ(result.error, "");
  EXPECT_EQ(result.warnings, "the extension 'ACME_magic' is ignored\n");
}

TEST(GltfDocument, DeepNestingIsRefused) {
  const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');
  EXPECT_EQ(
      ReadGltfText(R"({"asset": {"version": "2.0"}, "extensions": {"a": )" + deep + "}}").error,
      "a.gltf: the JSON is nested more than 64 levels deep");
}

TEST(GltfDocument, EveryCutAndManyFlippedBytesAreSurvived) {
  GltfBuilder builder;
  builder.AddTriangle();
  builder.Add(BytesOf(std::vector<std::uint16_t>{0, 1, 2}), UnsignedShort, "SCALAR", 3);
  const std::string text =
      builder.Mesh(R"({"attributes": {"POSITION": 0}, "indices": 1, "material": 0})",
                   R"(, "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
"textures": [{"source": 0}], "images": [{"bufferView": 0}], "scene": 0, "scenes": [{"nodes": [0]}])");
  int sound = 0;
  const auto check = [&](const std::string& bytes, const char* name) {
    const GltfResult result = ReadGltfText(bytes, {}, name);
    if (!result.error.empty()) return;
    ++sound;
    for (const scene::Mesh& mesh : result.scene.meshes) EXPECT_TRUE(IsSound(mesh)) << bytes;
  };
  const std::string glb = Glb(text, "");
  for (std::size_t i = 0; i < text.size(); ++i) {
    check(text.substr(0, i), "a.gltf");
    for (const int change : {1, 2, 8, 32}) {
      std::string changed = text;
      changed[i] = char(changed[i] ^ change);
      check(changed, "a.gltf");
    }
  }
  for (std::size_t i = 0; i < 20; ++i) {
    check(glb.substr(0, i), "a.glb");
    for (int bit = 0; bit < 8; ++bit) {
      std::string changed = glb;
      changed[i] = char(changed[i] ^ 1 << bit);
      check(changed, "a.glb");
    }
  }
  EXPECT_GT(sound, 0);
}

TEST(GltfDocument, ScenesWithoutLightsGetTheStudio) {
  const TemporaryFile file("a.gltf", Triangle());
  const scene::Scene scene = ReadScene(file.path(), {}, nullptr);
  EXPECT_GT(scene.lights.size(), 1u);
  EXPECT_TRUE(scene.cameras.empty());
  EXPECT_EQ(scene.objects.size(), 2u);
}

}  // namespace
}  // namespace snell::io
