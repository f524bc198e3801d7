// SPDX-License-Identifier: Apache-2.0
#include "cpu/flatten_light_tree.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "cpu/emission_average.h"
#include "cpu/flatten_profile.h"
#include "cpu/light_tree.h"
#include "kernel/transform.h"

namespace snell::cpu {

using namespace kernel;
using glm::dvec3;

namespace {

constexpr double HalfPi = 1.5707963267948966;
constexpr double FullPi = 2 * HalfPi;
// A spot's border is this much wider in the tree, radians, so that rounding cannot hide it.
constexpr double SpotMargin = 2e-3;

LightCone Everywhere() { return {{0, 0, 1}, FullPi, HalfPi, false}; }

LightCone FlatCone(vec3 normal, bool twoSided) {
  return {glm::normalize(dvec3(normal)), 0, HalfPi, twoSided};
}

void SetSphere(vec3 center, float radius, LightLeaf& leaf) {
  leaf.center = center;
  leaf.radius = radius;
  leaf.box = {center - vec3(radius), center + vec3(radius)};
}

// Of a flat source, in its plane.
void SetCorners(std::initializer_list<vec3> corners, LightLeaf& leaf) {
  leaf.center = vec3(0.0f);
  for (const vec3& corner : corners) {
    leaf.box.Extend(corner);
    leaf.center += corner / float(corners.size());
  }
  leaf.radius = 0;
  for (const vec3& corner : corners)
    leaf.radius = std::max(leaf.radius, Length(corner - leaf.center) * (1 + 1e-6f));
}

// A source's intensity in the place of its falloff.
dvec3 PowerOf(const Light& light, double intensity) {
  switch (light.falloff) {
    case FALLOFF_NONE: return {intensity, 0, 0};
    case FALLOFF_LINEAR: return {0, intensity / double(light.factor), 0};
  }
  return {0, 0, intensity};
}

LightCone SpotCone(const Light& light) {
  const double inner = std::acos(std::clamp(double(light.cosInner), -1.0, 1.0));
  const double outer = std::acos(std::clamp(double(light.cosOuter), -1.0, 1.0));
  const double thetaO = std::max(inner, outer - HalfPi);
  return {glm::normalize(dvec3(light.direction)), thetaO,
          std::min(outer - thetaO + SpotMargin, HalfPi), false};
}

// Narrow a cone to where the light's profile shines.
LightCone ProfileCone(const Light& light, const LightCone& cone, double angle) {
  if (light.kind == LIGHT_SPOT && cone.thetaO + cone.thetaE < angle) return cone;
  return {glm::normalize(dvec3(light.direction)), angle, SpotMargin, false};
}

LightLeaf LeafOf(const FlatScene& flat, const Light& light) {
  LightLeaf leaf;
  leaf.reach = light.range;
  double intensity = double(MaxChannel(light.emission));
  switch (light.kind) {
    case LIGHT_POINT:
    case LIGHT_SPOT:
      SetSphere(light.position, light.radius, leaf);
      leaf.cone = light.kind == LIGHT_SPOT ? SpotCone(light) : Everywhere();
      if (light.profile != None) {
        const ProfileBounds bounds = BoundsOfProfile(flat, light.profile);
        leaf.cone = ProfileCone(light, leaf.cone, bounds.angle);
        intensity *= bounds.mean;
      }
      break;
    case LIGHT_SPHERE:
      SetSphere(light.position, light.radius, leaf);
      leaf.cone = Everywhere();
      intensity *= double(Pi * Sqr(light.radius));
      break;
    default: {
      const vec3 &p = light.position, &u = light.edgeU, &v = light.edgeV;
      if (light.kind == LIGHT_TRIANGLE) SetCorners({p, p + u, p + v}, leaf);
      if (light.kind == LIGHT_RECTANGLE) SetCorners({p, p + u, p + u + v, p + v}, leaf);
      if (light.kind == LIGHT_DISK) {
        SetCorners({p - u - v, p + u - v, p + u + v, p - u + v}, leaf);
        leaf.radius = light.radius;
      }
      leaf.cone = FlatCone(light.direction, false);
      intensity *= double(light.area);
    }
  }
  leaf.power = PowerOf(light, intensity);
  return leaf;
}

// Where an emitter is; without its power.
LightLeaf PlaceOf(const FlatScene& flat, const Emitter& emitter, bool twoSided) {
  LightLeaf leaf;
  if (emitter.instance != INSTANCE_SHAPE) {
    const Triangle& triangle = flat.triangles[emitter.primitive];
    vec3 a = flat.positions[triangle.v0], b = flat.positions[triangle.v1],
         c = flat.positions[triangle.v2];
    vec3 n = Cross(b - a, c - a);
    // Where vertices bring normals, these say which side is outside
    const uint normals = flat.meshes[triangle.mesh].normals;
    if (normals != None)
      n = FaceForward(n, flat.normals[triangle.v0 + normals] + flat.normals[triangle.v1 + normals] +
                             flat.normals[triangle.v2 + normals]);
    if (emitter.instance != None) {
      const Transform& toWorld = flat.instances[emitter.instance].toWorld;
      a = ToWorldPoint(toWorld, a);
      b = ToWorldPoint(toWorld, b);
      c = ToWorldPoint(toWorld, c);
      n = FaceForward(Cross(b - a, c - a), ToWorldNormal(toWorld, n));
    }
    SetCorners({a, b, c}, leaf);
    leaf.cone = FlatCone(n, twoSided);
    return leaf;
  }
  const Shape& shape = flat.shapes[emitter.primitive];
  const Transform& m = shape.toWorld;
  if (shape.kind == SHAPE_SPHERE) {
    SetSphere(m.origin, shape.a, leaf);
    leaf.cone = Everywhere();
    return leaf;
  }
  const vec3 o = m.origin;
  if (shape.kind == SHAPE_RECTANGLE) SetCorners({o, o + m.x, o + m.x - m.z, o - m.z}, leaf);
  if (shape.kind == SHAPE_DISK)
    SetCorners({o - m.x - m.z, o + m.x - m.z, o + m.x + m.z, o - m.x + m.z}, leaf);
  leaf.cone = FlatCone(ToWorldNormal(m, vec3(0, 1, 0)), twoSided);
  return leaf;
}

const Object& ObjectOf(const FlatScene& flat, const Emitter& emitter) {
  if (emitter.instance == INSTANCE_SHAPE)
    return flat.objects[flat.shapes[emitter.primitive].object];
  if (emitter.instance != None) return flat.objects[flat.instances[emitter.instance].object];
  return flat.objects[flat.meshes[flat.triangles[emitter.primitive].mesh].object];
}

// An emitter as a leaf; without power if it cannot be sampled.
LightLeaf LeafOf(const FlatScene& flat, const Emitter& emitter) {
  const Object& object = ObjectOf(flat, emitter);
  if (!(emitter.area > 0) || (object.mask & MASK_SECONDARY) == 0) return {};
  const Material& material = flat.materials[object.material];
  LightLeaf leaf = PlaceOf(flat, emitter, material.singleSided == 0);
  const Spectrum radiance =
      AverageEmission(flat, emitter, material, leaf.center, vec3(leaf.cone.axis));
  leaf.power.z = double(emitter.area) * double(MaxChannel(radiance));
  return leaf;
}

}  // namespace

void FlattenLightTree(FlatScene& flat) {
  flat.params.firstDirectional = None;
  std::vector<LightLeaf> leaves;
  for (uint i = uint(flat.lights.size()); i-- > 0;) {
    Light& light = flat.lights[i];
    light.node = light.next = None;
    if (light.kind == LIGHT_DIRECTIONAL) {
      light.next = flat.params.firstDirectional;
      flat.params.firstDirectional = i;
      continue;
    }
    leaves.push_back(LeafOf(flat, light));
    leaves.back().source = i;
  }
  const std::size_t firstEmitter = leaves.size();
  leaves.resize(firstEmitter + flat.emitters.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, flat.emitters.size(), 256),
                    [&](const auto& part) {
                      for (std::size_t i = part.begin(); i < part.end(); ++i) {
                        leaves[firstEmitter + i] = LeafOf(flat, flat.emitters[i]);
                        leaves[firstEmitter + i].source = uint(flat.lights.size() + i);
                      }
                    });
  std::erase_if(leaves, [](const LightLeaf& leaf) {
    return !(leaf.Power() > 0) || !std::isfinite(leaf.Power()) || !leaf.box.Finite();
  });

  flat.lightNodes = BuildLightTree(leaves);
  flat.params.lightNodeCount = uint(flat.lightNodes.size());
  for (uint i = 0; i < flat.lightNodes.size(); ++i) {
    const LightNode& node = flat.lightNodes[i];
    if ((node.flags & LIGHT_NODE_LEAF) == 0) continue;
    if (node.first < flat.lights.size()) {
      flat.lights[node.first].node = i;
    } else {
      flat.emitters[node.first - flat.lights.size()].node = i;
    }
  }
}

}  // namespace snell::cpu
