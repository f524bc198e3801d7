// SPDX-License-Identifier: Apache-2.0
//
// Longer than 400 lines because each record has its rules, and all are checked here.
#include "scene/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "scene/motion.h"

namespace snell::scene {

namespace {

bool Finite(float x) { return std::isfinite(x); }
bool Finite(vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
bool NonZero(vec3 v) { return Finite(v) && glm::dot(glm::dvec3(v), glm::dvec3(v)) > 0; }
bool Positive(float x) { return std::isfinite(x) && x > 0; }
bool NonNegative(Spectrum s) { return Finite(s) && s.x >= 0 && s.y >= 0 && s.z >= 0; }
bool Reflectance(Spectrum s) { return NonNegative(s) && s.x <= 1 && s.y <= 1 && s.z <= 1; }

// Columns that are finite and span space.
bool Invertible(const Affine& m) {
  double size = 1;
  for (int column = 0; column < 3; ++column) size *= glm::length(glm::dvec3(m[column]));
  const double determinant = glm::determinant(glm::dmat3(m));
  const double reach = glm::length(glm::dvec3(m[3]));
  return std::isfinite(determinant) && std::isfinite(reach) && size > 0 &&
         std::abs(determinant) > 1e-12 * size;
}

class Checker {
 public:
  explicit Checker(const Scene& scene) : scene_(scene) {}

  void CheckAll() {
    CheckSettings(scene_.settings);
    for (const Camera& camera : scene_.cameras) CheckCamera(camera);
    Require(NonNegative(scene_.environment.bottom) && NonNegative(scene_.environment.top),
            "the environment's colours must be finite and not negative");
    Require(Finite(scene_.environment.bottomElevation) && Finite(scene_.environment.topElevation) &&
                scene_.environment.bottomElevation < scene_.environment.topElevation,
            "the environment's gradient needs its bottom below its top");
    Require(scene_.environment.map >= -1 && scene_.environment.map < int(scene_.images.size()) &&
                scene_.environment.sun >= -1 && scene_.environment.sun < int(scene_.lights.size()),
            "the environment refers to a picture or a light that does not exist");
    Require(NonNegative(scene_.environment.mapScale) && Finite(scene_.environment.rotation),
            "the environment's map needs a finite strength and rotation");
    Require(Positive(scene_.environment.ior),
            "the surroundings' index of refraction must be positive");
    CheckMedium(scene_.environment.medium, "the surroundings' medium");
    Require(scene_.environment.medium.grid < 0, "the surroundings' medium cannot have a grid");
    for (const DensityGrid& grid : scene_.grids) CheckGrid(grid);
    for (const Light& light : scene_.lights) CheckLight(light);
    for (const LightProfile& profile : scene_.profiles) CheckProfile(profile);
    CheckLightGroups(LightGroupsOf(scene_));
    for (const Image& image : scene_.images) CheckImage(image);
    for (const Texture& texture : scene_.textures) CheckTexture(texture);
    for (const Material& material : scene_.materials) CheckMaterial(material);
    for (const Mesh& mesh : scene_.meshes) CheckMesh(mesh);
    for (const Object& object : scene_.objects) CheckObject(object);
    ThrowFindings();
  }

  void CheckLightGroups(const std::vector<std::string>& groups) {
    Require(groups.size() <= kernel::MaxLightGroups,
            fmt::format("the scene names {} light groups; there may be {} at most",
                        groups.size() - 1, kernel::MaxLightGroups - 1));
    for (const std::string& name : groups)
      Require(name.empty() || IsLightGroupName(name),
              fmt::format("'{}' cannot be the name of a light group", name));
  }

  void CheckSettings(const RenderSettings& s) {
    Require(s.width > 0 && s.height > 0 && s.width <= 65536 && s.height <= 65536,
            fmt::format("the picture's size {}×{} is not between 1 and 65536", s.width, s.height));
    Require(s.spp >= 0, "the samples per pixel must not be negative");
    Require(s.maxDepth > 0, "the maximum depth must be at least 1");
    Require(s.maxVolumeDepth >= 0, "the maximum depth in media must not be negative");
    Require(std::min({s.maxDiffuseDepth, s.maxSpecularDepth, s.maxTransmissionDepth}) >= 0,
            "the maximum depths by kind must not be negative");
    Require(Finite(s.minContribution) && s.minContribution >= 0,
            "the minimum contribution must not be negative");
    Require(Finite(s.clampIndirect) && s.clampIndirect >= 0,
            "the limit of indirect light must not be negative");
    Require(Finite(s.filterRadius) && s.filterRadius >= 0,
            "the filter's radius must not be negative");
    Require(Finite(s.exposure), "the exposure must be finite");
  }

  void ThrowFindings() {
    if (!findings_.empty()) throw Error(std::move(findings_));
  }

 private:
  void Require(bool condition, std::string message, const Place& place = {}) {
    if (condition) return;
    Place where = place;
    if (where.file.empty()) where.file = scene_.name;
    findings_.push_back({std::move(message), where});
  }

  void CheckCamera(const Camera& camera) {
    const auto bad = [&](const char* what) {
      return fmt::format("camera '{}' {}", camera.name, what);
    };
    const vec3 forward = camera.lookAt - camera.position;
    Require(NonZero(forward), bad("looks at its own position"));
    if (NonZero(forward)) {
      const glm::dvec3 side = glm::cross(glm::dvec3(forward), glm::dvec3(camera.up));
      Require(glm::length(side) >
                  1e-9 * glm::length(glm::dvec3(forward)) * glm::length(glm::dvec3(camera.up)),
              bad("looks along its up vector"));
    }
    switch (camera.kind) {
      case CameraKind::Pinhole:
        Require(Positive(camera.fov) && camera.fov < 3.1415f,
                bad("needs a field of view between 0 and 180 degrees"));
        break;
      case CameraKind::Orthographic:
        Require(Positive(camera.height), bad("needs a positive height"));
        break;
      case CameraKind::Panorama: {
        const float width = std::abs(camera.longitude.y - camera.longitude.x);
        Require(width > 0 && width < 6.2832f && std::abs(camera.longitude.x) < 12.6f,
                bad("needs two longitudes, at most 360 degrees apart"));
        Require(camera.latitude.x >= -1.5708f && camera.latitude.x < camera.latitude.y &&
                    camera.latitude.y <= 1.5708f,
                bad("needs latitudes that rise, from -90 to 90 degrees"));
        break;
      }
      case CameraKind::Fisheye: {
        const bool open = camera.projection == FisheyeProjection::Stereographic;
        Require(Positive(camera.fov) && camera.fov < (open ? 6.2831f : 6.2832f),
                bad("needs an angle of view above 0 and up to 360 degrees"));
        break;
      }
    }
    Require(std::isfinite(camera.shift.x) && std::isfinite(camera.shift.y),
            bad("needs a finite shift"));
    const Lens& lens = camera.lens;
    Require(Finite(lens.radius) && lens.radius >= 0 && lens.blades >= 0 && lens.blades != 1 &&
                lens.blades != 2 && Finite(lens.bladeRotation) && Positive(lens.ratio),
            bad("needs an aperture that is round or has three blades or more"));
    CheckMotion(camera.motion, bad("needs motion that rises in time and keeps its frame"), {});
    Require(std::isfinite(camera.shutterOpen) && std::isfinite(camera.shutterClose) &&
                camera.shutterOpen <= camera.shutterClose,
            bad("needs a shutter that closes after it opens"));
    Require(lens.radius == 0 || Positive(lens.focusDistance),
            bad("needs a positive distance of focus"));
  }

  void CheckMotion(const Motion& motion, const std::string& message, const Place& place) {
    if (motion.empty()) return;
    bool sound = true;
    for (std::size_t i = 0; i < motion.size(); ++i) {
      sound = sound && std::isfinite(motion[i].time) && Invertible(motion[i].place) &&
              (i == 0 || motion[i - 1].time < motion[i].time);
    }
    Require(sound && KeepsHandedness(motion), message, place);
  }

  void CheckLight(const Light& light) {
    const auto bad = [&](const char* what) {
      return fmt::format("light '{}' {}", light.name, what);
    };
    Require(NonNegative(light.color) && Finite(light.strength) && light.strength >= 0,
            bad("needs a finite strength that is not negative"));
    Require(Finite(light.position) && NonZero(light.direction),
            bad("needs a position and a direction"));
    Require(Finite(light.radius) && light.radius >= 0 && Finite(light.range) && light.range >= 0,
            bad("has a negative radius or range"));
    Require(light.samples > 0, bad("needs at least one sample"));
    if (light.kind == LightKind::Directional) {
      Require(light.angularSize >= 0 && light.angularSize < 3.1416f,
              bad("needs an angular size between 0 and 180 degrees"));
    }
    if (light.falloff == Falloff::Linear)
      Require(Positive(light.falloffFactor), bad("needs a positive falloff factor"));
    if (light.kind == LightKind::Spot) {
      Require(light.innerAngle >= 0 && light.innerAngle <= light.outerAngle &&
                  light.outerAngle < 3.1416f,
              bad("needs 0 ≤ inner angle ≤ outer angle ≤ 180 degrees"));
    }
    Require(
        light.profile >= -1 && light.profile < int(scene_.profiles.size()) &&
            (light.profile < 0 || light.kind == LightKind::Point || light.kind == LightKind::Spot),
        bad("refers to a profile that does not exist, or cannot have one"));
    if (light.profile >= 0)
      Require(NonZero(glm::cross(light.edgeU, light.direction)) && NonZero(light.edgeV),
              bad("needs a direction for the horizontal angle 0"));
    if (light.kind == LightKind::Disk || light.kind == LightKind::Sphere) {
      Require(Positive(light.radius), bad("needs a positive radius"));
    }
    if (light.kind == LightKind::Rectangle || light.kind == LightKind::Triangle) {
      Require(NonZero(glm::cross(light.edgeU, light.edgeV)), bad("has no area"));
    }
  }

  void CheckImage(const Image& image) {
    const std::size_t channels =
        4 * std::size_t(std::max(image.width, 0)) * std::size_t(std::max(image.height, 0));
    const bool whole = image.bytes.size() + image.floats.size() == channels &&
                       (image.bytes.empty() || image.floats.empty());
    Require(channels > 0 && whole,
            fmt::format("the picture '{}' has not as many texels as its size says", image.name));
  }

  void CheckTexture(const Texture& texture) {
    const auto bad = [&](const char* what) {
      return fmt::format("texture '{}' {}", texture.name, what);
    };
    Require(Invertible(texture.placement), bad("has a singular placement"));
    Require(NonNegative(texture.colorA) && NonNegative(texture.colorB),
            bad("needs finite colours that are not negative"));
    Require(Finite(texture.turbulence), bad("needs a finite turbulence"));
    Require(texture.octaves >= 1 && texture.octaves <= 16, bad("needs 1 to 16 octaves"));
    const bool shows = texture.kind == TextureKind::Image;
    Require(shows ? texture.image >= 0 && texture.image < int(scene_.images.size())
                  : texture.image == -1,
            bad("refers to a picture that does not exist"));
    Require(texture.uvSet == 0 || texture.uvSet == 1, bad("needs the coordinates 0 or 1"));
  }

  void CheckColor(const ColorInput& input, bool reflectance, const std::string& what) {
    Require(input.texture >= -1 && input.texture < int(scene_.textures.size()),
            fmt::format("{} refers to a texture that does not exist", what));
    if (reflectance) {
      Require(Reflectance(input.value), fmt::format("{} must lie between 0 and 1", what));
    } else {
      Require(NonNegative(input.value), fmt::format("{} must be finite and not negative", what));
    }
  }

  void CheckMaterial(const Material& material) {
    const auto of = [&](const char* what) {
      return fmt::format("material '{}': {}", material.name, what);
    };
    CheckMaps(material, of("a map"));
    if (material.volume) CheckMedium(*material.volume, of("the medium"));
    if (material.physical) return CheckPhysical(*material.physical, of("the physical material"));
    CheckColor(material.emission, false, of("the emission"));
    CheckColor(material.reflectivity, true, of("the reflectivity"));
    CheckColor(material.transparency, true, of("the transparency"));
    for (const Term& term : material.terms) {
      CheckColor(term.color, true, of("the colour of a term"));
      Require(Finite(term.exponent) && term.exponent >= 0, of("an exponent must not be negative"));
    }
    Require(Positive(material.ior), of("the index of refraction must be positive"));
    Require(Reflectance(material.attenuationColor),
            of("the attenuation colour must lie between 0 and 1"));
    Require(material.attenuationDistance > 0, of("the attenuation distance must be positive"));
  }

  bool IsTexture(TextureIndex texture) const {
    return texture >= -1 && texture < int(scene_.textures.size());
  }

  bool Sound(const ScalarInput& input) const {
    return IsTexture(input.texture) && Finite(input.value) && input.value >= 0 &&
           input.channel >= 0 && input.channel <= 3;
  }

  void CheckMaps(const Material& material, const std::string& what) {
    Require(IsTexture(material.normalMap.texture) && IsTexture(material.bumpMap.texture) &&
                Sound(material.opacity),
            fmt::format("{} refers to a texture that does not exist", what));
    Require(Finite(material.normalMap.scale) && Finite(material.bumpMap.scale) &&
                Finite(material.alphaCutoff),
            fmt::format("{} needs a finite scale", what));
    const Displacement& d = material.displacement;
    Require(IsTexture(d.texture) && d.channel >= 0 && d.channel <= 3 && Finite(d.scale) &&
                Finite(d.middle) && Sound(d.target) && (d.target.pixels > 0 || d.target.length > 0),
            fmt::format("{} of displacement is not sound", what));
  }

  static bool Sound(const EdgeTarget& target) {
    return Finite(target.pixels) && target.pixels >= 0 && Finite(target.length) &&
           target.length >= 0;
  }

  void CheckMedium(const Medium& m, const std::string& what) {
    Require(NonNegative(m.absorption) && NonNegative(m.scattering) && NonNegative(m.emission) &&
                Finite(m.density) && m.density >= 0,
            fmt::format("{} needs finite coefficients that are not negative", what));
    Require(Finite(m.anisotropy) && std::abs(m.anisotropy) < 1,
            fmt::format("{} needs an anisotropy between -1 and 1", what));
    Require(m.grid >= -1 && m.grid < int(scene_.grids.size()),
            fmt::format("{} refers to a grid that does not exist", what));
  }

  void CheckProfile(const LightProfile& p) {
    const auto angles = [](const std::vector<float>& list, std::size_t least, float most) {
      return list.size() >= least && std::ranges::is_sorted(list) && list.front() >= 0 &&
             list.back() <= most;
    };
    Require(
        angles(p.verticals, 2, 3.1416f) && angles(p.horizontals, 1, 6.2832f) &&
            p.intensities.size() == p.verticals.size() * p.horizontals.size() &&
            std::ranges::all_of(p.intensities, [](float x) { return std::isfinite(x) && x >= 0; }),
        fmt::format("the profile '{}' needs rising angles and an intensity for each", p.name));
  }

  void CheckGrid(const DensityGrid& grid) {
    const int bricks = int(grid.values.size() / 512);
    const auto isBrick = [&](int number) { return number >= -1 && number < bricks; };
    Require(grid.values.size() % 512 == 0 && std::ranges::all_of(grid.table, isBrick) &&
                grid.table.size() ==
                    std::size_t(grid.bricks.x) * grid.bricks.y * std::size_t(grid.bricks.z),
            fmt::format("the grid '{}' has a table that does not match its values", grid.name));
    Require(std::ranges::all_of(grid.values,
                                [](float value) { return std::isfinite(value) && value >= 0; }),
            fmt::format("the grid '{}' needs finite densities that are not negative", grid.name));
  }

  void CheckPhysical(const OpenPbr& m, const std::string& what) {
    for (const ColorInput* color :
         {&m.baseColor, &m.specularColor, &m.transmissionColor, &m.diffuseTransmissionColor,
          &m.subsurfaceColor, &m.coatColor, &m.fuzzColor, &m.emission})
      CheckColor(*color, false, what);
    for (const ScalarInput* input :
         {&m.baseMetalness, &m.specularWeight, &m.specularRoughness, &m.specularRoughnessAnisotropy,
          &m.transmissionWeight, &m.diffuseTransmissionWeight, &m.subsurfaceWeight, &m.coatWeight,
          &m.coatRoughness, &m.fuzzWeight, &m.fuzzRoughness, &m.thinFilmWeight,
          &m.thinFilmThickness})
      Require(Sound(*input), fmt::format("{} has a weight that is not sound", what));
    Require(IsTexture(m.coatNormal.texture),
            fmt::format("{} refers to a texture that does not exist", what));
    Require(Positive(m.specularIor) && Positive(m.coatIor) && Positive(m.thinFilmIor),
            fmt::format("{} needs positive indices of refraction", what));
    Require(Finite(m.transmissionDepth) && m.transmissionDepth >= 0 &&
                NonNegative(m.transmissionColor.value) && NonNegative(m.transmissionScatter) &&
                Finite(m.transmissionScatterAnisotropy) && Positive(m.subsurfaceRadius) &&
                NonNegative(m.subsurfaceRadiusScale) && Finite(m.subsurfaceScatterAnisotropy) &&
                Finite(m.baseWeight) && m.baseWeight >= 0 && Finite(m.thinFilmThicknessLeast) &&
                m.thinFilmThicknessLeast >= 0 && Finite(m.transmissionDispersionScale) &&
                m.transmissionDispersionScale >= 0 && Finite(m.transmissionDispersionAbbeNumber) &&
                m.transmissionDispersionAbbeNumber >= 0 && Finite(m.coatRoughnessAnisotropy) &&
                Finite(m.anisotropyRotation),
            fmt::format("{} needs finite numbers that are not negative", what));
  }

  void CheckMesh(const Mesh& mesh) {
    const auto bad = [&](const char* what) { return fmt::format("mesh '{}' {}", mesh.name, what); };
    Require(mesh.normals.empty() || mesh.normals.size() == mesh.positions.size(),
            bad("has too few normals"));
    Require(mesh.uvs.empty() || mesh.uvs.size() == mesh.positions.size(),
            bad("has too few texture coordinates"));
    const auto fits = [&](const auto& attribute) {
      return attribute.empty() || attribute.size() == mesh.positions.size();
    };
    Require(fits(mesh.uvs1) && fits(mesh.tangents) && fits(mesh.colors),
            bad("has too few coordinates, tangents or colours"));
    Require(mesh.joins.empty() || mesh.joins.size() == mesh.triangles.size(),
            bad("has too few joins of triangles"));
    double time = mesh.time;
    for (const MeshKey& key : mesh.keys) {
      Require(key.time > time && std::isfinite(key.time) &&
                  key.positions.size() == mesh.positions.size() &&
                  key.normals.size() == mesh.normals.size() &&
                  key.tangents.size() == mesh.tangents.size(),
              bad("needs keys with all its vertices that rise in time"));
      time = key.time;
    }
    for (const uvec3& t : mesh.triangles) {
      if (t.x < mesh.positions.size() && t.y < mesh.positions.size() && t.z < mesh.positions.size())
        continue;
      Require(false, bad("has a triangle whose vertex does not exist"));
      return;
    }
  }

  void CheckObject(const Object& object) {
    const auto bad = [&](const char* what) {
      return fmt::format("object '{}' {}", object.name, what);
    };
    Require(object.material >= 0 && object.material < int(scene_.materials.size()),
            bad("has no material"), object.place);
    Require(Invertible(object.toWorld), bad("has a singular transform"), object.place);
    CheckMotion(object.motion, bad("needs motion by invertible maps that rises in time"),
                object.place);
    const Subdivision& subdivision = object.subdivision;
    Require(subdivision.levels >= 0 && subdivision.levels <= 10 && Sound(subdivision.target),
            bad("needs 0 to 10 levels of subdivision"), object.place);
    std::visit(
        [&](const auto& geometry) { Require(Sound(geometry), bad("has no extent"), object.place); },
        object.geometry);
  }

  bool Sound(const Sphere& s) const { return Finite(s.center) && Positive(s.radius); }
  bool Sound(const Plane& s) const { return Finite(s.point) && NonZero(s.normal); }
  bool Sound(const Disk& s) const {
    return Finite(s.center) && NonZero(s.normal) && Positive(s.radius) && s.innerRadius >= 0 &&
           s.innerRadius < s.radius;
  }
  bool Sound(const Rectangle& s) const {
    return Finite(s.corner) && NonZero(glm::cross(s.edgeU, s.edgeV));
  }
  bool Sound(const Box& s) const {
    return Finite(s.lower) && Finite(s.upper) && s.lower.x < s.upper.x && s.lower.y < s.upper.y &&
           s.lower.z < s.upper.z;
  }
  bool Sound(const Cone& s) const {
    return Finite(s.base) && NonZero(s.top - s.base) && s.radius >= 0 && s.topRadius >= 0 &&
           Positive(s.radius + s.topRadius);
  }
  bool Sound(const Torus& s) const {
    return Finite(s.center) && NonZero(s.axis) && Positive(s.majorRadius) &&
           Positive(s.minorRadius) && s.minorRadius <= s.majorRadius;
  }
  bool Sound(const MeshGeometry& g) const {
    return g.mesh >= 0 && g.mesh < int(scene_.meshes.size());
  }

  const Scene& scene_;
  std::vector<Diagnostic> findings_;
};

// Whether any light, emission or background can reach the camera.
bool HasLight(const Scene& scene) {
  if (!scene.lights.empty()) return true;
  if (scene.environment.map >= 0) return true;
  if (scene.environment.medium.emission != Spectrum(0.0f)) return true;
  if (scene.environment.bottom != Spectrum(0.0f) || scene.environment.top != Spectrum(0.0f))
    return true;
  for (const Object& object : scene.objects) {
    const Material& material = scene.materials[std::size_t(object.material)];
    const ColorInput& emission =
        material.physical ? material.physical->emission : material.emission;
    if (emission.value != Spectrum(0.0f)) return true;
    if (material.volume && material.volume->emission != Spectrum(0.0f)) return true;
  }
  return false;
}

}  // namespace

void Validate(const RenderSettings& settings) {
  const Scene none;
  Checker checker(none);
  checker.CheckSettings(settings);
  checker.ThrowFindings();
}

void Validate(const Scene& scene, const WarningSink& warn) {
  Checker(scene).CheckAll();
  if (!warn) return;
  if (scene.objects.empty()) {
    warn({"the scene has no objects", {scene.name}});
  } else if (!HasLight(scene)) {
    warn({"nothing in the scene shines, so the picture will be black",
          {scene.name},
          "add a [[light]]"});
  }
}

}  // namespace snell::scene
