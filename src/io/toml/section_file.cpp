// SPDX-License-Identifier: Apache-2.0
//
// Objects that are files: the triangles of a mesh, or a whole scene with materials and lights of its own.
#include <fmt/format.h>

#include <algorithm>

#include "io/format.h"
#include "io/mesh/read_mesh.h"
#include "io/toml/sections.h"
#include "util/file.h"

namespace snell::io {

namespace {

// What a file can do with a key.
enum class Role { Mesh, ObjMesh, Gltf, Scene };

Role RoleOf(const std::filesystem::path& file) {
  switch (FormatOf(file)) {
    case Format::Gltf: return Role::Gltf;
    case Format::Toml:
    case Format::Other:
    case Format::Pbrt:
    case Format::Nff: return Role::Scene;
    default: return LowerExtension(file) == "obj" ? Role::ObjMesh : Role::Mesh;
  }
}

// A key that changes nothing is a misunderstanding.
void CheckKeys(Reader& reader, const Fields& fields, Role role) {
  const auto refuse = [&](std::initializer_list<const char*> keys, const char* files) {
    for (const char* key : keys)
      if (fields.Find(key))
        reader.Report(fmt::format("'{}' is for {}", key, files), fields.PlaceOf(key));
  };
  if (role != Role::Gltf) refuse({"scene", "variant", "time", "duration"}, "glTF files");
  if (role == Role::Gltf || role == Role::Scene)
    refuse({"smooth", "ignore_normals", "deformation"}, "mesh files");
  if (role == Role::Mesh) refuse({"materials"}, "files with materials");
  if (role == Role::Mesh || role == Role::ObjMesh)
    refuse({"lights", "light_scale", "cameras"}, "files with lights and cameras");
}

// A mesh without materials of its own is one object; what has them is taken in as a whole. So is an OBJ file,
// unless one material replaces all, or its shape changes: then it stays one body.
void FinishFile(Reader& reader, const Fields& fields, ObjectDraft& draft) {
  const Role role = RoleOf(draft.file);
  CheckKeys(reader, fields, role);
  const Place place = fields.PlaceOf("file");
  const bool oneMaterial = draft.object.material >= 0 && draft.included.materials.empty();
  if (role == Role::Mesh || (role == Role::ObjMesh && (oneMaterial || !draft.deformation.empty())))
    draft.meshes =
        reader.meshes.Request(draft.file, draft.fileOptions.smooth, draft.fileOptions.ignoreNormals,
                              ShapesOfFile(reader, fields, draft), place);
  else
    draft.included.number = reader.inclusions.Request(draft.file, draft.fileOptions, place);
}

Type<std::vector<IncludedFile::Replacement>> Replacements() {
  Type<std::vector<IncludedFile::Replacement>> type;
  type.expected = "a table of materials by name";
  type.schema = R"({"type": "object", "additionalProperties": {"anyOf": [{"type": "string"}, )"
                R"({"$ref": "#/definitions/material"}]}})";
  type.example = R"({ Seat = "gold" })";
  type.read = [expected = type.expected](Reader& reader, const Node& value,
                                         std::vector<IncludedFile::Replacement>& list) {
    if (!value.IsTable()) return reader.Refuse(value, expected);
    bool good = true;
    for (const Node::Entry& entry : value.Entries()) {
      IncludedFile::Replacement replacement{std::string(entry.name), -1, entry.place()};
      const KeyScope scope(reader, Printable(entry.name));
      good = MaterialNameOrTable().read(reader, entry.value, replacement.material) && good;
      list.push_back(std::move(replacement));
    }
    return good;
  };
  return type;
}

template <typename T>
KeyOf<ObjectDraft> Option(const char* name, T ReadOptions::*member, Type<T> type,
                          const char* text) {
  return FieldAt<ObjectDraft, T>(
      name, [member](ObjectDraft& draft) -> T& { return draft.fileOptions.*member; },
      std::move(type), text);
}

template <typename T>
KeyOf<ObjectDraft> Option(const char* name, std::optional<T> ReadOptions::*member, Type<T> type,
                          const char* text) {
  KeyOf<ObjectDraft> key = FieldAt<ObjectDraft, T>(
      name, [member](ObjectDraft& draft) -> T& { return (draft.fileOptions.*member).emplace(); },
      std::move(type), text);
  key.write = nullptr;
  return key;
}

template <typename T>
KeyOf<ObjectDraft> Included(const char* name, T IncludedFile::*member, Type<T> type,
                            const char* text) {
  return FieldAt<ObjectDraft, T>(
      name, [member](ObjectDraft& draft) -> T& { return draft.included.*member; }, std::move(type),
      text);
}

Type<double> Seconds(Range range) {
  Type<double> type;
  type.expected = "a number" + range.Words();
  type.unit = "s";
  type.schema = "{\"type\": \"number\"" + range.Schema() + "}";
  type.example = "0.5";
  type.read = [range, expected = type.expected](Reader& reader, const Node& value,
                                                double& seconds) {
    return ReadNumber(reader, value, range, expected, seconds);
  };
  return type;
}

}  // namespace

VariantOf<ObjectDraft> FileVariant() {
  const Keys<ObjectDraft> keys = {
      Field("file", &ObjectDraft::file, SceneFile("bunny.ply"),
            "The file, relative to the one that names it.")
          .Required(),
      Option("smooth", &ReadOptions::smooth, Number({0, 180}, "degrees"),
             "Meshes without normals: edges between faces that meet at a smaller angle look round; "
             "0: flat.")
          .Standard("by the smoothing groups of an OBJ file, else `40`")
          .Not({"crease", "crease_angle", "smoothing"}),
      Option("ignore_normals", &ReadOptions::ignoreNormals, Boolean(),
             "Meshes: whether to drop the file's own normals."),
      Included("materials", &IncludedFile::materials, Replacements(),
               "Materials in place of those that have these names in the file.")
          .Standard("the file's")
          .Not({"overrides", "replace"}),
      Included("lights", &IncludedFile::lights, Boolean(), "Whether the file's lights shine."),
      Included("light_scale", &IncludedFile::lightScale, Number(NotNegative),
               "A factor for the file's lights.")
          .Not({"light_strength", "exposure"}),
      Included("cameras", &IncludedFile::cameras, Boolean(),
               "Whether the file's cameras stand behind the scene's own.")
          .Not({"camera"}),
      Option("scene", &ReadOptions::scene, Text("Night"), "glTF: the scene of this name.")
          .Standard("the file's default"),
      Option("variant", &ReadOptions::variant, Text("Red"),
             "glTF: the variant of the materials (`KHR_materials_variants`).")
          .Standard("the file's default"),
      Option("time", &ReadOptions::time, Seconds(Any),
             "glTF: the moment of the animations to show.")
          .Standard("by the command line, else all is at rest"),
      Option("duration", &ReadOptions::duration, Seconds(NotNegative),
             "glTF: for so long from `time` on, animated nodes move, and skins and morphs bend "
             "meshes; for a camera whose `shutter` is open then.")
          .Standard("0: nothing moves"),
      DeformationKey("file = \"bunny-2.ply\""),
      SubdivisionKey()};
  return VariantOf<ObjectDraft>(
             "file",
             fmt::format("All that a file holds ({}), placed as a whole, again and again if you "
                         "like: it is read once. Surroundings and settings of the file do not "
                         "count. Names in it get the object's name before them.",
                         KnownFormats()),
             keys)
      .ByPresence()
      .Checked(FinishFile);
}

void ReplaceMaterials(Reader& reader, IncludedFile& file) {
  const InclusionLibrary::Materials& materials = reader.inclusions.MaterialsOf(file.number);
  for (const IncludedFile::Replacement& replacement : file.materials) {
    bool found = false;
    std::vector<std::string> names;
    for (const auto& [name, index] : materials) {
      if (name == replacement.name) file.replaced[index] = replacement.material;
      found |= name == replacement.name;
      if (names.size() < 1000 && !name.empty()) names.push_back(name);
    }
    if (found) continue;
    std::string hint = Suggestion(replacement.name, names);
    if (hint.empty() && !names.empty()) {
      names.resize(std::min<std::size_t>(names.size(), 8));
      for (const std::string& name : names)
        hint += (hint.empty() ? "it has " : ", ") + QuotedName(name);
    }
    const std::string fileName = reader.inclusions.PathOf(file.number).filename().string();
    reader.Report(
        fmt::format("{} has no material {}", QuotedName(fileName), QuotedName(replacement.name)),
        replacement.place, hint);
  }
}

}  // namespace snell::io
