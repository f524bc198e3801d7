// SPDX-License-Identifier: Apache-2.0
//
// pbrt's shapes as geometry of the scene. Quadrics are analytic where they are whole, else meshes.
#pragma once

#include <compare>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "io/pbrt/context.h"
#include "io/pbrt/parameters.h"

namespace snell::io {

struct PbrtShape {
  scene::Geometry geometry;
  scene::Affine toObject{1.0};  // from the geometry's space to pbrt's
};

// A part of a sphere, cylinder or disk around the z axis.
struct PbrtQuadric {
  enum class Kind { Sphere, Cylinder, Disk };
  Kind kind = Kind::Sphere;
  double radius = 1;
  double zMin = -1;  // the height of a disk
  double zMax = 1;
  double innerRadius = 0;
  double phiMax = 360;  // degrees
  auto operator<=>(const PbrtQuadric&) const = default;
};

class PbrtShapes {
 public:
  explicit PbrtShapes(PbrtContext& context) : context_(context) {}

  // The geometry of a Shape statement, or nothing after a finding; meshes join the scene's. `isTurned`: its inside
  // is out. `isTextured`: texture coordinates must be as pbrt has them.
  std::optional<PbrtShape> Make(const std::string& type, const PbrtParameters& parameters,
                                bool isTurned, bool isTextured);

 private:
  PbrtShape AddMesh(scene::Mesh mesh, const std::string& name, bool isTurned);
  std::optional<PbrtShape> File(const PbrtParameters& parameters, bool isTurned);
  PbrtShape Tessellated(const PbrtQuadric& quadric, const std::string& name, bool isTurned,
                        const Place& place);

  PbrtContext& context_;
  std::map<std::pair<std::string, bool>, scene::MeshIndex> files_;
  std::map<std::pair<PbrtQuadric, bool>, scene::MeshIndex> quadrics_;
};

// Meshes whose vertices stand in the statement. They throw Error where indices do not fit.
scene::Mesh PbrtTriangleMesh(const PbrtParameters& parameters, Findings& findings);
scene::Mesh PbrtBilinearMesh(const PbrtParameters& parameters, Findings& findings);

// Checks the numbers: throws Error where there is nothing left of the shape.
PbrtQuadric ReadQuadric(PbrtQuadric::Kind kind, const PbrtParameters& parameters);

// The whole shape as an analytic one, or nothing if it is cut, or turned inside out and no disk.
std::optional<PbrtShape> AnalyticQuadric(const PbrtQuadric& quadric, bool isTurned);

// With pbrt's normals and texture coordinates.
scene::Mesh QuadricMesh(const PbrtQuadric& quadric);

// Turns a mesh inside out.
void TurnInsideOut(scene::Mesh& mesh);

}  // namespace snell::io
