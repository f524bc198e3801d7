// SPDX-License-Identifier: Apache-2.0
//
// Triangle meshes from files: Wavefront OBJ, PLY and STL. The only mesh header that other rooms need; the
// readers behind it (readers.h) deliver polygons, faces.h makes triangles over shared vertices
// of them, and normals.h the normals that a file lacks.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "io/read_limits.h"
#include "scene/scene.h"
#include "util/error.h"

namespace snell::io {

// A file whose vertices are where those of a mesh are at a moment of the scene's time, in seconds.
struct MeshShape {
  double time = 0;
  std::filesystem::path file;
  bool operator<(const MeshShape& other) const {
    return time != other.time ? time < other.time : file < other.file;
  }
};

struct MeshReadOptions {
  // Faces without normals in the file are smooth where they meet at no more than this angle, in degrees;
  // 0 leaves them flat.
  float smoothDegrees = 40;
  bool ignoreFileNormals = false;
  bool smoothingGroups =
      false;  // of an OBJ file: they count instead of the angle, where there are some
  // Folders besides the file's own where its materials and pictures may lie.
  std::vector<std::filesystem::path> folders = {};
  // The shapes of a mesh that changes it, by rising time, two at least: files of the same faces, one of which may be the
  // mesh's own.
  std::vector<MeshShape> shapes = {};
  ReadLimits limits = {};
};

// The meshes in a file, at least one, each with at least one triangle; today always exactly one, as the
// groups and objects of an OBJ file are merged. The format follows the file's extension in any case, or,
// where that says nothing, the contents. Positions are finite and normals have unit length; `normals` is
// empty if the mesh is flat. What was repaired or left out goes to `warn`, which may be empty, as one
// counted warning for each kind. Throws Error with a place in the file if there is nothing to render or no
// safe guess at what was meant. Reads no other file: material libraries are left alone.
std::vector<scene::Mesh> ReadMesh(const std::filesystem::path& path, const MeshReadOptions& options,
                                  const WarningSink& warn);

// "obj, ply, stl", for messages.
std::string KnownMeshExtensions();

}  // namespace snell::io
