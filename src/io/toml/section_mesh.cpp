// SPDX-License-Identifier: Apache-2.0
//
// Meshes that are written in the scene: the inline table `mesh` and the shape "triangle".
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "io/mesh/normals.h"
#include "io/mesh/polygon.h"
#include "io/mesh/shapes.h"
#include "io/toml/sections.h"

namespace snell::io {

// Of one polygon: triangulation takes time that grows with the square of it.
static constexpr std::size_t MaxPolygonCorners = 4096;

// --- Checks -------------------------------------------------------------------------------------------------

// The corners of a face one by one.
static std::size_t CornerCount(const scene::uvec3&) { return 3; }
static std::size_t CornerCount(const std::vector<int>& polygon) { return polygon.size(); }
static std::size_t Corner(const scene::uvec3& triangle, std::size_t k) { return triangle[int(k)]; }
static std::size_t Corner(const std::vector<int>& polygon, std::size_t k) {
  return std::size_t(polygon[k]);
}

// Reports the first index that names no position.
template <class Face>
static void CheckIndices(Reader& reader, const Fields& fields, const char* key,
                         const std::vector<Face>& faces, std::size_t positions) {
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (std::size_t k = 0; k < CornerCount(faces[i]); ++k) {
      if (Corner(faces[i], k) < positions) continue;
      reader.Report(fmt::format("'{}': there is no position {}; there are {}, counted from 0", key,
                                Corner(faces[i], k), positions),
                    fields.Find(key)->value[i][k].place());
      return;
    }
  }
}

static void CheckCount(Reader& reader, const Fields& fields, const char* key, std::size_t given,
                       std::size_t positions) {
  if (given == 0 || given == positions) return;
  reader.Report(fmt::format("'{}': expected one for each of the {} positions, found {}", key,
                            positions, given),
                fields.PlaceOf(key));
}

static void CheckMesh(Reader& reader, const Fields& fields, MeshDraft& mesh) {
  const std::size_t count = mesh.positions.size();
  CheckCount(reader, fields, "normals", mesh.normals.size(), count);
  CheckCount(reader, fields, "uvs", mesh.uvs.size(), count);
  CheckIndices(reader, fields, "triangles", mesh.triangles, count);
  CheckIndices(reader, fields, "polygons", mesh.polygons, count);
  for (const CreaseDraft& crease : mesh.creases) {
    const auto outside = std::ranges::find_if(
        crease.vertices, [&](int vertex) { return std::size_t(vertex) >= count; });
    if (outside == crease.vertices.end()) continue;
    reader.Report(fmt::format("'creases': there is no position {}; there are {}, counted from 0",
                              *outside, count),
                  fields.PlaceOf("creases"));
    return;
  }
}

void CheckTriangle(Reader& reader, const Fields& fields, MeshDraft& mesh) {
  if (HaveNoArea(mesh.positions[1] - mesh.positions[0], mesh.positions[2] - mesh.positions[0]))
    reader.Report(fmt::format("the triangle has no area in {}", fields.title),
                  fields.PlaceOf("vertices"));
  mesh.triangles = {scene::uvec3(0, 1, 2)};
  mesh.smooth = 0;
}

// --- Building -----------------------------------------------------------------------------------------------

scene::Mesh BuildMesh(const MeshDraft& draft, std::vector<scene::MeshKey> keys) {
  scene::Mesh mesh;
  mesh.keys = std::move(keys);
  mesh.positions = draft.positions;
  mesh.normals = draft.normals;
  mesh.uvs = draft.uvs;
  mesh.triangles = draft.triangles;

  // Split polygons; one without area gives nothing
  std::vector<vec3> corners;
  for (const std::vector<int>& polygon : draft.polygons) {
    corners.clear();
    for (const int index : polygon) corners.push_back(mesh.positions[std::size_t(index)]);
    bool isFirst = true;
    for (const scene::uvec3& t : TriangulatePolygon(corners).triangles) {
      mesh.triangles.emplace_back(unsigned(polygon[t.x]), unsigned(polygon[t.y]),
                                  unsigned(polygon[t.z]));
      mesh.joins.push_back(!std::exchange(isFirst, false));
    }
  }
  for (const CreaseDraft& crease : draft.creases) {
    const auto place = [&](std::size_t i) {
      return mesh.positions[std::size_t(crease.vertices[i])];
    };
    for (std::size_t i = 0; i + 1 < crease.vertices.size(); ++i)
      mesh.creases.push_back({place(i), place(i + 1), crease.sharpness});
    if (crease.vertices.size() == 1) mesh.creases.push_back({place(0), place(0), crease.sharpness});
  }
  if (mesh.normals.empty()) SmoothNormals(mesh, draft.smooth);
  CompleteKeys(mesh);
  return mesh;
}

// --- The sections -------------------------------------------------------------------------------------------

static Type<std::vector<vec3>> Normals(std::size_t least, std::size_t most) {
  auto type = ListOf(Direction(), "directions", least, most);
  type.example = "[[0, 0, 1], [0, 0, 1], [0.1, 0, 1]]";
  return type;
}

static Type<std::vector<vec2>> Uvs(std::size_t least, std::size_t most) {
  auto type = ListOf(TexturePoint(), "pairs of numbers", least, most);
  type.example = "[[0, 0], [1, 0], [0, 1]]";
  return type;
}

Keys<MeshDraft> TriangleKeys() {
  return {Field("vertices", &MeshDraft::positions, ListOf(Point(), "points", 3, 3), "The corners.")
              .Required()
              .Example("[[0, 0, 0], [1, 0, 0], [0, 1, 0]]")
              .Not({"points", "positions", "corners"}),
          Field("normals", &MeshDraft::normals, Normals(3, 3),
                "A normal for each corner, for a round look.")
              .Standard("flat"),
          Field("uvs", &MeshDraft::uvs, Uvs(3, 3), "Texture coordinates of each corner.")
              .Standard("barycentric")
              .Not({"uv", "texcoords"})};
}

const SectionOf<MeshDraft>& MeshSection() {
  static constexpr std::size_t NoLimit = std::size_t(-1);
  const auto polygon =
      ListOf(Integer(0, std::numeric_limits<int>::max()), "indices", 3, MaxPolygonCorners);
  static const SectionOf<MeshDraft> section =
      SectionOf<MeshDraft>(
          "mesh", "mesh",
          "Triangles or polygons over shared vertices. Corners count counter-clockwise seen from "
          "outside.",
          {Field("positions", &MeshDraft::positions, ListOf(Point(), "points", 3), "The vertices.")
               .Required()
               .Example("[[0, 0, 0], [1, 0, 0], [0, 1, 0]]")
               .Not({"vertices", "points"}),
           Field("triangles", &MeshDraft::triangles, ListOf(TriangleIndices(), "triangles", 1),
                 "Three indices of positions each, counted from 0.")
               .Standard("none")
               .Example("[[0, 1, 2]]")
               .Not({"faces", "indices"}),
           Field("polygons", &MeshDraft::polygons, ListOf(polygon, "polygons", 1),
                 "Any number of indices each, in place of `triangles`; flat, convex or not.")
               .Standard("none")
               .Example("[[0, 1, 2]]")
               .Not({"quads"}),
           Field("normals", &MeshDraft::normals, Normals(0, NoLimit), "A normal for each position.")
               .Standard("by `smooth`"),
           Field("uvs", &MeshDraft::uvs, Uvs(0, NoLimit), "Texture coordinates of each position.")
               .Standard("barycentric")
               .Not({"uv", "texcoords"}),
           Field("creases", &MeshDraft::creases,
                 ListOf(TableOf(CreaseSection, "{ vertices, sharpness }"), "creases"),
                 "Edges and corners that stay sharp when the mesh is subdivided.")
               .Standard("none")
               .Example("[{ vertices = [0, 1, 2], sharpness = 3 }]"),
           Field("smooth", &MeshDraft::smooth, Number({0, 180}, "degrees"),
                 "Without `normals`, edges between faces that meet at a smaller angle look round; "
                 "0: flat.")
               .Not({"crease", "crease_angle", "smoothing"})})
          .OnlyOne({{"triangles"}, {"polygons"}}, true)
          .Checked(CheckMesh);
  return section;
}

}  // namespace snell::io
