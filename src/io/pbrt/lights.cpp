// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "image/read.h"
#include "io/mesh/text.h"
#include "io/pbrt/environment.h"

namespace snell::io {
namespace {

using scene::Spectrum;
constexpr double Pi = std::numbers::pi;
constexpr int MaxEnvironmentMaps = 16;

// The light's colour times its scale; `name` is L or I.
Spectrum Emitted(const PbrtParameters& parameters, std::string_view name, PbrtContext& context) {
  const auto spectrum = SpectrumOf(parameters, name, context);
  const float scale = std::max(parameters.Number("scale", 1), 0.0f);
  const Spectrum light = spectrum ? spectrum->Light() : Spectrum(1.0f);
  return glm::min(light * scale, Spectrum(1e30f));
}

class LightReader {
 public:
  LightReader(const PbrtParameters& parameters, const scene::Affine& toWorld, PbrtContext& context)
      : parameters_(parameters), toWorld_(toWorld), context_(context) {}

  void Read(const std::string& type) {
    light_.name = type;
    if (type == "infinite") return ReadInfinite();
    if (type == "distant") {
      ReadDistant();
    } else if (type == "spot" || type == "projection") {
      ReadSpot(type);
    } else if (type == "point" || type == "goniometric") {
      ReadPoint(type);
    } else {
      throw Error(fmt::format("there is no light of type {}", Quoted(type)), parameters_.place());
    }
    const bool isFinite = std::isfinite(glm::length(glm::dvec3(light_.position))) &&
                          std::abs(glm::length(light_.direction) - 1) < 1e-3f;
    if (isFinite) return context_.scene.lights.push_back(light_);
    context_.findings.Add("light", "without a place or a direction left out", type,
                          parameters_.place());
  }

 private:
  glm::dvec3 Point(const glm::dvec3& p) const { return glm::dvec3(toWorld_ * glm::dvec4(p, 1)); }

  // Where the light is and where it points.
  void Aim(const glm::dvec3& from, const glm::dvec3& to) {
    light_.position = scene::vec3(Point(from));
    light_.direction = scene::vec3(glm::normalize(Point(to) - Point(from)));
  }

  float Power() const { return std::clamp(parameters_.Number("power", 0), 0.0f, 1e30f); }

  void ReadDistant() {
    light_.kind = scene::LightKind::Directional;
    light_.color = Emitted(parameters_, "L", context_);
    if (const float illuminance = parameters_.Number("illuminance", 0); illuminance > 0)
      light_.strength = illuminance;
    Aim(parameters_.Vector("from", glm::dvec3(0.0)), parameters_.Vector("to", {0, 0, 1}));
    light_.position = scene::vec3(0.0f);
  }

  void ReadPoint(const std::string& type) {
    light_.color = Emitted(parameters_, "I", context_);
    if (Power() > 0) light_.strength = Power() / float(4 * Pi);
    light_.position = scene::vec3(Point(parameters_.Vector("from", glm::dvec3(0.0))));
    if (type != "goniometric") return;
    parameters_.Ignore({"filename"});
    context_.findings.Add("goniometric light", "replaced by a point light", "",
                          parameters_.place());
  }

  void ReadSpot(const std::string& type) {
    light_.kind = scene::LightKind::Spot;
    const bool isPicture = type == "projection";
    light_.color = Emitted(parameters_, "I", context_);
    double outer =
        double(isPicture ? parameters_.Number("fov", 90) / 2 : parameters_.Number("coneangle", 30));
    double inner = isPicture ? outer : outer - double(parameters_.Number("conedeltaangle", 5));
    outer = std::clamp(outer, 0.01, 179.0);
    inner = std::clamp(inner, 0.0, outer);
    light_.outerAngle = float(outer * Pi / 180);
    light_.innerAngle = float(inner * Pi / 180);
    if (Power() > 0) {
      const double full = 1 - std::cos(inner * Pi / 180);
      const double soft = std::cos(inner * Pi / 180) - std::cos(outer * Pi / 180);
      light_.strength = Power() / float(2 * Pi * (full + soft / 2));
    }
    Aim(parameters_.Vector("from", glm::dvec3(0.0)), parameters_.Vector("to", {0, 0, 1}));
    if (!isPicture) return;
    parameters_.Ignore({"filename"});
    context_.findings.Add("projection light", "replaced by a spot light without its picture", "",
                          parameters_.place());
  }

  // What is seen behind everything. Colours of several add up; a map stands alone.
  void ReadInfinite() {
    const std::string file = parameters_.String("filename", "");
    Spectrum emitted = Emitted(parameters_, "L", context_);
    if (const float illuminance = parameters_.Number("illuminance", 0); illuminance > 0)
      emitted *= illuminance / float(Pi);
    parameters_.Leave({"portal"}, "not used", context_.findings);
    scene::Environment& environment = context_.scene.environment;
    const bool isAlone = environment.map < 0 && environment.top == Spectrum(0.0f);
    if (environment.map >= 0 || (!file.empty() && !isAlone))
      return context_.findings.Add("infinite light", "left out: there is another beside a map",
                                   file, parameters_.place());
    environment.ambient = true;
    if (!file.empty()) return ReadMap(file, emitted);
    environment.top += emitted;
    environment.bottom += emitted;
  }

  void ReadMap(const std::string& file, const Spectrum& emitted) {
    const auto path = context_.files.Find(context_.folder, file);
    if (!path)
      return context_.findings.Add("environment map", "not found in the scene's folder: left out",
                                   file, parameters_.place());
    if (++context_.environmentMaps > MaxEnvironmentMaps)
      throw Error("the scene has too many environment maps", parameters_.place());
    image::Image map;
    try {
      map = image::ReadImage(*path);
    } catch (const Error& error) {
      return context_.findings.Add("environment map",
                                   "left out: " + error.diagnostics().front().message, file,
                                   parameters_.place());
    }
    const double volume = glm::determinant(glm::dmat3(toWorld_));
    if (!std::isfinite(volume) || volume == 0)
      return context_.findings.Add("environment map", "with a singular transform left out", file,
                                   parameters_.place());
    scene::Scene& scene = context_.scene;
    scene.environment.map = scene::ImageIndex(scene.images.size());
    scene.environment.mapScale = emitted;
    scene.images.push_back(PanoramaOf(map, toWorld_));
    scene.images.back().name = path->string();
  }

  const PbrtParameters& parameters_;
  const scene::Affine& toWorld_;
  PbrtContext& context_;
  scene::Light light_;
};

}  // namespace

void AddLight(const std::string& type, const PbrtParameters& parameters,
              const scene::Affine& toWorld, PbrtContext& context) {
  LightReader(parameters, toWorld, context).Read(type);
  parameters.ReportUnused(context.findings);
}

PbrtAreaLight ReadAreaLight(const std::string& type, const PbrtParameters& parameters,
                            PbrtContext& context) {
  if (type != "diffuse" && type != "area")
    throw Error(fmt::format("there is no area light of type {}", Quoted(type)), parameters.place());
  PbrtAreaLight light;
  light.radiance = Emitted(parameters, "L", context);
  light.power = std::clamp(parameters.Number("power", 0), 0.0f, 1e30f);
  light.isTwoSided = parameters.Bool("twosided", false);
  parameters.Ignore({"samples", "nsamples"});
  parameters.Leave({"filename"}, "left out: the light is of one colour", context.findings);
  parameters.ReportUnused(context.findings);
  return light;
}

}  // namespace snell::io
