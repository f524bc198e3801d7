// SPDX-License-Identifier: Apache-2.0
#include "io/mesh/read_mesh.h"

#include <new>
#include <stdexcept>
#include <utility>

#include "io/mesh/faces.h"
#include "io/mesh/readers.h"
#include "io/mesh/shapes.h"

namespace snell::io {
namespace {

FaceSet ReadFaces(MeshFile& file, const std::string& extension) {
  if (extension == "obj") return ReadObj(file);
  if (extension == "ply") return ReadPly(file);
  if (extension == "stl") return ReadStl(file);

  if (LooksLikePly(file.bytes)) return ReadPly(file);
  if (LooksLikeStl(file.bytes)) return ReadStl(file);
  if (LooksLikeObj(file.bytes)) return ReadObj(file);
  throw Error("not a mesh in a known format", file.AtLine(0),
              "meshes are read from " + KnownMeshExtensions());
}

scene::Mesh ReadOne(const std::filesystem::path& path, const MeshReadOptions& options,
                    const WarningSink& warn) {
  MeshFile file{path.string(), ReadWithin(path, options.limits), options, warn};
  FaceSet faces = ReadFaces(file, LowerExtension(path));
  if (faces.name.empty()) faces.name = path.stem().string();
  file.bytes = std::string();
  for (const MeshShape& shape : options.shapes) {
    if (shape.file == path) {
      faces.shapes.push_back(faces.positions);
      continue;
    }
    MeshFile other{shape.file.string(), ReadWithin(shape.file, options.limits), options, warn};
    AddShape(faces, file, ReadFaces(other, LowerExtension(shape.file)), other);
  }

  scene::Mesh mesh = BuildMesh(std::move(faces), file);
  for (std::size_t i = 0; i < options.shapes.size(); ++i)
    mesh.keys[i].time = options.shapes[i].time;
  CompleteKeys(mesh);
  return mesh;
}

}  // namespace

std::vector<scene::Mesh> ReadMesh(const std::filesystem::path& path, const MeshReadOptions& options,
                                  const WarningSink& warn) {
  try {
    std::vector<scene::Mesh> meshes;
    meshes.push_back(ReadOne(path, options, warn));
    return meshes;
  } catch (const std::bad_alloc&) {
    throw Error("not enough memory for the mesh", {path.string()});
  } catch (const std::length_error&) {
    throw Error("not enough memory for the mesh", {path.string()});
  }
}

std::string KnownMeshExtensions() { return "obj, ply, stl"; }

}  // namespace snell::io
