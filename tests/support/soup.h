// SPDX-License-Identifier: Apache-2.0
//
// Geometry without a scene, as a BVH takes it: triangles in world space, shapes, and instances of meshes, each
// with a mask of its own. The search to compare with is the GPU's, which asks every primitive in turn.
#pragma once

#include <span>
#include <vector>

#include "bvh/geometry.h"
#include "kernel/motion.h"
#include "kernel/shape.h"
#include "kernel/triangle.h"
#include "support/meshes.h"
#include "support/shapes.h"

namespace snell::test {

namespace search {

using namespace kernel;

struct PrimitiveCounts {
  uint shapes;
  uint worldTriangles;
  uint instances;
};

struct BruteForce {
  PrimitiveCounts counts;
  const Object* objects;
  const Shape* shapes;
  const Instance* instances;
  const Mesh* meshes;
  const Triangle* triangles;
  const vec3* positions;
  const MotionKey* motions;

#include "gpu/shaders/brute_force.glsl"
};

}  // namespace search

class Soup {
 public:
  // Triangles in world space must come before meshes for instances.
  void AddTriangle(vec3 a, vec3 b, vec3 c, unsigned mask = kernel::MASK_ALL) {
    AddMesh({{a, b, c}, {{0, 1, 2}}}, AddObject(mask));
    worldTriangles_ = unsigned(triangles_.size());
  }
  void AddWorldMesh(const TriangleMesh& mesh, unsigned mask = kernel::MASK_ALL) {
    AddMesh(mesh, AddObject(mask));
    worldTriangles_ = unsigned(triangles_.size());
  }
  void AddShape(kernel::Shape shape, unsigned mask = kernel::MASK_ALL) {
    shape.object = AddObject(mask);
    shapes_.push_back(shape);
  }
  // Returns an instance of the mesh that is not yet in the soup.
  kernel::Instance AddMesh(const TriangleMesh& mesh) {
    const unsigned first = unsigned(triangles_.size());
    AddMesh(mesh, kernel::None);
    if (deforms_ != nullptr) AddKeys(mesh);
    return {0, 0, first, unsigned(mesh.triangles.size()), {}};
  }
  void AddInstance(kernel::Instance instance, const glm::dmat4& map,
                   unsigned mask = kernel::MASK_ALL) {
    instance.object = AddObject(mask);
    instance.toWorld = ToKernel(map);
    instances_.push_back(instance);
  }

  // Let meshes that are added for instances from now on change their shape, over a few keys.
  void DeformMeshes(Random& random) { deforms_ = &random; }

  // Let all shapes and instances move from where they are, over a few keys.
  void Move(Random& random) {
    for (const kernel::Shape& shape : shapes_)
      AddMotion(random, shape.object, ToKernel(glm::dmat4(1.0)));
    for (const kernel::Instance& instance : instances_)
      AddMotion(random, instance.object, instance.toWorld);
  }

  // What may move while views are used.
  std::span<kernel::vec3> positions() { return positions_; }
  std::span<kernel::Shape> shapes() { return shapes_; }
  std::span<kernel::Instance> instances() { return instances_; }

  // Views; the soup must not move or grow while they are used.
  bvh::Geometry Geometry() {
    return {positions_, triangles_, meshes_,         shapes_,
            instances_, objects_,   worldTriangles_, motions_};
  }
  search::BruteForce BruteForce() const {
    return {{unsigned(shapes_.size()), worldTriangles_, unsigned(instances_.size())},
            objects_.data(),
            shapes_.data(),
            instances_.data(),
            meshes_.data(),
            triangles_.data(),
            positions_.data(),
            motions_.data()};
  }

  // The t of what a search found; 0 for nothing.
  float DistanceOf(const kernel::Hit& hit, const kernel::Ray& ray) const {
    if (hit.primitive == kernel::None) return 0;
    if (hit.instance == kernel::INSTANCE_SHAPE) {
      const kernel::Ray local = BruteForce().ShapeRay(shapes_[hit.primitive], ray);
      return kernel::IntersectShape(shapes_[hit.primitive], local.o, local.d);
    }
    kernel::Ray local = ray;
    if (hit.instance != kernel::None)
      local = kernel::ToLocalRay(BruteForce().InstanceAt(hit.instance, ray.time), ray.o, ray.d);
    const kernel::Triangle& t = triangles_[hit.primitive];
    const auto corner = [&](unsigned vertex) {
      return BruteForce().PositionAt(meshes_[t.mesh], vertex, ray.time);
    };
    return kernel::IntersectTriangle(kernel::Shear(local.o, local.d), corner(t.v0), corner(t.v1),
                                     corner(t.v2))
        .t;
  }

  // A point on the surface of some primitive: often a corner or on an edge.
  glm::dvec3 PointOnSurface(Random& random) const;

  std::size_t PrimitiveCount() const {
    return worldTriangles_ + shapes_.size() + instances_.size();
  }

 private:
  unsigned AddObject(unsigned mask) {
    objects_.push_back(
        {0, mask, kernel::None, kernel::None, 0, ToKernel(glm::dmat4(1.0)), kernel::None});
    return unsigned(objects_.size()) - 1;
  }
  void AddMotion(Random& random, unsigned object, const kernel::Transform& place) {
    objects_[object].motion = unsigned(motions_.size());
    objects_[object].motionSteps = 1 + random.Index(4);
    for (unsigned i = 0; i <= objects_[object].motionSteps; ++i) {
      const auto changed = [&](kernel::vec3 v) {
        return v + kernel::vec3(random.InCube()) * (0.15f * kernel::Length(v));
      };
      motions_.push_back({changed(place.x), changed(place.y), changed(place.z),
                          place.origin + kernel::vec3(random.InCube()) * 0.3f});
    }
  }
  void AddMesh(const TriangleMesh& mesh, unsigned object) {
    const unsigned first = unsigned(positions_.size());
    for (const uvec3 t : mesh.triangles)
      triangles_.push_back({first + t.x, first + t.y, first + t.z, unsigned(meshes_.size())});
    positions_.insert(positions_.end(), mesh.positions.begin(), mesh.positions.end());
    meshes_.push_back(
        {object, kernel::None, kernel::None, kernel::None, kernel::None, kernel::None, 0, 0});
  }

  // Keys of the mesh that was added last.
  void AddKeys(const TriangleMesh& mesh) {
    meshes_.back().steps = 1 + deforms_->Index(4);
    meshes_.back().stride = unsigned(mesh.positions.size());
    for (unsigned key = 1; key <= meshes_.back().steps; ++key) {
      for (const kernel::vec3 p : mesh.positions)
        positions_.push_back(p + kernel::vec3(deforms_->InCube()) * 0.2f);
    }
  }

  std::vector<kernel::vec3> positions_;
  std::vector<kernel::Triangle> triangles_;
  std::vector<kernel::Mesh> meshes_;
  std::vector<kernel::Shape> shapes_;
  std::vector<kernel::Instance> instances_;
  std::vector<kernel::Object> objects_;
  std::vector<kernel::MotionKey> motions_;
  unsigned worldTriangles_ = 0;
  Random* deforms_ = nullptr;
};

inline glm::dvec3 Soup::PointOnSurface(Random& random) const {
  const unsigned i = random.Index(unsigned(PrimitiveCount()));
  const auto onTriangle = [&](unsigned index) {
    const kernel::Triangle& t = triangles_[index];
    return PointOn(random, glm::dvec3(positions_[t.v0]), glm::dvec3(positions_[t.v1]),
                   glm::dvec3(positions_[t.v2]));
  };
  if (i < worldTriangles_) return onTriangle(i);
  if (i < worldTriangles_ + shapes_.size()) {
    const kernel::Shape& shape = shapes_[i - worldTriangles_];
    return ExactToWorld(shape.toWorld, RandomSurfacePoint(random, ReferenceShape(shape)));
  }
  const kernel::Instance& instance = instances_[i - worldTriangles_ - shapes_.size()];
  if (instance.triangleCount == 0) return glm::dvec3(instance.toWorld.origin);
  return ExactToWorld(instance.toWorld,
                      onTriangle(instance.firstTriangle + random.Index(instance.triangleCount)));
}

}  // namespace snell::test
