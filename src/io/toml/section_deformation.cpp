// SPDX-License-Identifier: Apache-2.0
//
// Deformation: the shapes that a mesh has at moments of the scene's time, as files of the same faces or as positions.
#include <fmt/format.h>

#include <algorithm>

#include "io/mesh/shapes.h"
#include "io/toml/sections.h"

namespace snell::io {

const SectionOf<ShapeKeyDraft>& ShapeKeySection() {
  Type<float> seconds = Number(Any, "s");
  seconds.example = "0.5";
  static const SectionOf<ShapeKeyDraft> section =
      SectionOf<ShapeKeyDraft>(
          "shape_key", "deformation",
          "The shape of a mesh at a moment. In between, its vertices move evenly on straight "
          "lines; before the first key and after the last they rest.",
          {Field("time", &ShapeKeyDraft::time, seconds, "The moment.").Required(),
           Field("file", &ShapeKeyDraft::file, SceneFile("bunny-2.ply"),
                 "A mesh file with the same faces over the same number of vertices.")
               .Standard("the object's own"),
           Field("positions", &ShapeKeyDraft::positions, ListOf(Point(), "points", 3),
                 "For a mesh that is written in the scene: as many vertices as it has.")
               .Standard("the mesh's own")
               .Example("[[0, 0, 0], [1, 0, 0], [0, 1, 0.5]]")})
          .OnlyOne({{"file"}, {"positions"}});
  return section;
}

KeyOf<ObjectDraft> DeformationKey(const std::string& later) {
  return Field("deformation", &ObjectDraft::deformation,
               ListOf(TableOf(ShapeKeySection, "{ time and file or positions }"), "keys", 2),
               "Shapes of the mesh at moments of the scene's time; shown blurred while the "
               "camera's `shutter` is open.")
      .Standard("it keeps its shape")
      .Example(fmt::format("[{{ time = 0 }}, {{ time = 0.5, {} }}]", later))
      .Not({"shapes", "morph", "keyframes"});
}

// Report times that do not rise, and keys of the other kind. True if all is well.
static bool CheckKeys(Reader& reader, const Fields& fields, const ObjectDraft& draft, bool isFile) {
  const auto rises = [](const ShapeKeyDraft& a, const ShapeKeyDraft& b) {
    return a.time >= b.time;
  };
  const std::vector<ShapeKeyDraft>& keys = draft.deformation;
  std::string fault;
  if (std::ranges::adjacent_find(keys, rises) != keys.end())
    fault = fmt::format("the times of 'deformation' do not rise in {}", fields.title);
  for (const ShapeKeyDraft& key : keys) {
    if (isFile && !key.positions.empty())
      fault = "'deformation': 'positions' are for meshes that are written in the scene";
    if (!isFile && !key.file.empty())
      fault = "'deformation': a 'file' is for objects that are files";
  }
  if (fault.empty()) return true;
  reader.Report(std::move(fault), fields.PlaceOf("deformation"));
  return false;
}

std::vector<MeshShape> ShapesOfFile(Reader& reader, const Fields& fields,
                                    const ObjectDraft& draft) {
  std::vector<MeshShape> shapes;
  if (draft.deformation.empty() || !CheckKeys(reader, fields, draft, true)) return shapes;
  for (const ShapeKeyDraft& key : draft.deformation)
    shapes.push_back({double(key.time), key.file.empty() ? draft.file : key.file});
  return shapes;
}

void AddInlineKeys(Reader& reader, const Fields& fields, const ObjectDraft& draft,
                   std::vector<scene::MeshKey>& keys) {
  if (draft.deformation.empty() || !CheckKeys(reader, fields, draft, false)) return;
  const std::size_t count = draft.mesh.positions.size();
  for (const ShapeKeyDraft& key : draft.deformation) {
    if (!key.positions.empty() && key.positions.size() != count) {
      reader.Report(
          fmt::format("'deformation': expected one for each of the {} positions, found {}", count,
                      key.positions.size()),
          fields.PlaceOf("deformation"));
      keys.clear();
      return;
    }
    keys.push_back(
        {double(key.time), key.positions.empty() ? draft.mesh.positions : key.positions, {}, {}});
  }
}

}  // namespace snell::io
