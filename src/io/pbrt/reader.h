// SPDX-License-Identifier: Apache-2.0
//
// Reads a pbrt scene statement by statement: keeps the graphics state and hands what the statements describe to
// the parts that make the scene.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/pbrt/context.h"
#include "io/pbrt/lights.h"
#include "io/pbrt/materials.h"
#include "io/pbrt/parameters.h"
#include "io/pbrt/shapes.h"
#include "io/pbrt/textures.h"
#include "io/pbrt/view.h"

namespace snell::io {

// What AttributeBegin saves and AttributeEnd brings back.
struct PbrtState {
  scene::Affine transform{1.0};     // at the start of all movement
  scene::Affine transformEnd{1.0};  // and at its end
  bool startCounts = true;          // which of them statements change
  bool endCounts = true;
  bool isReversed = false;
  int material = 0;
  std::optional<PbrtAreaLight> areaLight;
  image::Chromaticities colorSpace;
  PbrtDefaults shapes, lights, materials, media, textures;
};

class PbrtReader {
 public:
  explicit PbrtReader(PbrtContext& context)
      : context_(context),
        view_(context),
        textures_(context),
        materials_(context, textures_),
        shapes_(context) {}

  // The scene of the context's file; `text` is what stands in it.
  void Read(std::string_view text);

 private:
  struct Statement {
    std::string_view name;
    void (PbrtReader::*read)();
  };
  static const std::vector<Statement>& Statements();

  // Statements of one file; `place` is that of the Include.
  void ReadText(std::string_view text, const std::string& file);
  void ReadFileOf(const std::string& name, const Place& place);
  void ReadStatement();

  // Words of the current statement
  std::string String(std::string_view what);
  std::vector<double> Numbers(std::size_t count);
  PbrtParameters Parameters(std::string_view title);
  void RequireWorld(bool isInWorld) const;

  // Transforms (transforms.cpp)
  void Identity();
  void Translate();
  void Scale();
  void Rotate();
  void LookAt();
  void Transform();
  void ConcatTransform();
  void CoordinateSystem();
  void CoordSysTransform();
  void ActiveTransform();
  void TransformTimes();
  void Concat(const scene::Affine& map);
  void Replace(const scene::Affine& start, const scene::Affine& end);
  scene::Motion MotionOf(const scene::Affine& toObject) const;
  scene::Affine Matrix();

  // The state (directives.cpp)
  void AttributeBegin();
  void AttributeEnd();
  void TransformBegin();
  void TransformEnd();
  void Push(char kind);
  void Pop(char kind);
  void Attribute();
  void ReverseOrientation();
  void ColorSpace();
  void Include();
  void Import();
  void WorldBegin();
  void WorldEnd();

  // Options
  void Camera();
  void Film();
  void Sampler();
  void PixelFilter();
  void Integrator();
  void Option();
  void Accelerator();

  // The world
  void Material();
  void MakeNamedMaterial();
  void NamedMaterial();
  void Texture();
  void MakeNamedMedium();
  void MediumInterface();
  void LightSource();
  void AreaLightSource();
  void Shape();
  void ObjectBegin();
  void ObjectEnd();
  void ObjectInstance();
  void AddObject(scene::Object object);

  struct Saved {
    PbrtState state;
    char kind;  // of bracket: attribute, transform, object or file
    Place place;
  };

  PbrtContext& context_;
  PbrtView view_;
  PbrtTextures textures_;
  PbrtMaterials materials_;
  PbrtShapes shapes_;

  PbrtState state_;
  std::vector<Saved> saved_;
  std::map<std::string, std::pair<scene::Affine, scene::Affine>> coordinateSystems_;
  double movementStart_ = 0;  // seconds
  double movementEnd_ = 1;
  bool isInWorld_ = false;
  scene::Affine fromPbrt_{1.0};

  std::map<std::string, std::vector<scene::Object>> objects_;  // by name, in pbrt's world
  std::vector<scene::Object>* openObject_ = nullptr;
  std::string openName_;

  PbrtWords* words_ = nullptr;  // of the file that is being read
  Place place_;                 // of the statement
  std::string_view statement_;
  std::vector<std::string> openFiles_;
  std::uint64_t filesRead_ = 0;
  std::uint64_t bytesRead_ = 0;
};

}  // namespace snell::io
