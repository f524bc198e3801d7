// SPDX-License-Identifier: Apache-2.0
//
// The scene language: one Section per table (toml_table.h), and the drafts that they fill. A draft is a
// scene record together with what a file may say in other words: a target for a direction, a power for a
// radiance. The functions that turn drafts into records stand beside the sections.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/mesh/read_mesh.h"
#include "io/toml/table.h"
#include "scene/scene.h"
#include "scene/sky/sky.h"

namespace snell::io {

using scene::Affine;

// --- Transforms (toml_section_transform.cpp) ----------------------------------------------------------------

// `scale`, `rotate` and `translate`, or `transform`; the parts that are not given are 1.
struct Placement {
  Affine scale{1.0};
  Affine rotate{1.0};
  Affine translate{1.0};
  Affine steps{1.0};

  Affine Matrix() const { return steps * translate * rotate * scale; }
};

struct Rotation {
  glm::dvec3 axis{0, 1, 0};  // not zero
  double degrees = 0;        // counter-clockwise for who looks against the axis
};

struct LookAt {
  vec3 from{0.0f};
  vec3 to{0, 0, 1};
  vec3 up{0, 1, 0};
};

// One of a list of transforms.
struct TransformStep {
  Affine map{1.0};
};

const SectionOf<Rotation>& RotationSection();
const SectionOf<LookAt>& LookAtSection();
const SectionOf<TransformStep>& TransformStepSection();
Keys<Placement> PlacementKeys();
inline const std::vector<std::vector<std::string>> PlacementSides = {
    {"transform"}, {"scale", "rotate", "translate"}};

// Whether two edges span no parallelogram worth the name.
bool HaveNoArea(const vec3& u, const vec3& v);

// Whether the map can be inverted in single precision and is finite; else `reason` says why not.
bool IsUsable(const Affine& map, std::string& reason);

// A file in the scene's folder (toml_section_object.cpp).
Type<std::filesystem::path> SceneFile(std::string example);

// --- Motion (toml_section_motion.cpp) -----------------------------------------------------------------------

// Where an object is at a moment; what is not given is as in its table.
struct MotionKeyDraft {
  float time = 0;
  Placement placement;
  bool hasScale = false;
  bool hasRotation = false;
  bool hasTranslation = false;
  bool hasSteps = false;
};

struct CameraKeyDraft {
  float time = 0;
  std::optional<vec3> position;
  std::optional<vec3> lookAt;
  std::optional<vec3> direction;
  std::optional<vec3> up;
};

struct CameraDraft;
struct ObjectDraft;
const SectionOf<MotionKeyDraft>& MotionKeySection();
const SectionOf<CameraKeyDraft>& CameraKeySection();
KeyOf<ObjectDraft> MotionKeyOfObjects();
Keys<CameraDraft> CameraMotionKeys();

// Turn the drafts' keys into motion, when all else of the tables is known.
void FinishMotion(Reader& reader, const Fields& fields, ObjectDraft& draft);
void FinishCameraMotion(Reader& reader, const Fields& fields, CameraDraft& draft);

// --- Deformation (section_deformation.cpp) -------------------------------------------------------------------

// The shape of a mesh at a moment; what is not given is the object's own.
struct ShapeKeyDraft {
  float time = 0;
  std::filesystem::path file;
  std::vector<vec3> positions;
};

const SectionOf<ShapeKeyDraft>& ShapeKeySection();
// `later` is an example of a key's shape.
KeyOf<ObjectDraft> DeformationKey(const std::string& later);

// The shapes of an object that is a file or a mesh. They report mistakes and then give none.
std::vector<MeshShape> ShapesOfFile(Reader& reader, const Fields& fields, const ObjectDraft& draft);
void AddInlineKeys(Reader& reader, const Fields& fields, const ObjectDraft& draft,
                   std::vector<scene::MeshKey>& keys);

// --- Textures and materials (toml_section_texture.cpp, toml_section_material.cpp, toml_materials.cpp) -------

struct TextureDraft {
  scene::Texture texture;
  Placement placement;
  std::filesystem::path file;  // of a picture
  bool data = false;           // its numbers are no colours
};

struct Tint {
  scene::TextureIndex texture = -1;
  Spectrum color{1.0f};
};

struct MaterialDraft {
  scene::Material material;
  std::string preset;
  ColorInput color{Spectrum(1.0f)};
  std::optional<ColorInput> ambient;
  ColorInput diffuse{Spectrum(0.8f)};
  ColorInput specular{Spectrum(0.0f)};
  float shininess = 32;
  bool normalized = false;
  scene::OpenPbr physical;
  scene::Medium volume;
  std::filesystem::path gridFile;
  std::string gridName;
  // Of physical ones
  std::string metal;
  std::string glass;
  float emissionLuminance = 0;  // cd/m²
  ColorInput emissionColor{Spectrum(1.0f)};
};

const SectionOf<TextureDraft>& TextureSection();
const SectionOf<Tint>& TintSection();
const SectionOf<scene::ScalarInput>& ChannelSection();
const SectionOf<scene::Term>& TermSection();
const SectionOf<MaterialDraft>& MaterialSection();

// The name of a texture, for keys that take nothing else.
Type<scene::TextureIndex> TextureName();
// A number, a texture's name, or { texture, channel, factor } (scalar.cpp).
Type<scene::ScalarInput> NumberOrTexture(Range range, const std::string& unit = "");
// The keys of normal and bump maps, and the type of physical materials (section_physical.cpp).
Keys<MaterialDraft> MapKeys();
VariantOf<MaterialDraft> PhysicalMaterial();

// The texture of a name: a defined one or the built-in of that kind.
bool ReadTexture(Reader& reader, const Node& name, scene::TextureIndex& texture);
bool ReadTintedTexture(Reader& reader, const Node& table, Brightness brightness, ColorInput& input);

// A material's name, or a table that is one. Materials are added to the scene.
Type<scene::MaterialIndex> MaterialNameOrTable();
scene::MaterialIndex AddMaterial(Reader& reader, const std::string& name, const Fields& fields);
// Of objects that name none.
scene::MaterialIndex DefaultMaterial(Reader& reader);

// A ready material as the text of its table.
struct Preset {
  const char* name;
  const char* text;  // one sentence
  const char* toml;
};
const std::vector<Preset>& Presets();

// --- Media (toml_section_medium.cpp) ------------------------------------------------------------------------

const SectionOf<scene::Medium>& MediumSection();
VariantOf<MaterialDraft> VolumeMaterial();
// A weight or a roughness, in [0, 1] (toml_section_physical.cpp).
Type<scene::ScalarInput> Share();
// What physical materials have inside.
Keys<scene::OpenPbr> InteriorKeys();

// --- Finer meshes (toml_section_detail.cpp) -----------------------------------------------------------------

struct CreaseDraft;
const SectionOf<scene::Subdivision>& SubdivisionSection();
const SectionOf<CreaseDraft>& CreaseSection();
const SectionOf<scene::Displacement>& DisplacementSection();

// --- Lights (toml_section_light.cpp) ------------------------------------------------------------------------

struct LightDraft {
  scene::Light light;
  std::optional<vec3> lookAt;
  std::optional<float> power;
  std::optional<float> innerAngle;
  std::vector<vec3> vertices;
  std::filesystem::path profileFile;
  float profileRotation = 0;
};

const SectionOf<LightDraft>& LightSection();

// Keys of lights that shine as measured (section_profile.cpp), and what follows from them.
Keys<LightDraft> ProfileKeys();
void FinishProfile(Reader& reader, const Fields& fields, LightDraft& draft);

// The light as it shines when placed by `toWorld`. Reports at `place` if there is no such light.
bool PlaceLight(Reader& reader, const LightDraft& draft, const Affine& toWorld, const Place& place,
                scene::Light& light);

// --- Objects (toml_section_object.cpp, toml_section_shapes.cpp, toml_section_mesh.cpp) ----------------------

// A chain of sharp edges, or a corner.
struct CreaseDraft {
  std::vector<int> vertices;
  float sharpness = 10;
};

// An inline mesh, or the one of a triangle.
struct MeshDraft {
  std::vector<vec3> positions;
  std::vector<scene::uvec3> triangles;
  std::vector<std::vector<int>> polygons;
  std::vector<vec3> normals;
  std::vector<vec2> uvs;
  std::vector<CreaseDraft> creases;
  float smooth = 40;  // degrees
};

// A file that an object takes in with all that it holds (toml_section_file.cpp).
struct IncludedFile {
  int number = -1;  // of the reader's inclusions
  bool lights = true;
  bool cameras = false;
  float lightScale = 1;
  // The materials for those of these names; later by index in the reader's scene
  struct Replacement {
    std::string name;
    scene::MaterialIndex material = -1;
    Place place;
  };
  std::vector<Replacement> materials;
  std::map<scene::MaterialIndex, scene::MaterialIndex> replaced;
};

struct ObjectDraft {
  scene::Object object;
  Placement placement;
  std::vector<MotionKeyDraft> motion;
  std::vector<ShapeKeyDraft> deformation;
  MeshDraft mesh;
  std::filesystem::path file;
  ReadOptions fileOptions;
  IncludedFile included;
  std::string group;
  int meshes = -1;  // of the reader's mesh library
};

const SectionOf<MeshDraft>& MeshSection();
const SectionOf<ObjectDraft>& ObjectSection();
std::vector<VariantOf<ObjectDraft>> ShapeVariants();
VariantOf<ObjectDraft> FileVariant();
KeyOf<ObjectDraft> SubdivisionKey();
Keys<MeshDraft> TriangleKeys();
void CheckTriangle(Reader& reader, const Fields& fields, MeshDraft& mesh);

// After the inclusions are loaded: find the materials that a file's own give way to. Reports names that it does
// not have.
void ReplaceMaterials(Reader& reader, IncludedFile& file);

// The mesh of a draft that has passed its checks; keys have times and positions, one for each of the draft's.
scene::Mesh BuildMesh(const MeshDraft& draft, std::vector<scene::MeshKey> keys = {});

// --- Cameras (toml_section_camera.cpp) ----------------------------------------------------------------------

struct CameraDraft {
  scene::Camera camera;
  std::optional<vec3> direction;
  std::optional<float> horizontalFov;  // radians
  std::optional<float> focalLength;    // mm
  float sensorHeight = 24;             // mm
  std::optional<float> fStop;
  std::optional<float> focusDistance;
  std::optional<vec3> focusAt;
  vec2 shutter{0.0f};  // seconds
  std::vector<CameraKeyDraft> motion;
};

// A point so far along the direction that the sum keeps the direction's digits.
vec3 PointAhead(const vec3& position, const vec3& direction);

// --- Single tables (toml_section_scene.cpp) -----------------------------------------------------------------

struct RenderDraft {
  scene::RenderSettings settings;
  std::array<int, 2> size{settings.width, settings.height};
  std::vector<scene::Aov> aovs;
};

struct SkyDraft {
  scene::SkyModel model;  // what the others say, when all is read
  float elevation = 45 * 0.0174532925199f;
  float azimuth = 135 * 0.0174532925199f;
  std::optional<vec3> direction;
  std::optional<double> time;  // scene/sky/sun_position.h
  std::optional<float> latitude;
  std::optional<float> longitude;
  float turbidity = 2.5f;
  Spectrum ground{0.2f};
  bool sun = true;
};

struct EnvironmentDraft {
  scene::Environment environment;
  std::optional<Spectrum> color;
  std::optional<std::filesystem::path> map;
  std::optional<SkyDraft> sky;
  float strength = 1;
};

// What a file and a group may define; the reader takes these keys itself.
struct FileDraft {};
struct GroupDraft {};

const SectionOf<RenderDraft>& RenderSection();
const SectionOf<CameraDraft>& CameraSection();
const SectionOf<EnvironmentDraft>& EnvironmentSection();
const SectionOf<SkyDraft>& SkySection();
const SectionOf<FileDraft>& FileSection();
const SectionOf<GroupDraft>& GroupSection();

// Make it the scene's: loads its map, computes its sky.
void PlaceEnvironment(Reader& reader, const Fields& fields, const EnvironmentDraft& draft);

// All sections, in the order of the reference page.
const std::vector<const Section*>& AllSections();

}  // namespace snell::io
