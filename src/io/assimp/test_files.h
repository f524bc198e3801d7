// SPDX-License-Identifier: Apache-2.0
//
// For the tests of the Assimp readers: a triangle of 1 m in each format.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace snell::io {

// In centimetres and with z up; two nodes that share it, a picture, a camera and a lamp.
inline const char* const TriangleDae = R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="centimeter" meter="0.01"/><up_axis>Z_UP</up_axis></asset>
<library_cameras><camera id="cam"><optics><technique_common><perspective><yfov>40</yfov><aspect_ratio>1.5</aspect_ratio><znear>1</znear><zfar>10</zfar></perspective></technique_common></optics></camera></library_cameras>
<library_lights><light id="lamp"><technique_common><point><color>1 0.5 0.25</color><quadratic_attenuation>0.5</quadratic_attenuation></point></technique_common></light></library_lights>
<library_images><image id="img"><init_from>red.png</init_from></image></library_images>
<library_effects><effect id="fx"><profile_COMMON>
<newparam sid="s"><surface type="2D"><init_from>img</init_from></surface></newparam>
<newparam sid="p"><sampler2D><source>s</source></sampler2D></newparam>
<technique sid="common"><phong><diffuse><texture texture="p" texcoord="UV"/></diffuse><specular><color>0.5 0.5 0.5 1</color></specular><shininess><float>20</float></shininess></phong></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="mat" name="Paint"><instance_effect url="#fx"/></material></library_materials>
<library_geometries><geometry id="geo" name="tri"><mesh>
<source id="pos"><float_array id="posa" count="9">0 0 0 100 0 0 0 0 100</float_array><technique_common><accessor source="#posa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<source id="uv"><float_array id="uva" count="6">0 0 1 0 0 1</float_array><technique_common><accessor source="#uva" count="3" stride="2"><param name="S" type="float"/><param name="T" type="float"/></accessor></technique_common></source>
<vertices id="vtx"><input semantic="POSITION" source="#pos"/></vertices>
<triangles count="1" material="m"><input semantic="VERTEX" source="#vtx" offset="0"/><input semantic="TEXCOORD" source="#uv" offset="1" set="0"/><p>0 0 1 1 2 2</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="vs">
<node id="a" name="left"><instance_geometry url="#geo"><bind_material><technique_common><instance_material symbol="m" target="#mat"/></technique_common></bind_material></instance_geometry></node>
<node id="b" name="right"><translate>200 0 0</translate><instance_geometry url="#geo"><bind_material><technique_common><instance_material symbol="m" target="#mat"/></technique_common></bind_material></instance_geometry></node>
<node id="c" name="eye"><translate>0 -500 0</translate><rotate>1 0 0 90</rotate><instance_camera url="#cam"/></node>
<node id="d" name="bulb"><translate>0 0 300</translate><instance_light url="#lamp"/></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#vs"/></scene></COLLADA>
)";

inline const char* const TriangleOff = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

inline const char* const TriangleAc = R"(AC3Db
MATERIAL "red" rgb 1 0 0 amb 0.2 0.2 0.2 emis 0 0 0 spec 0.5 0.5 0.5 shi 10 trans 0
OBJECT world
kids 1
OBJECT poly
name "t"
loc 0 1 0
numvert 3
0 0 0
1 0 0
0 1 0
numsurf 1
SURF 0x20
mat 0
refs 3
0 0 0
1 1 0
2 0 1
kids 0
)";

inline const char* const TriangleX = R"(xof 0303txt 0032
Mesh m {
 3;
 0;0;0;, 1;0;0;, 0;1;0;;
 1;
 3;0,1,2;;
 MeshMaterialList { 1; 1; 0;;
  Material green { 0;1;0;1;; 10; 0.2;0.2;0.2;; 0;0;0;; } }
}
)";

// In centimetres and with z up.
inline const char* const TriangleFbx = R"(; FBX 7.4.0 project file
FBXHeaderExtension:  {
	FBXHeaderVersion: 1003
	FBXVersion: 7400
}
GlobalSettings:  {
	Version: 1000
	Properties70:  {
		P: "UpAxis", "int", "Integer", "",2
		P: "UpAxisSign", "int", "Integer", "",1
		P: "FrontAxis", "int", "Integer", "",1
		P: "FrontAxisSign", "int", "Integer", "",-1
		P: "CoordAxis", "int", "Integer", "",0
		P: "CoordAxisSign", "int", "Integer", "",1
		P: "UnitScaleFactor", "double", "Number", "",1
	}
}
Definitions:  {
	Version: 100
	Count: 3
}
Objects:  {
	Geometry: 100, "Geometry::tri", "Mesh" {
		Vertices: *9 {
			a: 0,0,0,100,0,0,0,0,100
		}
		PolygonVertexIndex: *3 {
			a: 0,1,-3
		}
		GeometryVersion: 124
		LayerElementMaterial: 0 {
			Version: 101
			MappingInformationType: "AllSame"
			ReferenceInformationType: "IndexToDirect"
			Materials: *1 {
				a: 0
			}
		}
		Layer: 0 {
			Version: 100
			LayerElement:  {
				Type: "LayerElementMaterial"
				TypedIndex: 0
			}
		}
	}
	Model: 200, "Model::part", "Mesh" {
		Version: 232
		Properties70:  {
			P: "Lcl Translation", "Lcl Translation", "", "A",0,0,50
		}
	}
	Material: 300, "Material::blue", "" {
		Version: 102
		ShadingModel: "phong"
		Properties70:  {
			P: "DiffuseColor", "Color", "", "A",0,0,1
		}
	}
}
Connections:  {
	C: "OO",200,0
	C: "OO",100,200
	C: "OO",300,200
}
)";

// A chunk of a 3DS file.
inline std::string Chunk(std::uint16_t id, const std::string& body) {
  const std::uint32_t size = 6 + std::uint32_t(body.size());
  std::string chunk(6, '\0');
  std::memcpy(chunk.data(), &id, 2);
  std::memcpy(chunk.data() + 2, &size, 4);
  return chunk + body;
}

template <typename T>
std::string BytesOfAll(const std::vector<T>& numbers) {
  std::string bytes(numbers.size() * sizeof(T), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

// With z up, as all 3DS files.
inline std::string Triangle3ds() {
  using Words = std::vector<std::uint16_t>;
  const std::string name("red", 4);
  const std::string vertices =
      BytesOfAll(Words{3}) + BytesOfAll(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 0, 1});
  const std::string faces =
      BytesOfAll(Words{1, 0, 1, 2, 7}) + Chunk(0x4130, name + BytesOfAll(Words{1, 0}));
  const std::string object(
      Chunk(0x4000,
            std::string("tri", 4) + Chunk(0x4100, Chunk(0x4110, vertices) + Chunk(0x4120, faces))));
  const std::string material =
      Chunk(0xafff, Chunk(0xa000, name) + Chunk(0xa020, Chunk(0x0011, std::string("\xff\0\0", 3))));
  return Chunk(0x4d4d, Chunk(0x3d3d, material + object));
}

}  // namespace snell::io
