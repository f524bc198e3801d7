// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/shapes.h"

#include <fmt/format.h>

#include <utility>

#include "io/mesh/normals.h"
#include "io/mesh/read_mesh.h"
#include "io/mesh/text.h"

namespace snell::io {

static constexpr std::size_t MaxQuadricMeshes = 20'000;

std::optional<PbrtShape> PbrtShapes::Make(const std::string& type, const PbrtParameters& parameters,
                                          bool isTurned, bool isTextured) {
  Findings& findings = context_.findings;
  if (type == "trianglemesh")
    return AddMesh(PbrtTriangleMesh(parameters, findings), type, isTurned);
  if (type == "bilinearmesh")
    return AddMesh(PbrtBilinearMesh(parameters, findings), type, isTurned);
  if (type == "plymesh") return File(parameters, isTurned);
  if (type == "loopsubdiv") {
    scene::Mesh mesh = PbrtTriangleMesh(parameters, findings);
    mesh.normals.clear();
    SmoothNormals(mesh, 180);
    parameters.Ignore({"levels", "scheme"});
    findings.Add("subdivision surface", "shown as its control mesh, smoothed", "",
                 parameters.place());
    return AddMesh(std::move(mesh), type, isTurned);
  }

  using Kind = PbrtQuadric::Kind;
  if (type == "sphere" || type == "cylinder" || type == "disk") {
    const Kind kind = type == "sphere"     ? Kind::Sphere
                      : type == "cylinder" ? Kind::Cylinder
                                           : Kind::Disk;
    const PbrtQuadric quadric = ReadQuadric(kind, parameters);
    // An analytic disk has its texture coordinates laid out another way
    const bool asMesh = kind == Kind::Disk && isTextured;
    if (const auto whole = AnalyticQuadric(quadric, isTurned); whole && !asMesh) return whole;
    return Tessellated(quadric, type, isTurned, parameters.place());
  }
  findings.Add(fmt::format("{} shape", Quoted(type)), "left out", "", parameters.place());
  for (const auto& parameter : parameters.All()) parameters.Ignore({parameter->name});
  return {};
}

PbrtShape PbrtShapes::AddMesh(scene::Mesh mesh, const std::string& name, bool isTurned) {
  mesh.name = name;
  if (isTurned) TurnInsideOut(mesh);
  const scene::MeshIndex index = scene::MeshIndex(context_.scene.meshes.size());
  context_.scene.meshes.push_back(std::move(mesh));
  return {scene::MeshGeometry{index}};
}

// Equal ones are one mesh: a few words could otherwise ask for many vertices.
PbrtShape PbrtShapes::Tessellated(const PbrtQuadric& quadric, const std::string& name,
                                  bool isTurned, const Place& place) {
  const auto [entry, isNew] = quadrics_.try_emplace({quadric, isTurned}, -1);
  if (isNew) {
    if (quadrics_.size() > MaxQuadricMeshes)
      throw Error(
          fmt::format("there are more than {} different parts of quadrics", MaxQuadricMeshes),
          place);
    const PbrtShape made = AddMesh(QuadricMesh(quadric), name, isTurned);
    entry->second = std::get<scene::MeshGeometry>(made.geometry).mesh;
  }
  return {scene::MeshGeometry{entry->second}};
}

// A file is read once, however many shapes show it.
std::optional<PbrtShape> PbrtShapes::File(const PbrtParameters& parameters, bool isTurned) {
  const std::string name = parameters.String("filename", "");
  parameters.Leave({"displacement", "displacement.edgelength", "edgelength"}, "left out",
                   context_.findings);
  if (name.ends_with(".gz"))
    throw Error(fmt::format("the compressed file {} is not read", Quoted(name)), parameters.place(),
                "unpack it with gunzip, and change the name");
  const auto path = context_.files.Find(context_.folder, name);
  if (!path)
    throw Error(fmt::format("the mesh {} is not found in the scene's folder", Quoted(name)),
                parameters.place());
  const auto [entry, isNew] = files_.try_emplace({path->string(), isTurned}, -1);
  if (isNew) {
    MeshReadOptions options;
    options.smoothDegrees = 0;
    options.limits = context_.options.limits;
    scene::Mesh mesh = std::move(ReadMesh(*path, options, context_.warn).front());
    const std::string title = mesh.name;
    entry->second =
        std::get<scene::MeshGeometry>(AddMesh(std::move(mesh), title, isTurned).geometry).mesh;
  }
  return PbrtShape{scene::MeshGeometry{entry->second}};
}

}  // namespace snell::io
