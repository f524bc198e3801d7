// SPDX-License-Identifier: Apache-2.0
#include "cpu/flatten_geometry.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "kernel/math.h"
#include "kernel/microfacet.h"
#include "scene/motion.h"
#include "util/check.h"

namespace snell::cpu {

using namespace kernel;
using scene::Affine;

namespace {

// A rotation that turns +y to `axis`, by the shortest way, at `origin`.
Affine Frame(vec3 origin, vec3 axis) {
  const glm::dvec3 y = glm::normalize(glm::dvec3(axis));
  // Column of Rodrigues' rotation about (0, 1, 0) × y; k = 1 / (1 + y.y), also where that cancels
  const double s = y.x * y.x + y.z * y.z;
  glm::dvec3 x(1, 0, 0);
  if (s > 0) {
    const double k = y.y > 0 ? 1 / (1 + y.y) : (1 - y.y) / s;
    x = {1 - k * y.x * y.x, -y.x, -k * y.x * y.z};
  }
  const glm::dvec3 z = glm::cross(x, y);
  return {glm::dvec4(x, 0), glm::dvec4(y, 0), glm::dvec4(z, 0), glm::dvec4(glm::dvec3(origin), 1)};
}

Affine Scaling(glm::dvec3 factors) { return glm::scale(Affine(1.0), factors); }
Affine Translation(vec3 offset) { return glm::translate(Affine(1.0), glm::dvec3(offset)); }

// Whether the map keeps spheres: rotation, mirroring and one scale only.
bool IsSimilarity(const Affine& m, double& scale) {
  const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
  scale = glm::length(x);
  const double tolerance = 1e-7 * scale * scale;
  return std::abs(glm::dot(x, y)) <= tolerance && std::abs(glm::dot(y, z)) <= tolerance &&
         std::abs(glm::dot(z, x)) <= tolerance &&
         std::abs(glm::dot(y, y) - scale * scale) <= tolerance &&
         std::abs(glm::dot(z, z) - scale * scale) <= tolerance;
}

struct ShapeFlattener {
  const Affine& toWorld;
  Shape shape = {};

  void Set(uint kind, const Affine& local, float a = 0, float b = 0, float c = 0) {
    shape.kind = kind;
    shape.a = a;
    shape.b = b;
    shape.c = c;
    shape.toWorld = ToTransform(toWorld * local);
  }

  void operator()(const scene::Sphere& s) {
    double scale = 1;
    if (IsSimilarity(toWorld, scale)) {
      Set(SHAPE_SPHERE, Translation(s.center) * Scaling(glm::dvec3(1 / scale)),
          float(double(s.radius) * scale));
    } else {
      Set(SHAPE_ELLIPSOID, Translation(s.center) * Scaling(glm::dvec3(double(s.radius))));
    }
  }
  void operator()(const scene::Plane& s) { Set(SHAPE_PLANE, Frame(s.point, s.normal)); }
  void operator()(const scene::Disk& s) {
    Set(SHAPE_DISK, Frame(s.center, s.normal) * Scaling(glm::dvec3(double(s.radius))),
        s.innerRadius / s.radius);
  }
  void operator()(const scene::Rectangle& s) {
    const glm::dvec3 u(s.edgeU), v(s.edgeV);
    const glm::dvec3 n = glm::normalize(glm::cross(u, v));
    Set(SHAPE_RECTANGLE, Affine(glm::dvec4(u, 0), glm::dvec4(n, 0), glm::dvec4(-v, 0),
                                glm::dvec4(glm::dvec3(s.corner), 1)));
  }
  void operator()(const scene::Box& s) {
    const glm::dvec3 lower(s.lower), upper(s.upper);
    Set(SHAPE_BOX,
        glm::translate(Affine(1.0), (lower + upper) * 0.5) * Scaling((upper - lower) * 0.5));
  }
  void operator()(const scene::Cone& s) {
    const float height = float(glm::length(glm::dvec3(s.top) - glm::dvec3(s.base)));
    Set(s.capped ? SHAPE_FRUSTUM : SHAPE_TUBE, Frame(s.base, s.top - s.base), s.radius, s.topRadius,
        height);
  }
  void operator()(const scene::Torus& s) {
    Set(SHAPE_TORUS, Frame(s.center, s.axis), s.majorRadius, s.minorRadius);
  }
  void operator()(const scene::MeshGeometry&) { CHECK(!"a mesh is no analytic shape"); }
};

// Whether a texture of the object's material reads texture coordinates.
bool IsMapped(const scene::Scene& scene, const scene::Material& material) {
  const auto isUv = [&](scene::TextureIndex texture) {
    return texture >= 0 && scene.textures.at(std::size_t(texture)).space == scene::TextureSpace::Uv;
  };
  const auto reads = [&](const scene::ColorInput& input) { return isUv(input.texture); };
  return material.physical || isUv(material.normalMap.texture) || isUv(material.bumpMap.texture) ||
         isUv(material.opacity.texture) || reads(material.emission) ||
         reads(material.reflectivity) || reads(material.transparency) ||
         std::ranges::any_of(material.terms,
                             [&](const scene::Term& term) { return reads(term.color); });
}

// Whether light that passes is neither bent nor scattered. Narrower roughness than this is smooth to the kernel.
bool PassesStraight(const scene::Material& material) {
  if (!material.thin || !material.physical) return material.thin;
  const scene::ScalarInput& roughness = material.physical->specularRoughness;
  return roughness.value * roughness.value * 1.5f < SmoothAlpha;
}

bool LetsShadowRaysPass(const scene::Material& material, ShadowRays shadowRays) {
  if (material.volume) return true;
  if (!material.Refractive()) return material.alphaMode != scene::AlphaMode::Opaque;
  if (shadowRays == ShadowRays::Path) return PassesStraight(material);
  return shadowRays == ShadowRays::Tinted;
}

uint MaskOf(const scene::Object& object, const scene::Material& material, ShadowRays shadowRays) {
  uint mask = 0;
  if (object.visibleToCamera) mask |= MASK_CAMERA;
  if (object.visibleToSecondary) mask |= MASK_SECONDARY;
  if (object.castsShadow)
    mask |= LetsShadowRaysPass(material, shadowRays) ? MASK_TINT : MASK_SHADOW;
  if (material.Refractive() && !material.thin) mask |= MASK_INSIDE;
  return mask;
}

}  // namespace

uint AppendMesh(const scene::Mesh& mesh, const Affine* toWorld, uint object, FlatScene& flat) {
  CHECK(!toWorld || mesh.keys.empty());
  const uint firstVertex = uint(flat.positions.size());
  const uint firstTriangle = uint(flat.triangles.size());
  if (flat.positions.size() + mesh.positions.size() * (1 + mesh.keys.size()) >= INSTANCE_SHAPE ||
      flat.triangles.size() + mesh.triangles.size() >= INSTANCE_SHAPE)
    throw Error("the scene has more vertices or triangles than Snell can number (about 4 billion)");

  // Indices of attributes are the vertex's plus an offset that may wrap around
  Mesh record = {};
  record.object = object;
  record.normals = mesh.normals.empty() ? None : uint(flat.normals.size()) - firstVertex;
  record.uvs = mesh.uvs.empty() ? None : uint(flat.uvs.size()) - firstVertex;
  record.uvs1 = mesh.uvs1.empty() ? None : uint(flat.uvs.size() + mesh.uvs.size()) - firstVertex;
  record.tangents = mesh.tangents.empty() ? None : uint(flat.tangents.size()) - firstVertex;
  record.colors = mesh.colors.empty() ? None : uint(flat.colors.size()) - firstVertex;
  record.steps = uint(mesh.keys.size());
  record.stride = uint(mesh.positions.size());
  if (record.steps > 0) flat.params.moving = 1;
  const uint meshIndex = uint(flat.meshes.size());
  flat.meshes.push_back(record);

  flat.positions.insert(flat.positions.end(), mesh.positions.begin(), mesh.positions.end());
  flat.normals.insert(flat.normals.end(), mesh.normals.begin(), mesh.normals.end());
  flat.uvs.insert(flat.uvs.end(), mesh.uvs.begin(), mesh.uvs.end());
  flat.uvs.insert(flat.uvs.end(), mesh.uvs1.begin(), mesh.uvs1.end());
  flat.tangents.insert(flat.tangents.end(), mesh.tangents.begin(), mesh.tangents.end());
  flat.colors.insert(flat.colors.end(), mesh.colors.begin(), mesh.colors.end());
  for (const scene::MeshKey& key : mesh.keys) {
    flat.positions.insert(flat.positions.end(), key.positions.begin(), key.positions.end());
    flat.normals.insert(flat.normals.end(), key.normals.begin(), key.normals.end());
    flat.tangents.insert(flat.tangents.end(), key.tangents.begin(), key.tangents.end());
  }
  const bool moved = toWorld && *toWorld != Affine(1.0);
  const bool mirrored = moved && glm::determinant(glm::dmat3(*toWorld)) < 0;
  if (moved) {
    const glm::dmat3 linear(*toWorld);
    const glm::dvec3 origin((*toWorld)[3]);
    const glm::dmat3 normalMap = glm::inverseTranspose(linear);
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, mesh.positions.size(), 4096), [&](const auto& part) {
          for (std::size_t i = part.begin(); i < part.end(); ++i) {
            vec3& p = flat.positions[firstVertex + i];
            p = vec3(linear * glm::dvec3(p) + origin);
            if (!mesh.tangents.empty()) {
              vec4& t = flat.tangents[flat.tangents.size() - mesh.tangents.size() + i];
              const vec3 turned(linear * glm::dvec3(t));
              t = vec4(turned, mirrored ? -t.w : t.w);
            }
            if (mesh.normals.empty()) continue;
            vec3& n = flat.normals[flat.normals.size() - mesh.normals.size() + i];
            const glm::dvec3 mapped = normalMap * glm::dvec3(n);
            const double length = glm::length(mapped);
            n = length > 0 ? vec3(mapped / length) : n;
          }
        });
  }

  flat.triangles.resize(firstTriangle + mesh.triangles.size());
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, mesh.triangles.size(), 4096), [&](const auto& part) {
        for (std::size_t i = part.begin(); i < part.end(); ++i) {
          const uvec3 t = mesh.triangles[i];
          // Mirroring turns the winding round; turn it back
          const uint second = mirrored ? t.z : t.y;
          const uint third = mirrored ? t.y : t.z;
          flat.triangles[firstTriangle + i] = {firstVertex + t.x, firstVertex + second,
                                               firstVertex + third, meshIndex};
        }
      });
  return firstTriangle;
}

Shape FlattenShape(const scene::Geometry& geometry, const Affine& toWorld, uint object) {
  ShapeFlattener flattener{toWorld};
  std::visit(flattener, geometry);
  flattener.shape.object = object;
  return flattener.shape;
}

void FlattenObjects(const scene::Scene& scene, const tessellate::FinerMeshes& finer,
                    ShadowRays shadowRays, const Shutter& shutter, FlatScene& flat) {
  const uint firstObject = uint(flat.objects.size());
  // Make the records of the objects and count how often each mesh is used
  std::vector<uint> uses(scene.meshes.size() + finer.meshes.size(), 0);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const scene::Object& object = scene.objects[i];
    const scene::Material& material = scene.materials.at(std::size_t(object.material));
    flat.objects.push_back({uint(object.material), MaskOf(object, material, shadowRays), None, None,
                            0, ToTransform(scene::ToWorldAt(object, shutter.open)), 0});
    Object& record = flat.objects.back();
    FlattenMotion(object.motion, shutter, KeyOfPlace, flat, record.motion, record.motionSteps);
    // What moves or changes its shape is an instance even if it is alone
    if (finer.meshOf[i] < 0) continue;
    const bool stays = record.motion == None && finer.MeshOf(scene, i).keys.empty();
    uses[std::size_t(finer.meshOf[i])] += stays ? 1 : 2;
  }

  // Shapes, and meshes used once, which go to world space: these triangles come first
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const scene::Object& object = scene.objects[i];
    const Affine toWorld = scene::ToWorldAt(object, shutter.open);
    if (finer.meshOf[i] < 0) {
      const uint index = firstObject + uint(i);
      const bool moves = flat.objects[index].motion != None;
      Shape shape = FlattenShape(object.geometry, moves ? Affine(1.0) : toWorld, index);
      shape.mapped = IsMapped(scene, scene.materials[std::size_t(object.material)]) ? 1 : 0;
      flat.shapes.push_back(shape);
    } else if (uses[std::size_t(finer.meshOf[i])] == 1) {
      AppendMesh(finer.MeshOf(scene, i), &toWorld, firstObject + uint(i), flat);
    }
  }
  flat.worldTriangles = std::uint32_t(flat.triangles.size());

  // Meshes used more often, and their instances
  std::vector<uint> firstTriangle(uses.size(), None);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (finer.meshOf[i] < 0 || uses[std::size_t(finer.meshOf[i])] < 2) continue;
    const scene::Mesh& mesh = finer.MeshOf(scene, i);
    uint& first = firstTriangle[std::size_t(finer.meshOf[i])];
    if (first == None) first = AppendMesh(mesh, nullptr, None, flat);
    flat.instances.push_back({firstObject + uint(i), 0, first, uint(mesh.triangles.size()),
                              flat.objects[firstObject + uint(i)].toWorld});
  }
}

}  // namespace snell::cpu
