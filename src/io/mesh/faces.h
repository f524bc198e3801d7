// SPDX-License-Identifier: Apache-2.0
//
// Faces as files give them, and the step that all mesh readers share: polygons are cut into triangles,
// corners that agree in position, uv and normal become one vertex, and faces with undefined positions go.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/mesh/normals.h"
#include "scene/scene.h"

namespace snell::io {

struct MeshFile;

// Stands for an index that a corner does not have.
inline constexpr std::uint32_t NoIndex = 0xffffffffu;

// Faces, or triangles, from one number to where the next run begins: which part of the file they belong to,
// and what it says of their smoothing.
struct FaceRun {
  std::uint64_t first = 0;
  std::uint32_t part = 0;
  std::uint32_t smoothing = SmoothByAngle;
};

// Polygons of at least three corners. A corner refers to a position and, separately, to a uv and a normal;
// or these go with the positions, one for each.
struct FaceSet {
  std::string name;
  std::vector<scene::vec3> positions;
  std::vector<std::vector<scene::vec3>> shapes;  // positions of the mesh's keys
  std::vector<scene::vec2> uvs;
  std::vector<scene::vec3> normals;  // of any length; zero or not finite counts as missing
  bool uvsGoWithPositions = false;
  bool normalsGoWithPositions = false;
  std::vector<scene::vec4> colors;  // linear; empty or one for each position

  std::uint64_t faceCount = 0;
  std::vector<std::uint32_t> sizes;  // corners of each face; empty while all are triangles
  // For each corner, face after face. The last two are empty while no corner has such an index, else may
  // end early: the corners that follow have none. Positions are in range, the others need not be.
  std::vector<std::uint32_t> positionOf;
  std::vector<std::uint32_t> uvOf;
  std::vector<std::uint32_t> normalOf;
  std::vector<FaceRun> runs;  // empty: all faces are of part 0

  void AddCorner(std::uint32_t position, std::uint32_t uv = NoIndex,
                 std::uint32_t normal = NoIndex);
  // Ends a face with the last `corners` corners.
  void EndFace(std::uint32_t corners);
};

// The mesh of the faces, smoothed as the options say where the file gives no normals: without any if it is
// flat. If `runs` is not null, it receives the runs of triangles. Throws Error if more triangles come out
// than the options allow, or none. Warns about whatever was left out.
scene::Mesh BuildMesh(FaceSet faces, const MeshFile& file, std::vector<FaceRun>* runs = nullptr);

}  // namespace snell::io
