// SPDX-License-Identifier: Apache-2.0
//
// [[object]]: what all objects have, and the sources of geometry beside shapes and files: meshes written
// in the scene, and placed groups.
#include <fmt/format.h>

#include "io/mesh/normals.h"
#include "io/toml/sections.h"

namespace snell::io {

using scene::Object;

// --- Checks -------------------------------------------------------------------------------------------------

static void FinishInlineMesh(Reader& reader, const Fields& fields, ObjectDraft& draft) {
  std::vector<scene::MeshKey> keys;
  AddInlineKeys(reader, fields, draft, keys);
  scene::Mesh mesh = BuildMesh(draft.mesh, std::move(keys));
  if (!HasArea(mesh)) reader.Report("no face of the mesh has an area", fields.PlaceOf("mesh"));
  draft.meshes = reader.meshes.Add(std::move(mesh));
}

static void FinishObject(Reader& reader, const Fields& fields, ObjectDraft& draft) {
  draft.object.toWorld = draft.placement.Matrix();
  FinishMotion(reader, fields, draft);
  std::string reason;
  if (!IsUsable(draft.object.toWorld, reason))
    reader.Report(fmt::format("the transform of {} cannot be used: {}", fields.title, reason),
                  fields.place);
}

// --- Geometry that is no shape ------------------------------------------------------------------------------

Type<std::filesystem::path> SceneFile(std::string example) {
  Type<std::filesystem::path> type;
  type.expected = "the name of a file";
  type.schema = R"({"type": "string", "minLength": 1})";
  type.example = "\"" + example + "\"";
  type.read = [](Reader& reader, const Node& value, std::filesystem::path& path) {
    return reader.FindFile(value, path);
  };
  return type;
}

static Type<std::string> GroupName() {
  Type<std::string> type = Text("tree");
  type.expected = "the name of a group";
  type.read = [](Reader& reader, const Node& value, std::string& group) {
    const auto name = value.String();
    if (!name) return reader.Refuse(value, "the name of a group");
    group = *name;
    const bool known = reader.groups.contains(*name);
    if (!known && !reader.filesMissing)
      reader.Report(fmt::format("unknown group {}", QuotedName(*name)), value.place(),
                    Suggestion(*name, NamesOf(reader.groups)));
    return known;
  };
  return type;
}

KeyOf<ObjectDraft> SubdivisionKey() {
  Type<scene::Subdivision> type = TableOf(SubdivisionSection, "a table with a scheme or levels");
  type.read = [read = type.read](Reader& reader, const Node& value, scene::Subdivision& record) {
    record.scheme = scene::SubdivisionScheme::CatmullClark;
    return read(reader, value, record);
  };
  const auto at = [](ObjectDraft& draft) -> scene::Subdivision& {
    return draft.object.subdivision;
  };
  return FieldAt<ObjectDraft, scene::Subdivision>(
             "subdivision", at, type, "Makes the mesh the smooth surface that it is the cage of.")
      .Standard("none")
      .Example("{ scheme = \"catmull-clark\", levels = 3 }")
      .Not({"subdivide", "subdiv"});
}

// A name is the mistake that is made most often here.
static Type<MeshDraft> InlineMesh() {
  Type<MeshDraft> type = TableOf(MeshSection, "a table with positions and faces");
  type.read = [read = type.read, expected = type.expected](Reader& reader, const Node& value,
                                                           MeshDraft& mesh) {
    if (value.String()) return reader.Refuse(value, expected, "the key of mesh files is 'file'");
    return read(reader, value, mesh);
  };
  return type;
}

static VariantOf<ObjectDraft> MeshVariant() {
  const auto mesh =
      Field("mesh", &ObjectDraft::mesh, InlineMesh(), "The mesh.")
          .Required()
          .Example("{ positions = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], triangles = [[0, 1, 2]] }");
  return VariantOf<ObjectDraft>(
             "mesh",
             "Triangles written in the scene: an inline table, or one of its "
             "own under `[object.mesh]`.",
             {mesh, DeformationKey("positions = [[0, 0, 0], [1, 0, 0], [0, 1, 0.5]]"),
              SubdivisionKey()})
      .ByPresence()
      .Checked(FinishInlineMesh);
}

static VariantOf<ObjectDraft> GroupVariant() {
  return VariantOf<ObjectDraft>(
             "group", "All objects and lights of a group, moved together.",
             {Field("group", &ObjectDraft::group, GroupName(), "The group.").Required()})
      .ByPresence();
}

// --- The section --------------------------------------------------------------------------------------------

static Keys<Object> CommonKeys() {
  return {
      Field("name", &Object::name, Text("ball"), "For messages.").Standard("none"),
      Field("material", &Object::material, MaterialNameOrTable(),
            "What the surface is made of; for a group, of those members that do not say; for a "
            "file, in place of all its materials.")
          .Standard("light grey")
          .Not({"color", "colour", "diffuse", "shader", "texture", "mat"}),
      Field("visible_to_camera", &Object::visibleToCamera, Boolean(),
            "Whether the camera sees it directly.")
          .Not({"visible"}),
      Field("visible_in_reflections", &Object::visibleToSecondary, Boolean(),
            "Whether it is seen in mirrors and through glass."),
      Field("casts_shadow", &Object::castsShadow, Boolean(), "Whether it keeps light from others.")
          .Not({"shadow", "shadows", "cast_shadow"})};
}

const SectionOf<ObjectDraft>& ObjectSection() {
  const auto variants = [] {
    std::vector<VariantOf<ObjectDraft>> all = ShapeVariants();
    for (const auto& variant : {FileVariant(), MeshVariant(), GroupVariant()})
      all.push_back(variant);
    return all;
  };
  static const SectionOf<ObjectDraft> section =
      SectionOf<ObjectDraft>("object", "[[object]]",
                             "A thing in the scene: exactly one of `shape`, `file`, `mesh` and "
                             "`group`. All surfaces have two sides.",
                             Join<ObjectDraft>({Within(&ObjectDraft::object, CommonKeys()),
                                                Within(&ObjectDraft::placement, PlacementKeys()),
                                                {MotionKeyOfObjects()}}))
          .Variants("shape", variants())
          .OnlyOne(PlacementSides)
          .Checked(FinishObject);
  return section;
}

}  // namespace snell::io
