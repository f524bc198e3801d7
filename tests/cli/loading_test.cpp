// SPDX-License-Identifier: Apache-2.0
//
// The options of all commands that open scenes.
#include "scratch.h"

namespace snell::test {
namespace {

// A triangle; with an animation, it goes from x = 0 to x = 10 within a second.
std::string TriangleGltf(bool animated) {
  std::string text = R"({"asset": {"version": "2.0"},
"buffers": [{"byteLength": 68, "uri": "data:application/octet-stream;base64,)"
                     "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"
                     "AAAAAAAAgD8AAAAAAAAAAAAAAAAAACBBAAAAAAAAAAA="
                     R"("}],
"bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36},
  {"buffer": 0, "byteOffset": 36, "byteLength": 8}, {"buffer": 0, "byteOffset": 44, "byteLength": 24}],
"accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3},
  {"bufferView": 1, "componentType": 5126, "type": "SCALAR", "count": 2},
  {"bufferView": 2, "componentType": 5126, "type": "VEC3", "count": 2}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "nodes": [{"mesh": 0}])";
  if (animated)
    text += R"(, "animations": [{"samplers": [{"input": 1, "output": 2}],
  "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}])";
  return text + "}";
}

class Loading : public InScratchFolder {
 protected:
  Loading() {
    Write("moving.gltf", TriangleGltf(true));
    Write("still.gltf", TriangleGltf(false));
    Write("spheres.nff", SpheresScene());
  }
};

void ExpectHas(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in:\n" << text;
}

TEST_F(Loading, TimeMovesWhatAnimationsMove) {
  const Result rest = Run({"info", "moving.gltf"});
  ExpectHas(rest.out, "  bounds     0 0 0 to 1 1 0,");
  ExpectHas(rest.err, "animations are not played");
  const Result half = Run({"info", "moving.gltf", "--at", "0.5"});
  ExpectHas(half.out, "  bounds     5 0 0 to 6 1 0,");
  EXPECT_EQ(half.err, "");
  EXPECT_EQ(Run({"check", "moving.gltf", "--at", "3"}).out, "moving.gltf: ok\n");

  const auto render = [&](const char* picture, const char* time) {
    EXPECT_EQ(Run({"render", "moving.gltf", "-q", "--size", "32x24", "--spp", "1", "--at", time,
                   "-o", picture})
                  .status,
              0);
    return Read(picture);
  };
  EXPECT_EQ(render("a.png", "0"), render("b.png", "-1"));
}

TEST_F(Loading, TimeIsSaidToChangeNothingWithoutAnimations) {
  ExpectHas(Run({"check", "still.gltf", "--at", "1"}).err,
            "snell: warning: still.gltf: there are no animations: the time changes nothing\n");
  ExpectHas(Run({"check", "spheres.nff", "--at", "1"}).err,
            "snell: warning: spheres.nff: there are no animations: the time changes nothing\n");
  EXPECT_EQ(Run({"check", "still.gltf", "--at", "noon"}).status, 2);
}

TEST_F(Loading, AMapLightsAnyModel) {
  const std::string head = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n";
  Write("white.hdr", head + std::string("\x80\x80\x80\x81\x80\x80\x80\x81"));
  Write("red.hdr", head + std::string("\x80\x10\x10\x81\x80\x10\x10\x81"));
  const auto render = [&](const char* map) {
    EXPECT_EQ(Run({"render", "still.gltf", "-q", "--size", "16x12", "--spp", "1", "--environment",
                   map, "-o", "a.png"})
                  .status,
              0);
    return Read("a.png");
  };
  EXPECT_NE(render("white.hdr"), render("red.hdr"));
  const Result missing = Run({"check", "still.gltf", "--environment", "none.hdr"});
  EXPECT_EQ(missing.status, 1);
  ExpectHas(missing.err, "none.hdr");
}

TEST_F(Loading, FoldersOutsideMustBeAllowed) {
  std::filesystem::create_directories(folder_ / "scenes/parts");
  std::filesystem::create_directories(folder_ / "library");
  std::filesystem::create_directories(folder_ / "secret");
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  Write("library/a.obj", triangle);
  Write("secret/a.obj", triangle);
  std::filesystem::create_symlink(folder_ / "secret", folder_ / "library/link");
  std::filesystem::create_symlink(folder_ / "secret/a.obj", folder_ / "library/leaf.obj");
  const auto check = [&](const std::string& file, std::vector<std::string> options) {
    Write("scenes/parts/b.toml", "[[object]]\nfile = \"" + file + "\"\n");
    Write("scenes/a.toml", "[[object]]\nfile = \"parts/b.toml\"\n");
    options.insert(options.begin(), {"check", "scenes/a.toml"});
    return Run(options);
  };
  const Result refused = check("../../library/a.obj", {});
  EXPECT_EQ(refused.status, 1);
  ExpectHas(refused.err, "lies outside the scene's folder; files are read only from the scene's");
  ExpectHas(refused.err, "--allow FOLDER adds others");
  EXPECT_EQ(check(Path("library/a.obj"), {}).status, 1);

  EXPECT_EQ(check("../../library/a.obj", {"--allow", "library"}).status, 0);
  EXPECT_EQ(check(Path("library/a.obj"), {"--allow", Path("library") + "/"}).status, 0);
  EXPECT_EQ(check("../../secret/a.obj", {"--allow", "library"}).status, 1);
  EXPECT_EQ(check("../../secret/a.obj", {"--allow", "library", "--allow", "secret"}).status, 0);
  for (const char* way : {"../../library/link/a.obj", "../../library/leaf.obj",
                          "../../library/../secret/a.obj", "../../library2/a.obj"})
    EXPECT_EQ(check(way, {"--allow", "library"}).status, 1) << way;
  EXPECT_EQ(check("../../library/leaf.obj", {"--allow", "library", "--allow", "secret"}).status, 0);
  ExpectHas(check("x.obj", {"--allow", "none"}).err, "none: there is no such folder to read from");
}

TEST_F(Loading, LimitsCanBeSetAndErrorsNameThem) {
  Write("two.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n");
  const auto check = [&](const char* file, const char* limit) {
    return Run({"check", file, "--limit", limit});
  };
  EXPECT_EQ(check("two.obj", "triangles=2").status, 0);
  ExpectHas(check("two.obj", "triangles=1").err,
            "the file has 2 triangles; the limit is 1; --limit triangles=N raises the limit");
  ExpectHas(check("two.obj", "file-bytes=9").err, "--limit file-bytes=N raises the limit");
  ExpectHas(check("still.gltf", "triangles=1").out, "ok");
  ExpectHas(check("still.gltf", "numbers=8").err, "--limit numbers=N raises the limit");
  ExpectHas(check("still.gltf", "json-bytes=8").err, "--limit json-bytes=N raises the limit");
  Write("a.toml", "[[object]]\nfile = \"still.gltf\"\n[[object]]\nshape = \"box\"\n");
  ExpectHas(check("a.toml", "objects=1").err, "--limit objects=N raises the limit");
  ExpectHas(check("a.toml", "toml-bytes=20").err, "--limit toml-bytes=N raises the limit");
  EXPECT_EQ(Run({"check", "a.toml", "--limit", "objects=1K", "--limit", "toml-bytes=1M"}).status,
            0);

  ExpectHas(check("a.toml", "objekts=1").err, "--limit must be NAME=N, where NAME is file-bytes, ");
  for (const char* bad : {"objects", "objects=", "objects=0", "objects=-1", "objects=1X",
                          "objects=9999999T", "objects=99999999999999999999", "objects=K"})
    EXPECT_EQ(check("a.toml", bad).status, 2) << bad;
}

}  // namespace
}  // namespace snell::test
