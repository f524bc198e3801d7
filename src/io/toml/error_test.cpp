// SPDX-License-Identifier: Apache-2.0
//
// What the TOML reader says about mistakes: the whole line, with its place.
#include <gtest/gtest.h>

#include "io/toml/test_scene.h"

namespace snell::io {
namespace {

struct Mistake {
  const char* text;   // of a scene file
  const char* error;  // its only error, without "scene.toml:"
};

// Each is the only error of its file.
template <std::size_t Count>
void ExpectMistakes(const Mistake (&mistakes)[Count]) {
  for (const Mistake& mistake : mistakes)
    EXPECT_EQ(TestScene(mistake.text).Errors(),
              std::vector<std::string>{std::string("scene.toml:") + mistake.error})
        << mistake.text;
}

const Mistake Keys[] = {
    {"[[object]]\nshape = \"sphere\"\nradios = 2",
     "3:1: unknown key 'radios' in [[object]] (sphere); did you mean 'radius'?"},
    {"  [[object]]\n  shape = \"sphere\"\n  position = [0, 0, 0]",
     "3:3: unknown key 'position' in [[object]] (sphere); did you mean 'center'?"},
    {"[[object]]\nshape = \"box\"\nradius = 2",
     "3:1: unknown key 'radius' in [[object]] (box); it belongs to shape \"sphere\", shape "
     "\"disk\", shape \"cylinder\" or shape \"cone\""},
    {"[[object]]\nshape = \"box\"\nqwertyuiop = 2",
     "3:1: unknown key 'qwertyuiop' in [[object]] (box)"},
    {"[[object]]\nshap = \"sphere\"",
     "2:1: unknown key 'shap' in [[object]]; did you mean 'shape'?"},
    {"[[object]]\nradius = 2", "1:1: missing key 'shape', 'file', 'mesh' or 'group' in [[object]]"},
    {"[[object]]\nshape = \"sphere\"\ngroup = \"a\"",
     "3:1: 'shape' and 'group' exclude each other in [[object]]"},
    {"[[object]]\nshape = \"triangle\"", "1:1: missing key 'vertices' in [[object]] (triangle)"},
    {"[[object]]\nshape = \"triangle\"\nvertexes = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]",
     "3:1: unknown key 'vertexes' in [[object]] (triangle); did you mean 'vertices'?"},
    {"[[light]]\ntype = \"directional\"\nintensity = 3",
     "3:1: unknown key 'intensity' in [[light]] (directional); did you mean 'irradiance'?"},
    {"[[light]]\ntype = \"sphere\"\nintensity = 3",
     "3:1: unknown key 'intensity' in [[light]] (sphere); did you mean 'radiance'?"},
    {"[[light]]\ncolor = 1",
     "1:1: missing key 'type' in [[light]]; choose one of \"ambient\", \"directional\", \"point\", "
     "\"spot\", \"rectangle\", \"triangle\", \"disk\", \"sphere\""},
    {"[[light]]\ntype = \"rectangle\"\ncorner = [0, 0, 0]\nedge_u = [1, 0, 0]",
     "1:1: missing key 'edge_v' in [[light]] (rectangle)"},
    {"[camera]\nlook_at = [0, 0, 0]\ndirection = [0, 0, -1]",
     "3:1: 'look_at' and 'direction' exclude each other in [camera] (pinhole)"},
    {"[[object]]\nshape = \"cylinder\"\nend = [0, 2, 0]",
     "3:1: unknown key 'end' in [[object]] (cylinder); did you mean 'top'?"},
    {"[[object]]\nmesh = \"bunny.ply\"",
     "2:8: 'mesh': expected a table with positions and faces, found a string; the key of mesh "
     "files is 'file'"},
    {"[[object]]\nmesh = { positions = [[0, 0, 0], [1, 1, 1], [2, 2, 2]], triangles = [[0, 1, 2]] "
     "}",
     "2:8: no face of the mesh has an area"},
    {"[camera]\nheight = 3",
     "2:1: unknown key 'height' in [camera] (pinhole); it belongs to type \"orthographic\""},
    {"[environment]\nbottom = 0\ncolor = 1",
     "3:1: 'bottom' and 'color' exclude each other in [environment]"},
    {"spp = 4", "1:1: unknown key 'spp' in the scene file; it belongs in [render]"},
    {"[lihgt]\ntype = \"point\"",
     "1:2: unknown key 'lihgt' in the scene file; did you mean 'light'?"},
    {"[[materials]]\nname = \"a\"",
     "1:3: unknown key 'materials' in the scene file; did you mean 'material'?"},
    {"[render]\nresolution = [3, 4]",
     "2:1: unknown key 'resolution' in [render]; did you mean 'size'?"},
    {"[group.tree]\nobjects = []",
     "2:1: unknown key 'objects' in [group.tree]; did you mean 'object'?"},
    {"[[group.tree.object]]\nshape = \"sphere\"\nradus = 1",
     "3:1: unknown key 'radus' in [[group.tree.object]] (sphere); did you mean 'radius'?"},
    {"[material.red]\ndiffuse = 0.5",
     "2:1: unknown key 'diffuse' in [material.red] (classic); it belongs to type \"phong\" or type "
     "\"blinn\""},
    {"[material.x]\ntype = \"mirror\"\nreflectivity = 1",
     "3:1: unknown key 'reflectivity' in [material.x] (mirror); did you mean 'color'?"},
    {"[material.x]\npreset = \"plastic\"\ntype = \"phong\"",
     "3:1: 'preset' and 'type' exclude each other in [material.x]"},
    {"[material.x]\nterms = [{ type = \"diffuse\", exponent = 3 }]",
     "2:30: unknown key 'exponent' in term (diffuse); it belongs to type \"phong\" or type "
     "\"blinn\""},
    {"[material.x]\nterms = [{ type = \"diffuse\" }, 5]",
     "2:32: 'terms': expected { type, color, … }, found 5"},
    {"[texture.a]\ntype = \"checker\"\noctaves = 3",
     "3:1: unknown key 'octaves' in [texture.a] (checker); it belongs to type \"marble\" or type "
     "\"wood\""},
    {"[texture.a]\ntype = \"wood\"\nscale = 2\ntransform = []",
     "4:1: 'scale' and 'transform' exclude each other in [texture.a] (wood)"},
    {"[[object]]\nshape = \"box\"\nrotate = { axis = \"x\" }",
     "3:10: missing key 'angle' in rotate"},
    {"[[object]]\nshape = \"box\"\ntransform = [{ scale = 2, translate = [0, 0, 0] }]",
     "3:27: 'scale' and 'translate' exclude each other in transform"},
    {"[[object]]\nshape = \"box\"\ntransform = [{}]",
     "3:14: missing key 'translate', 'rotate', 'scale', 'look_at' or 'matrix' in transform"},
    {"[[object]]\nmesh = { positions = [[0, 0, 0], [1, 0, 0], [0, 1, 0]] }",
     "2:8: missing key 'triangles' or 'polygons' in mesh"},
};
TEST(TomlErrors, AreReportedForKeys) { ExpectMistakes(Keys); }

const Mistake Values[] = {
    {"[[object]]\nshape = \"sphere\"\ncenter = \"middle\"",
     "3:10: 'center': expected 3 numbers, found a string"},
    {"[[object]]\nshape = \"sphere\"\ncenter = [1, 2]",
     "3:10: 'center': expected 3 numbers, found a list of 2"},
    {"[[object]]\nshape = \"sphere\"\ncenter = []",
     "3:10: 'center': expected 3 numbers, found an empty list"},
    {"[[object]]\nshape = \"sphere\"\ncenter = [1, true, 2]",
     "3:14: 'center': expected a number, found true"},
    {"[[object]]\nshape = \"sphere\"\nradius = 0",
     "3:10: 'radius': expected a number > 0, found 0"},
    {"[[object]]\nshape = \"sphere\"\nradius = nan",
     "3:10: 'radius': expected a number > 0, found nan"},
    {"[[object]]\nshape = \"sphere\"\nradius = 1e39",
     "3:10: 'radius': expected a number > 0, found 1e+39; numbers may be as large as 3.4e38"},
    {"[[object]]\nshape = \"sphere\"\nradius = 1e-60",
     "3:10: 'radius': expected a number > 0, found 1e-60; numbers may be as small as 1.2e-38"},
    {"[[object]]\nshape = \"sphere\"\ncenter = [0, -inf, 0]",
     "3:14: 'center': expected a number, found -inf"},
    {"[[object]]\nshape = \"sphree\"",
     "2:9: 'shape': unknown choice 'sphree'; did you mean 'sphere'?"},
    {"[[object]]\nshape = 7",
     "2:9: 'shape': expected one of \"sphere\", \"plane\", \"triangle\", \"rectangle\", \"disk\", "
     "\"box\", \"cylinder\", \"cone\", \"torus\", found 7"},
    {"[[object]]\nshape = \"sphere\"\ncasts_shadow = 1",
     "3:16: 'casts_shadow': expected true or false, found 1"},
    {"[[object]]\nshape = \"sphere\"\nname = 1979-05-27",
     "3:8: 'name': expected a string of at least one character, found a date or time"},
    {"[[object]]\nshape = \"plane\"\nnormal = [0, 0, 0]",
     "3:10: 'normal': expected 3 numbers, not all 0"},
    {"[[object]]\nshape = \"box\"\nscale = 0",
     "3:9: 'scale': expected a number or 3 numbers, none of them 0; a scale of 0 flattens all "
     "things"},
    {"[[object]]\nshape = \"box\"\nscale = [1, 0, 1]",
     "3:9: 'scale': expected a number or 3 numbers, none of them 0; a scale of 0 flattens all "
     "things"},
    {"[[object]]\nshape = \"box\"\nscale = 1e-20",
     "1:1: the transform of [[object]] (box) cannot be used: it scales by 1e-20; the limits are "
     "1e-15 and 1e+15"},
    {"[[object]]\nshape = \"box\"\nrotate = { axis = \"w\", angle = 3 }",
     "3:19: 'axis': unknown choice 'w'; choose one of \"x\", \"y\", \"z\""},
    {"[[object]]\nshape = \"box\"\nrotate = { axis = [0, 0, 0], angle = 3 }",
     "3:19: 'axis': expected \"x\", \"y\", \"z\" or 3 numbers, not all 0"},
    {"[[object]]\nshape = \"box\"\nrotate = 30",
     "3:10: 'rotate': expected { axis, angle } or a list of such, found 30"},
    {"[[object]]\nshape = \"box\"\ntransform = [{ matrix = [1, 2, 3] }]",
     "3:25: 'matrix': expected 12 or 16 numbers, row by row, found a list of 3"},
    {"[[object]]\nshape = \"box\"\ntransform = [{ matrix = [1,1,0,0, 1,1,0,0, 0,0,1,0] }]",
     "3:25: 'matrix': this matrix cannot be used: it flattens all things"},
    {"[[object]]\nshape = \"box\"\ntransform = [{ matrix = [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,1,1] }]",
     "3:25: 'matrix': this matrix cannot be used: the last row is not 0, 0, 0, 1"},
    {"[[object]]\nshape = \"box\"\ntransform = [{ look_at = { from = [1, 0, 0], to = [1, 0, 0] } "
     "}]",
     "3:51: 'to' is the same point as 'from' in look_at"},
    {"[[object]]\nshape = \"box\"\ntransform = [{ look_at = { from = [0, 0, 0], to = [0, 3, 0] } "
     "}]",
     "3:26: 'up' is parallel to the line of sight in look_at"},
    {"[render]\nsize = [0, 100]", "2:9: 'size': expected a whole number from 1 to 65536, found 0"},
    {"[render]\nspp = 1.5", "2:7: 'spp': expected a whole number from 1 to 1048576, found 1.5"},
    {"[render]\nseed = -1", "2:8: 'seed': expected a whole number from 0 to 4294967295, found -1"},
    {"[render]\nexposure = inf", "2:12: 'exposure': expected a number from -32 to 32, found inf"},
    {"[render]\nintegrator = \"bdpt\"",
     "2:14: 'integrator': unknown choice 'bdpt'; choose one of \"whitted\", \"path\""},
    {"[render]\nshadows = \"soft\"",
     "2:11: 'shadows': unknown choice 'soft'; choose one of \"tinted\", \"opaque\""},
    {"[camera]\nfov = 180", "2:7: 'fov': expected a number between 0 and 180, found 180"},
    {"[camera]\nposition = [0, 0, 0]",
     "2:12: the camera looks at its own position in [camera] (pinhole)"},
    {"[camera]\nposition = [0, 5, 0]",
     "1:1: 'up' is parallel to the line of sight in [camera] (pinhole); give another 'up', such as "
     "[0, 0, -1]"},
    {"[[camera]]\nname = \"a\"\n[[camera]]\nname = \"a\"", "4:8: two cameras have the name 'a'"},
    {"[environment]\ncolor = [0, -1, 0]", "2:13: 'color': expected a number >= 0, found -1"},
    {"[environment]\nsky = {}\ncolor = 1",
     "3:1: 'sky' and 'color' exclude each other in [environment]"},
    {"[environment]\nbottom_elevation = 30\ntop_elevation = 10",
     "3:17: 'bottom_elevation' is not less than 'top_elevation' in [environment]"},
    {"[material.x]\ntype = \"phong\"\ndiffuse = [1.5, 0, 0]",
     "3:12: 'diffuse': expected a number from 0 to 1, found 1.5"},
    {"[material.x]\ntype = \"phong\"\ndiffuse = \"#12345\"",
     "3:11: 'diffuse': '#12345' is no colour; colours are [r, g, b], one number or \"#rrggbb\""},
    {"[material.x]\ntype = \"phong\"\ndiffuse = \"#12345g\"",
     "3:11: 'diffuse': '#12345g' is no colour; colours are [r, g, b], one number or \"#rrggbb\""},
    {"[material.x]\ntype = \"phong\"\ndiffuse = true",
     "3:11: 'diffuse': expected a colour from 0 to 1 or a texture, found true; colours are [r, g, "
     "b], one number or \"#rrggbb\""},
    {"[material.x]\ntype = \"phong\"\ndiffuse = { texture = \"wood\", tint = 2 }",
     "3:38: 'tint': expected a number from 0 to 1, found 2"},
    {"[material.x]\nemission = -1", "2:12: 'emission': expected a number >= 0, found -1"},
    {"[[light]]\ntype = \"point\"\ncolor = \"checker\"",
     "3:9: 'color': 'checker' is no colour; colours are [r, g, b], one number or \"#rrggbb\""},
};
TEST(TomlErrors, AreReportedForValues) { ExpectMistakes(Values); }

const Mistake Shapes[] = {
    {"[[object]]\nshape = \"triangle\"\nvertices = [[0, 0, 0], [1, 0, 0], [2, 0, 0]]",
     "3:12: the triangle has no area in [[object]] (triangle)"},
    {"[[object]]\nshape = \"triangle\"\nvertices = [[0, 0, 0], [1, 0, 0]]",
     "3:12: 'vertices': expected a list of 3 points, found a list of 2"},
    {"[[object]]\nshape = \"cylinder\"\nbase = [0, 1, 0]",
     "3:8: 'base' and 'top' are the same point in [[object]] (cylinder)"},
    {"[[object]]\nshape = \"cone\"\nradius = 0",
     "3:10: 'radius' and 'top_radius' are both 0 in [[object]] (cone)"},
    {"[[object]]\nshape = \"box\"\nmin = [0, 0, 2]\nmax = [1, 1, 1]",
     "4:7: 'max' is not greater than 'min' along z in [[object]] (box)"},
    {"[[object]]\nshape = \"disk\"\ninner_radius = 1",
     "3:16: 'inner_radius' is not less than 'radius' (1) in [[object]] (disk)"},
    {"[[object]]\nshape = \"rectangle\"\nedge_v = [-2, 0, 0]",
     "3:10: 'edge_u' and 'edge_v' are parallel in [[object]] (rectangle)"},
    {"[[object]]\nshape = \"torus\"\nminor_radius = 2",
     "3:16: 'minor_radius' (2) is greater than 'major_radius' (1) in [[object]] (torus)"},
    {"[[light]]\ntype = \"spot\"\ninner_angle = 40",
     "3:15: 'inner_angle' is larger than 'outer_angle' (30) in [[light]] (spot)"},
    {"[[light]]\ntype = \"spot\"\nlook_at = [0, 0, 0]",
     "3:11: 'look_at' is the light's own position in [[light]] (spot)"},
    {"[[light]]\ntype = \"disk\"\nnormal = [0, 1, 0]\nlook_at = [0, 4, 0]",
     "4:1: 'normal' and 'look_at' exclude each other in [[light]] (disk)"},
    {"[[light]]\ntype = \"sphere\"\npower = 4\nradiance = 2",
     "4:1: 'power' and 'radiance' exclude each other in [[light]] (sphere)"},
    {"[[light]]\ntype = \"rectangle\"\ncorner = [0, 0, 0]\nedge_u = [1, 0, 0]\nedge_v = [2, 0, 0]",
     "5:10: 'edge_u' and 'edge_v' are parallel in [[light]] (rectangle)"},
    {"[[object]]\nmesh = { positions = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], triangles = [[0, 1, 3]] "
     "}",
     "2:77: 'triangles': there is no position 3; there are 3, counted from 0"},
    {"[[object]]\nmesh = { positions = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], triangles = [[0, 1, -1]] "
     "}",
     "2:77: 'triangles': expected a whole number from 0 to 2147483647, found -1"},
    {"[[object]]\nmesh = { positions = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], polygons = [[0, 1]] }",
     "2:69: 'polygons': expected a list of at least 3 indices, found a list of 2"},
    {"[[object]]\nmesh = { positions = [[0,0,0],[1,0,0],[0,1,0]], triangles = [[0,1,2]], normals = "
     "[[0,0,1]] }",
     "2:82: 'normals': expected one for each of the 3 positions, found 1"},
};
TEST(TomlErrors, AreReportedForShapes) { ExpectMistakes(Shapes); }

const Mistake Names[] = {
    {"[[object]]\nshape = \"sphere\"\nmaterial = \"glas\"",
     "3:12: unknown material 'glas'; did you mean 'glass'?"},
    {"[[object]]\nshape = \"sphere\"\nmaterial = \"velvet\"\n[material.velvety]",
     "3:12: unknown material 'velvet'; did you mean 'velvety'?"},
    {"[[object]]\nshape = \"sphere\"\nmaterial = 4",
     "3:12: 'material': expected the name of a material or a table, found 4"},
    {"[material.x]\npreset = \"plstic\"",
     "2:10: 'preset': unknown choice 'plstic'; did you mean 'plastic'?"},
    {"[material.x]\npreset = 3",
     "2:10: 'preset': expected one of \"glass\", \"water\", \"diamond\", \"mirror\", \"chrome\", "
     "\"gold\", \"plastic\", \"rubber\", found 3"},
    {"[material.x]\ntype = \"phong\"\ndiffuse = \"chekcer\"",
     "3:11: unknown texture 'chekcer'; did you mean 'checker'?"},
    {"[material.x]\ntype = \"phong\"\ndiffuse = \"red\"",
     "3:11: unknown texture 'red'; colours are [r, g, b], one number, \"#rrggbb\" or a texture's "
     "name"},
    {"[[object]]\ngroup = \"tree\"\n[group.trees]",
     "2:9: unknown group 'tree'; did you mean 'trees'?"},
    {"[[object]]\ngroup = \"a\"\n[[group.a.object]]\ngroup = \"b\"\n[[group.b.object]]\ngroup = "
     "\"a\"",
     "5:1: the group 'a' holds itself"},
    {"[[object]]\nfile = \"none.ply\"", "2:8: there is no file 'none.ply'"},
    {"[[object]]\nfile = \".\"", "2:8: '.' is not a file"},
    {"[object]\nshape = \"sphere\"",
     "1:1: there may be several of 'object': write [[object]] with double brackets"},
    {"[[render]]\nspp = 4", "1:1: there is only one 'render': write [render] with single brackets"},
    {"render = 3", "1:10: 'render': expected a table, found 3"},
    {"object = [1]", "1:11: 'object': expected tables, found 1"},
    {"[[material]]\ntype = \"phong\"",
     "1:1: 'material': expected tables by name, found a list of 1; write [material.NAME]"},
    {"[material]\ntype = \"phong\"",
     "2:8: 'type': expected a table, found a string; write [material.NAME]"},
    {"include = 3", "1:11: 'include': expected a file name or a list of file names, found 3"},
    {"[material.x\n", "1:12: syntax error in table header: expected ']', saw '\\n'"},
    {"[render]\nspp = 1\nspp = 2",
     "3:7: syntax error in key-value pair: cannot redefine existing integer 'spp'"},
    {"# é\n[\"\\u001b[31m\"]", "2:2: unknown key '?[31m' in the scene file"},
};
TEST(TomlErrors, AreReportedForNames) { ExpectMistakes(Names); }

TEST(TomlErrors, AreAllReportedInTheOrderOfTheFile) {
  TestScene scene(R"([[object]]
shape = "sphere"
radius = -1
material = "steel"

[material.a]
type = "phong"
diffuse = 2
shinines = 3

[render]
spp = 0
)");
  EXPECT_EQ(scene.Errors(),
            (std::vector<std::string>{
                "scene.toml:3:10: 'radius': expected a number > 0, found -1",
                "scene.toml:4:12: unknown material 'steel'",
                "scene.toml:8:11: 'diffuse': expected a number from 0 to 1, found 2",
                "scene.toml:9:1: unknown key 'shinines' in [material.a] (phong); did you mean "
                "'shininess'?",
                "scene.toml:12:7: 'spp': expected a whole number from 1 to 1048576, found 0"}));
}

TEST(TomlErrors, BeyondTwentyAreCounted) {
  std::string text;
  for (int i = 0; i < 30; ++i) text += "[[object]]\nshape = \"sphere\"\nradius = 0\n";
  const std::vector<std::string> errors = TestScene(text).Errors();
  ASSERT_EQ(errors.size(), 21u);
  EXPECT_EQ(errors[19], "scene.toml:60:10: 'radius': expected a number > 0, found 0");
  EXPECT_EQ(errors[20], "and 10 more");
}

TEST(TomlErrors, AMistakeInADefinitionIsNotReportedWhereItIsUsed) {
  TestScene scene(R"([[object]]
shape = "sphere"
material = "a"
[[object]]
group = "g"
[[group.g.object]]
shape = "box"
max = 3
[material.a]
type = "phong"
diffuse = "t"
[texture.t]
type = "chess"
)");
  EXPECT_EQ(scene.Errors().size(), 2u);
}

TEST(TomlErrors, LongNamesAreCutShort) {
  const std::string name(100'000, 'x');
  const std::vector<std::string> errors = TestScene("[render]\n" + name + " = 1").Errors();
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_LT(errors[0].size(), 150u);
}

TEST(TomlWarnings, NameWhatMayBeAMistake) {
  TestScene scene(R"([[object]]
shape = "rectangle"
material = "glass"
[[object]]
shape = "cylinder"
capped = false
material = "glass"
[[object]]
shape = "disk"
material = { preset = "glass", thin = true }
[[object]]
shape = "sphere"
material = "white"
[material.white]
type = "phong"
diffuse = 0.9
specular = 0.3
normalized = true
[material.dim]
preset = "glass"
attenuation_color = "#80ff80"
)");
  scene.Read();
  EXPECT_EQ(
      scene.warnings,
      (std::vector<std::string>{
          "scene.toml:1:1: the material 'glass' refracts, but this object has no inside; set 'thin "
          "= true' in the material, or use a closed shape",
          "scene.toml:4:1: the material 'glass' refracts, but this object has no inside; set 'thin "
          "= true' in the material, or use a closed shape",
          "scene.toml:14:1: the material 'white' gives back more light than it receives: its "
          "diffuse and normalized specular colours add up to 1.2; make the sum 1 or less",
          "scene.toml:21:21: 'attenuation_color' has no effect without 'attenuation_distance'"}));
}

TEST(TomlWarnings, DoNotNameReadyOrUnusedThings) {
  TestScene scene(
      "[material.unused]\ntype = \"phong\"\n[texture.unused]\ntype = \"wood\"\n[group.unused]\n");
  for (const char* preset :
       {"glass", "water", "diamond", "mirror", "chrome", "gold", "plastic", "rubber"})
    scene.Write("scene.toml",
                std::string("[[object]]\nshape = \"sphere\"\nmaterial = \"") + preset + "\"\n");
  scene.Read();
  EXPECT_TRUE(scene.warnings.empty());
}

}  // namespace
}  // namespace snell::io
