// SPDX-License-Identifier: Apache-2.0
//
// Scenes of several files: includes, meshes, confinement; and files that are made to do harm.
#include <gtest/gtest.h>

#include "io/toml/limits.h"
#include "io/toml/test_scene.h"

namespace snell::io {
namespace {

using Lines = std::vector<std::string>;

const char* const Triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST(TomlIncludes, AddTheirTables) {
  TestScene scene(R"(include = ["parts/a.toml", "b.toml"]
[[object]]
shape = "sphere"
material = "red"
)");
  scene.Write("parts/a.toml",
              "include = \"c.toml\"\n[[object]]\nfile = \"t.obj\"\n[texture.t]\ntype = \"wood\"\n");
  scene.Write("parts/c.toml",
              "[material.red]\ntype = \"diffuse\"\ncolor = \"t\"\n[[light]]\ntype = \"point\"\n");
  scene.Write("b.toml", "[[object]]\nfile = \"parts/t.obj\"\n[[light]]\ntype = \"ambient\"\n");
  scene.Write("parts/t.obj", Triangle);
  const scene::Scene read = scene.Read();
  EXPECT_EQ(read.objects.size(), 3u);
  EXPECT_EQ(read.lights.size(), 2u);
  EXPECT_EQ(read.meshes.size(), 1u);
  EXPECT_EQ(read.materials.at(0).name, "red");
  EXPECT_EQ(read.materials.at(0).terms.at(0).color.texture, 0);
}

TEST(TomlIncludes, GiveWayToTheFileThatNamesThem) {
  TestScene scene("include = \"base.toml\"\n[render]\nspp = 4\n[camera]\ndirection = [0, 0, -1]\n");
  scene.Write("base.toml",
              "[render]\nspp = 64\nmax_depth = 3\n[camera]\nlook_at = [5, 5, 5]\nfov = "
              "20\n[environment]\ncolor = 1\n");
  const scene::Scene read = scene.Read();
  EXPECT_EQ(read.settings.spp, 4);
  EXPECT_EQ(read.settings.maxDepth, 3);
  ASSERT_EQ(read.cameras.size(), 1u);
  EXPECT_EQ(read.cameras[0].lookAt, scene::vec3(0, 0, 0));
  EXPECT_NEAR(read.cameras[0].fov, 0.349066f, 1e-6);
  EXPECT_EQ(read.environment.top, scene::vec3(1.0f));
}

TEST(TomlIncludes, AddCamerasOfLists) {
  TestScene scene("include = \"more.toml\"\n[[camera]]\nname = \"a\"\n");
  scene.Write("more.toml", "[[camera]]\nname = \"b\"\n[[camera]]\nname = \"c\"\n");
  const scene::Scene read = scene.Read();
  ASSERT_EQ(read.cameras.size(), 3u);
  EXPECT_EQ(read.cameras[0].name, "a");
  EXPECT_EQ(read.cameras[2].name, "c");
}

TEST(TomlIncludes, CountOnceByWhateverWay) {
  TestScene scene("include = [\"a.toml\", \"b.toml\", \"sub/../a.toml\"]\n");
  scene.Write("a.toml", "include = \"sub/shared.toml\"\n[material.a]\n");
  scene.Write("b.toml", "include = \"sub/shared.toml\"\n");
  scene.Write("sub/shared.toml", "[material.shared]\n[[object]]\nshape = \"box\"\n");
  const scene::Scene read = scene.Read();
  EXPECT_EQ(read.objects.size(), 1u);
}

TEST(TomlIncludes, MayNotDefineANameAgain) {
  TestScene scene("include = \"b.toml\"\n[material.red]\n");
  scene.Write("b.toml", "\n[material.red]\n[texture.red]\ntype = \"wood\"\n");
  EXPECT_EQ(scene.Errors(),
            Lines{"b.toml:2:11: [material.red] is defined twice; the first is at scene.toml:2:11"});
}

TEST(TomlIncludes, MayNotGoInCircles) {
  TestScene scene("include = \"a.toml\"\n");
  scene.Write("a.toml", "include = \"sub/b.toml\"\n");
  scene.Write("sub/b.toml", "x = 1\ninclude = \"../a.toml\"\n");
  EXPECT_EQ(scene.Errors(),
            (Lines{"sub/b.toml:1:1: unknown key 'x' in the scene file",
                   "sub/b.toml:2:11: '../a.toml' includes itself; through b.toml"}));
  EXPECT_EQ(TestScene("include = \"scene.toml\"\n").Errors(),
            Lines{"scene.toml:1:11: 'scene.toml' includes itself"});
}

TEST(TomlIncludes, MayNotBeNestedWithoutEnd) {
  TestScene scene("include = \"1.toml\"\n");
  for (int i = 1; i < 40; ++i)
    scene.Write(std::to_string(i) + ".toml", "include = \"" + std::to_string(i + 1) + ".toml\"\n");
  scene.Write("40.toml", "");
  EXPECT_EQ(scene.Errors(), Lines{"16.toml:1:11: files are included more than 16 deep"});
}

TEST(TomlIncludes, ReportTheirMistakesBehindThoseOfTheFile) {
  TestScene scene(
      "include = [\"none.toml\", \"bad.toml\", \"syntax.toml\"]\n[[object]]\nmaterial = "
      "\"unknown\"\nshape = 1\n");
  scene.Write("bad.toml", "[render]\nspp = -2\n");
  scene.Write("syntax.toml", "[render]\nspp = = 2\n");
  // Unknown names are not reported, as the files that are missing may define them
  EXPECT_EQ(scene.Errors(),
            (Lines{"scene.toml:1:12: there is no file 'none.toml'",
                   "scene.toml:4:9: 'shape': expected one of \"sphere\", \"plane\", \"triangle\", "
                   "\"rectangle\", \"disk\", \"box\", \"cylinder\", \"cone\", \"torus\", found 1",
                   "bad.toml:2:7: 'spp': expected a whole number from 1 to 1048576, found -2",
                   "syntax.toml:2:7: syntax error in value: could not determine value type"}));
}

TEST(TomlFiles, StayInTheFolderOfTheScene) {
  const std::string hint =
      "; files are read only from the scene's own folder and the folders in it; --allow "
      "FOLDER adds others";
  EXPECT_EQ(TestScene("include = \"../x.toml\"\n").Errors(),
            Lines{"scene.toml:1:11: '../x.toml' lies outside the scene's folder" + hint});
  EXPECT_EQ(TestScene("include = \"/etc/passwd\"\n").Errors(),
            Lines{"scene.toml:1:11: '/etc/passwd' is an absolute path" + hint});
  EXPECT_EQ(TestScene("[[object]]\nfile = '..\\..\\bunny.ply'\n").Errors(),
            Lines{"scene.toml:2:8: '..\\..\\bunny.ply' lies outside the scene's folder" + hint});
  EXPECT_EQ(TestScene("[[object]]\nfile = 'C:\\bunny.ply'\n").Errors(),
            Lines{"scene.toml:2:8: 'C:\\bunny.ply' is an absolute path" + hint});

  TestScene outside;
  outside.Write("secret.toml", "[render]\n");
  TestScene scene("include = \"link/secret.toml\"\n");
  std::filesystem::create_directory_symlink(outside.folder(), scene.folder() / "link");
  EXPECT_EQ(scene.Errors(),
            Lines{"scene.toml:1:11: 'link/secret.toml' lies outside the scene's folder" + hint});
}

TEST(TomlFiles, AreRelativeToTheFileThatNamesThem) {
  TestScene scene("include = \"sub/a.toml\"\n");
  scene.Write("sub/a.toml", "[[object]]\nfile = \"../t.obj\"\n").Write("t.obj", Triangle);
  EXPECT_EQ(scene.Read().meshes.size(), 1u);
}

TEST(TomlFiles, WithMeshesAreLoadedOnceAndShared) {
  TestScene scene(R"([[object]]
file = "t.obj"
[[object]]
file = "./t.obj"
translate = [1, 0, 0]
[[object]]
file = "t.obj"
smooth = 0
)");
  scene.Write("t.obj", Triangle);
  const scene::Scene read = scene.Read();
  const auto mesh = [&](std::size_t i) {
    return std::get<scene::MeshGeometry>(read.objects.at(i).geometry).mesh;
  };
  EXPECT_EQ(read.meshes.size(), 2u);
  EXPECT_EQ(mesh(0), mesh(1));
  EXPECT_NE(mesh(0), mesh(2));
}

TEST(TomlFiles, WithBadMeshesAreReportedWhereTheyAreNamed) {
  TestScene scene("[[object]]\nfile = \"empty.obj\"\n[[object]]\nfile = \"none.obj\"\n");
  scene.Write("empty.obj", "# nothing\n");
  EXPECT_EQ(scene.Errors(), Lines{"scene.toml:4:8: there is no file 'none.obj'"});
  scene.Write("none.obj", Triangle);
  const Lines errors = scene.Errors();
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].find("scene.toml:2:8: cannot use the mesh empty.obj"), 0u) << errors[0];
}

TEST(TomlFiles, ThatDoNotExistAreNamed) {
  TestScene scene;
  const Lines errors = scene.Errors();
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0], "scene.toml: cannot read the file: No such file or directory");
}

// --- Files that are made to do harm

std::string Repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

TEST(TomlLimits, HoldForNesting) {
  const std::string keys = "scene.toml:1:32: a dotted key has more than 16 parts";
  EXPECT_EQ(TestScene(Repeated("a.", 500'000) + "a = 1").Errors(), Lines{keys});
  EXPECT_EQ(TestScene("[" + Repeated("a.", 500'000) + "a]").Errors().size(), 1u);
  EXPECT_EQ(TestScene(Repeated("\"=\" . ", 500'000) + "a = 1").Errors().size(), 1u);
  EXPECT_EQ(TestScene("a = " + Repeated("[", 500'000)).Errors(),
            Lines{"scene.toml:1:37: lists and tables are nested more than 32 deep"});
  EXPECT_EQ(TestScene("a = " + Repeated("{ a = ", 500'000)).Errors().size(), 1u);
  EXPECT_EQ(
      TestScene("a = \"\"\"\n\"[[[\"\"\"\n" + Repeated("b.", 500'000) + "a = 1").Errors().size(),
      1u);
  // The deepest that is let through
  const std::string part = Repeated("a.", 15) + "a";
  EXPECT_EQ(TestScene(part + " = " + Repeated("{ " + part + " = ", 30) + "1" + Repeated(" }", 30))
                .Errors()
                .size(),
            1u);
}

TEST(TomlLimits, DoNotMistakeTextForKeys) {
  const std::string dots(1000, '.');
  const std::string brackets(1000, '[');
  EXPECT_TRUE(TestScene("# " + dots + brackets + "\n[camera]\nname = \"" + dots + brackets + "\"\n")
                  .Errors()
                  .empty());
  EXPECT_TRUE(
      TestScene("[camera]\nname = '''\n" + dots + "''" + brackets + "'''\n").Errors().empty());
}

TEST(TomlLimits, HoldForTheParsersSearches) {
  std::string text;
  for (int i = 0; i < 200'000; ++i) text += "[a." + std::to_string(i) + ".b]\n";
  const Lines errors = TestScene(text).Errors();
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_NE(errors[0].find("dotted keys and headers"), std::string::npos) << errors[0];
}

TEST(TomlLimits, LetLargeScenesPass) {
  std::string objects;
  for (int i = 0; i < 20'000; ++i)
    objects += "[[group.g.object]]\nshape = \"sphere\"\ncenter = [1.5, 2.5, 3.5]\n";
  EXPECT_EQ(TestScene(objects + "[[object]]\ngroup = \"g\"\n").Read().objects.size(), 20'000u);
  std::string mesh = "[[object]]\nmesh = { positions = [[0, 0, 0], [1, 0, 0]";
  for (int i = 0; i < 50'000; ++i) mesh += ", [0.5, 1.25, 2.125]";
  mesh += "], triangles = [[0, 1, 2]], smooth = 0 }\n";
  EXPECT_EQ(TestScene(mesh).Read().meshes.at(0).positions.size(), 50'002u);
}

TEST(TomlLimits, HoldForBytesThatAreNoText) {
  std::string bytes;
  unsigned state = 1;
  for (int i = 0; i < 2000; ++i) {
    bytes += char((state = state * 1664525u + 1013904223u) >> 24);
    if (i % 100 == 0) {
      EXPECT_LE(TestScene(bytes).Errors().size(), 1u);
    }
  }
  EXPECT_EQ(TestScene(std::string("[render]\n\0spp = 1\n", 17)).Errors().size(), 1u);
}

TEST(TomlDeformation, MistakesHavePlaces) {
  const std::string object = "[[object]]\nfile = \"a.obj\"\n";
  const std::string inlined =
      "[[object]]\nmesh = { positions = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], triangles = [[0, 1, 2]] "
      "}\n";
  const std::pair<std::string, std::string> cases[] = {
      {object + "deformation = [{ time = 0 }, { time = 0, file = \"b.obj\" }]\n",
       "scene.toml:3:15: the times of 'deformation' do not rise in [[object]] (file)"},
      {object + "deformation = [{ time = 0 }, { time = 1, file = \"b.obj\" }]\n",
       "scene.toml:2:8: cannot use the mesh b.obj: its shape is no other one of 'a.obj': it has 4 "
       "vertices and 1 face, that one 3 and 1; files of one mesh have the same faces in the same "
       "order"},
      {object +
           "deformation = [{ time = 0 }, { time = 1, positions = [[0, 0, 0], [1, 0, 0], [0, 1, "
           "0]] }]\n",
       "scene.toml:3:15: 'deformation': 'positions' are for meshes that are written in the scene"},
      {inlined + "deformation = [{ time = 0 }, { time = 1, file = \"a.obj\" }]\n",
       "scene.toml:3:15: 'deformation': a 'file' is for objects that are files"},
      {inlined +
           "deformation = [{ time = 0 }, { time = 1, positions = [[0, 0, 0], [1, 0, 0], [0, 1, "
           "0], [1, 1, 1]] }]\n",
       "scene.toml:3:15: 'deformation': expected one for each of the 3 positions, found 4"}};
  for (const auto& [text, error] : cases) {
    TestScene scene(text);
    scene.Write("a.obj", Triangle);
    scene.Write("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\n");
    EXPECT_EQ(scene.Errors(), Lines{error});
  }
}

}  // namespace
}  // namespace snell::io
