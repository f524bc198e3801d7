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
  const Result half = Run({"info", "moving.gltf", "--time", "0.5"});
  ExpectHas(half.out, "  bounds     5 0 0 to 6 1 0,");
  EXPECT_EQ(half.err, "");
  EXPECT_EQ(Run({"check", "moving.gltf", "--time", "3"}).out, "moving.gltf: ok\n");

  const auto render = [&](const char* picture, const char* time) {
    EXPECT_EQ(Run({"render", "moving.gltf", "-q", "--size", "32x24", "--spp", "1", "--time", time,
                   "-o", picture})
                  .status,
              0);
    return Read(picture);
  };
  EXPECT_EQ(render("a.png", "0"), render("b.png", "-1"));
}

TEST_F(Loading, TimeIsSaidToChangeNothingWithoutAnimations) {
  ExpectHas(Run({"check", "still.gltf", "--time", "1"}).err,
            "snell: warning: still.gltf: there are no animations: the time changes nothing\n");
  ExpectHas(Run({"check", "spheres.nff", "--time", "1"}).err,
            "snell: warning: spheres.nff: there are no animations: the time changes nothing\n");
  EXPECT_EQ(Run({"check", "still.gltf", "--time", "noon"}).status, 2);
}

}  // namespace
}  // namespace snell::test
