// SPDX-License-Identifier: Apache-2.0
//
// Validation: sound scenes pass, each fault alone is found and named, and all faults together are all told.
#include "scene/validate.h"

#include <gtest/gtest.h>

#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

namespace snell::scene {
namespace {

constexpr float NaN = std::numeric_limits<float>::quiet_NaN();
constexpr float Inf = std::numeric_limits<float>::infinity();

// One of everything, all sound.
Scene Sound() {
  Scene scene;
  scene.name = "sound.toml";
  scene.cameras.resize(2);
  scene.cameras[0].name = "first";
  scene.cameras[1].kind = CameraKind::Orthographic;
  for (const LightKind kind :
       {LightKind::Ambient, LightKind::Directional, LightKind::Point, LightKind::Spot,
        LightKind::Rectangle, LightKind::Triangle, LightKind::Disk, LightKind::Sphere}) {
    Light light;
    light.kind = kind;
    light.radius = 1;
    light.outerAngle = 1;
    light.falloff = Falloff::Linear;
    scene.lights.push_back(light);
  }
  Texture texture;
  texture.name = "spots";
  scene.textures.push_back(texture);
  Material material;
  material.name = "paint";
  material.terms.resize(1);
  material.terms[0].color.texture = 0;
  scene.materials.push_back(material);
  Mesh mesh;
  mesh.name = "sheet";
  mesh.positions = {vec3(0), vec3(1, 0, 0), vec3(0, 1, 0)};
  mesh.normals.resize(3, vec3(0, 0, 1));
  mesh.uvs.resize(3);
  mesh.triangles = {{0, 1, 2}};
  scene.meshes.push_back(mesh);
  for (const Geometry& geometry :
       {Geometry(Sphere{}), Geometry(Plane{}), Geometry(Disk{}), Geometry(Rectangle{}),
        Geometry(Box{}), Geometry(Cone{}), Geometry(Torus{}), Geometry(MeshGeometry{0})}) {
    Object object;
    object.name = "thing";
    object.geometry = geometry;
    object.material = 0;
    scene.objects.push_back(object);
  }
  return scene;
}

std::vector<Diagnostic> FindingsOf(const Scene& scene) {
  try {
    Validate(scene, nullptr);
  } catch (const Error& error) {
    return error.diagnostics();
  }
  return {};
}

template <class Shape>
Shape& The(Scene& scene) {
  for (Object& object : scene.objects) {
    if (Shape* shape = std::get_if<Shape>(&object.geometry)) return *shape;
  }
  throw std::logic_error("no such shape");
}
Light& The(Scene& scene, LightKind kind) { return scene.lights.at(std::size_t(kind)); }

struct Fault {
  std::string words;  // of the message
  std::function<void(Scene&)> make;
};

const std::vector<Fault>& Faults() {
  static const std::vector<Fault> faults = {
      {"size 0×600", [](Scene& s) { s.settings.width = 0; }},
      {"size 800×65537", [](Scene& s) { s.settings.height = 65537; }},
      {"samples per pixel", [](Scene& s) { s.settings.spp = -1; }},
      {"maximum depth", [](Scene& s) { s.settings.maxDepth = 0; }},
      {"minimum contribution", [](Scene& s) { s.settings.minContribution = NaN; }},
      {"minimum contribution", [](Scene& s) { s.settings.minContribution = -1; }},
      {"filter's radius", [](Scene& s) { s.settings.filterRadius = Inf; }},
      {"exposure", [](Scene& s) { s.settings.exposure = NaN; }},
      {"camera 'first' looks at its own position",
       [](Scene& s) { s.cameras[0].lookAt = s.cameras[0].position; }},
      {"camera 'first' looks at", [](Scene& s) { s.cameras[0].position.x = Inf; }},
      {"along its up vector", [](Scene& s) { s.cameras[0].up = vec3(0, 0, 2); }},
      {"along its up vector", [](Scene& s) { s.cameras[0].up = vec3(0); }},
      {"along its up vector", [](Scene& s) { s.cameras[0].up = vec3(NaN); }},
      {"field of view", [](Scene& s) { s.cameras[0].fov = 0; }},
      {"field of view", [](Scene& s) { s.cameras[0].fov = 3.15f; }},
      {"positive height", [](Scene& s) { s.cameras[1].height = -1; }},
      {"environment's colours", [](Scene& s) { s.environment.top.y = -1; }},
      {"environment's gradient", [](Scene& s) { s.environment.topElevation = -2; }},
      {"environment's gradient", [](Scene& s) { s.environment.topElevation = Inf; }},
      {"surroundings' index", [](Scene& s) { s.environment.ior = 0; }},
      {"finite strength", [](Scene& s) { The(s, LightKind::Point).strength = -1; }},
      {"finite strength", [](Scene& s) { The(s, LightKind::Ambient).color.x = NaN; }},
      {"position and a direction", [](Scene& s) { The(s, LightKind::Point).position.x = Inf; }},
      {"position and a direction", [](Scene& s) { The(s, LightKind::Disk).direction = vec3(0); }},
      {"radius or range", [](Scene& s) { The(s, LightKind::Spot).radius = -1; }},
      {"radius or range", [](Scene& s) { The(s, LightKind::Spot).range = NaN; }},
      {"at least one sample", [](Scene& s) { The(s, LightKind::Disk).samples = 0; }},
      {"angular size", [](Scene& s) { The(s, LightKind::Directional).angularSize = NaN; }},
      {"angular size", [](Scene& s) { The(s, LightKind::Directional).angularSize = 4; }},
      {"falloff factor", [](Scene& s) { The(s, LightKind::Point).falloffFactor = 0; }},
      {"inner angle", [](Scene& s) { The(s, LightKind::Spot).innerAngle = 1.1f; }},
      {"inner angle", [](Scene& s) { The(s, LightKind::Spot).outerAngle = NaN; }},
      {"positive radius", [](Scene& s) { The(s, LightKind::Sphere).radius = 0; }},
      {"no area", [](Scene& s) { The(s, LightKind::Triangle).edgeU = vec3(0, 0, 3); }},
      {"texture 'spots' has a singular", [](Scene& s) { s.textures[0].placement[1] = {}; }},
      {"texture 'spots' needs finite colours", [](Scene& s) { s.textures[0].colorB.z = -1; }},
      {"turbulence", [](Scene& s) { s.textures[0].turbulence = NaN; }},
      {"octaves", [](Scene& s) { s.textures[0].octaves = 1000000000; }},
      {"material 'paint': the emission must be",
       [](Scene& s) { s.materials[0].emission.value.x = -1; }},
      {"reflectivity must lie", [](Scene& s) { s.materials[0].reflectivity.value.x = 1.1f; }},
      {"transparency must lie", [](Scene& s) { s.materials[0].transparency.value.x = NaN; }},
      {"texture that does not exist", [](Scene& s) { s.materials[0].emission.texture = 1; }},
      {"texture that does not exist", [](Scene& s) { s.materials[0].emission.texture = -2; }},
      {"colour of a term", [](Scene& s) { s.materials[0].terms[0].color.value.x = 2; }},
      {"exponent", [](Scene& s) { s.materials[0].terms[0].exponent = -1; }},
      {"index of refraction", [](Scene& s) { s.materials[0].ior = 0; }},
      {"attenuation colour", [](Scene& s) { s.materials[0].attenuationColor.x = 2; }},
      {"attenuation distance", [](Scene& s) { s.materials[0].attenuationDistance = 0; }},
      {"mesh 'sheet' has too few normals", [](Scene& s) { s.meshes[0].normals.pop_back(); }},
      {"too few texture coordinates", [](Scene& s) { s.meshes[0].uvs.pop_back(); }},
      {"vertex does not exist", [](Scene& s) { s.meshes[0].triangles[0].z = 3; }},
      {"object 'thing' has no material", [](Scene& s) { s.objects[0].material = -1; }},
      {"object 'thing' has no material", [](Scene& s) { s.objects[0].material = 1; }},
      {"singular transform", [](Scene& s) { s.objects[0].toWorld[0] = s.objects[0].toWorld[1]; }},
      {"singular transform", [](Scene& s) { s.objects[0].toWorld[2][2] = double(NaN); }},
      {"singular transform", [](Scene& s) { s.objects[0].toWorld[3][0] = double(NaN); }},
      {"singular transform", [](Scene& s) { s.objects[0].toWorld[3][1] = double(Inf); }},
      {"no extent", [](Scene& s) { The<Sphere>(s).radius = -1; }},
      {"no extent", [](Scene& s) { The<Sphere>(s).center.y = NaN; }},
      {"no extent", [](Scene& s) { The<Plane>(s).normal = vec3(0); }},
      {"no extent", [](Scene& s) { The<Disk>(s).innerRadius = 1; }},
      {"no extent", [](Scene& s) { The<Disk>(s).innerRadius = NaN; }},
      {"no extent", [](Scene& s) { The<Rectangle>(s).edgeV = vec3(2, 0, 0); }},
      {"no extent", [](Scene& s) { The<Rectangle>(s).corner.x = Inf; }},
      {"no extent", [](Scene& s) { The<Box>(s).upper.y = -1; }},
      {"no extent", [](Scene& s) { The<Cone>(s).top = vec3(0); }},
      {"no extent", [](Scene& s) { The<Cone>(s).radius = 0; }},
      {"no extent", [](Scene& s) { The<Cone>(s).topRadius = NaN; }},
      {"no extent", [](Scene& s) { The<Torus>(s).minorRadius = 1.01f; }},
      {"no extent", [](Scene& s) { The<Torus>(s).axis.x = NaN; }},
      {"no extent", [](Scene& s) { The<MeshGeometry>(s).mesh = 1; }},
  };
  return faults;
}

TEST(Validate, AcceptsWhatIsSound) {
  EXPECT_NO_THROW(Validate(Sound(), nullptr));
  EXPECT_NO_THROW(Validate(Scene{}, nullptr));
  EXPECT_NO_THROW(Validate(RenderSettings{}));
  Scene scene = Sound();
  scene.objects[0].toWorld = glm::scale(Affine(1.0), glm::dvec3(-1e-30, 1e-28, 1e-32));
  scene.materials[0].attenuationDistance = Inf;
  scene.meshes[0].positions[1].x = NaN;  // the BVH leaves such triangles out, and says so
  EXPECT_TRUE(FindingsOf(scene).empty());
}

TEST(Validate, FindsEachFaultAlone) {
  int number = 0;
  for (const Fault& fault : Faults()) {
    Scene scene = Sound();
    fault.make(scene);
    const std::vector<Diagnostic> findings = FindingsOf(scene);
    ASSERT_EQ(findings.size(), 1u) << "fault " << number << ": " << fault.words;
    EXPECT_NE(findings[0].message.find(fault.words), std::string::npos) << findings[0].message;
    EXPECT_EQ(findings[0].place.file, "sound.toml");
    ++number;
  }
}

TEST(Validate, TellsAllFaultsInOneGo) {
  Scene scene = Sound();
  scene.settings.spp = -1;
  scene.cameras[1].height = 0;
  scene.materials[0].ior = -1;
  scene.objects[2].material = 7;
  scene.objects[2].place = {"part.toml", 12, 3};
  The<Torus>(scene).axis = vec3(0);
  const std::vector<Diagnostic> findings = FindingsOf(scene);
  ASSERT_EQ(findings.size(), 5u);
  EXPECT_EQ(ToString(findings[3]), "part.toml:12:3: object 'thing' has no material");
}

TEST(Validate, WarnsOfScenesThatCanOnlyBeBlack) {
  std::vector<std::string> warnings;
  const WarningSink warn = [&](const Diagnostic& d) { warnings.push_back(d.message); };
  Validate(Sound(), warn);
  EXPECT_TRUE(warnings.empty());

  Scene dark = Sound();
  dark.lights.clear();
  Validate(dark, warn);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("black"), std::string::npos);
  dark.materials[0].emission.value = Spectrum(1.0f);
  Validate(dark, warn);
  EXPECT_EQ(warnings.size(), 1u);

  dark.objects.clear();
  Validate(dark, warn);
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_NE(warnings[1].find("no objects"), std::string::npos);
}

}  // namespace
}  // namespace snell::scene
