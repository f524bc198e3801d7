// SPDX-License-Identifier: Apache-2.0
//
// What the entities of an NFF file mean, collected into a Scene. The parser (nff.cpp) calls it in the order
// of the file and checks values first; Finish() makes what depends on the whole.
#pragma once

#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "util/error.h"

namespace snell::io {

// NFF's shading parameters: shares of the light that arrives, which need not add up to 1.
struct NffFill {
  scene::Spectrum color{1.0f};  // of the diffuse share
  float diffuse = 1;            // Kd
  float specular = 0;           // Ks: white highlights and mirror reflections
  float shine = 0;              // exponent of the highlights
  float transmittance = 0;      // T
  float ior = 1;
};

struct NffView {
  scene::vec3 from{0.0f};
  scene::vec3 at{0.0f};
  scene::vec3 up{0.0f};
  float angleDegrees = 45;  // from the middle of the topmost row of pixels to that of the lowest
  int width = 513;
  int height = 513;
};

class NffScene {
 public:
  // Warnings go to `warn`, which may be empty, when the scene is finished.
  NffScene(std::string file, const WarningSink& warn);

  void AddView(const NffView& view, const Place& place);
  void SetBackground(scene::Spectrum color);
  // Of a brightness that the number of lights decides.
  void AddLight(scene::vec3 position);
  void AddLight(scene::vec3 position, scene::Spectrum color);
  void SetFill(const NffFill& fill, const Place& place);
  // A negative radius asks for the inside only.
  void AddSphere(scene::vec3 center, float radius, const Place& place);
  void AddCone(scene::vec3 base, float radius, scene::vec3 top, float topRadius,
               const Place& place);
  // `normals` is empty or has one per corner.
  void AddPolygon(std::span<const scene::vec3> corners, std::span<const scene::vec3> normals,
                  const Place& place);

  // Throws Error if there is nothing to see. To be called once.
  scene::Scene Finish();

 private:
  // What a user should hear of once, with the first place and the number of times.
  enum Finding {
    NoFill,
    ShareAboveOne,
    InsideOnly,
    NoExtent,
    NoArea,
    CrossedOutline,
    WideView,
    FindingCount
  };
  struct Count {
    std::uint64_t times = 0;
    Place first;
  };

  void Note(Finding finding, const Place& place);
  void AddObject(scene::Geometry geometry, const Place& place);
  scene::MaterialIndex MaterialOf(const NffFill& fill, const Place& place);
  // The mesh that polygons go to until the fill changes.
  scene::Mesh& OpenMesh(const Place& place);
  void CloseMesh();
  void Warn() const;

  std::string file_;
  const WarningSink& warn_;
  scene::Scene scene_;
  std::vector<bool> lightHasColor_;
  std::map<std::array<float, 8>, scene::MaterialIndex> materialOf_;
  scene::MaterialIndex material_ = -1;
  scene::MeshIndex openMesh_ = -1;
  bool openMeshIsSmooth_ = false;
  std::array<Count, FindingCount> findings_;
};

}  // namespace snell::io
