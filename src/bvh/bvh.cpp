// SPDX-License-Identifier: Apache-2.0
#include "bvh/bvh.h"

#include <map>
#include <utility>

#include "bvh/bounds.h"

namespace snell::bvh {

static Box BoxOf(const Bounds& bounds) {
  Box box;
  box.lower = Vec4{bounds.lower.x, bounds.lower.y, bounds.lower.z, 0};
  box.upper = Vec4{bounds.upper.x, bounds.upper.y, bounds.upper.z, 0};
  return box;
}

Bvh::Bvh(const Geometry& geometry)
    : geometry_(geometry), traversal_(&TraversalFor(BestInstructionSet())) {
  trees_.emplace_back();

  // Build one tree per mesh that instances place
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> treeOfMesh;
  std::vector<Bounds> treeBounds(1);
  for (kernel::Instance& instance : geometry.instances) {
    const auto [known, isNew] = treeOfMesh.try_emplace(
        {instance.firstTriangle, instance.triangleCount}, std::uint32_t(trees_.size()));
    if (isNew) {
      HugeVector<PrimitiveRef> references =
          PairTriangles(geometry, instance.firstTriangle, instance.triangleCount, dropped_);
      treeBounds.emplace_back();
      trees_.push_back(BuildTree(references, treeBounds.back()));
    }
    instance.root = known->second;
  }

  // Build the world's tree over triangles, shapes and instances
  HugeVector<PrimitiveRef> references =
      PairTriangles(geometry, 0, geometry.worldTriangles, dropped_);
  for (std::uint32_t i = 0; i < geometry.shapes.size(); ++i) {
    const Bounds bounds = ShapeBounds(geometry.shapes[i]);
    if (bounds.Finite()) {
      references.emplace_back(BoxOf(bounds), LeafKind::Shapes, i);
      view_.treeMask |= MaskOf(geometry.shapes[i].object);
    } else {
      unbounded_.push_back(i);
    }
  }
  for (std::uint32_t i = 0; i < geometry.instances.size(); ++i) {
    const kernel::Instance& instance = geometry.instances[i];
    const Bounds& local = treeBounds[instance.root];
    if (local.Empty()) continue;
    const Bounds bounds = TransformedBounds(instance.toWorld, local);
    if (bounds.Finite()) {
      references.emplace_back(BoxOf(bounds), LeafKind::Instances, i);
      view_.treeMask |= MaskOf(instance.object);
    } else {
      ++dropped_;
    }
  }
  trees_[0] = BuildTree(references, treeBounds[0]);
  FindTriangleMasks();

  view_ = {arrays_.nodes.data(),   arrays_.blocks.data(),     arrays_.items.data(),
           trees_.data(),          unbounded_.data(),         std::uint32_t(unbounded_.size()),
           view_.treeMask,         geometry.triangles.data(), geometry.meshes.data(),
           geometry.shapes.data(), geometry.instances.data(), geometry.objects.data()};
}

Tree Bvh::BuildTree(HugeVector<PrimitiveRef>& references, Bounds& bounds) {
  Tree tree;
  if (references.empty()) return tree;
  const BinaryTree binary = BuildBinaryTree(references);
  const Box& box = binary[0].box;
  bounds = {{box.lower[0], box.lower[1], box.lower[2]}, {box.upper[0], box.upper[1], box.upper[2]}};
  for (int axis = 0; axis < 3; ++axis)
    tree.reach[axis] = std::max(std::abs(bounds.lower[axis]), std::abs(bounds.upper[axis]));
  tree.root = AppendWideTree(binary, references, geometry_, arrays_);
  return tree;
}

std::uint32_t Bvh::MaskOf(std::uint32_t object) const { return geometry_.objects[object].mask; }

void Bvh::FindTriangleMasks() {
  // Triangles of a mesh follow each other
  Tree& world = trees_[0];
  world.commonMask = ~0u;
  std::uint32_t mesh = None;
  for (std::uint32_t i = 0; i < geometry_.worldTriangles; ++i) {
    if (geometry_.triangles[i].mesh == mesh) continue;
    mesh = geometry_.triangles[i].mesh;
    const std::uint32_t mask = MaskOf(geometry_.meshes[mesh].object);
    world.commonMask &= mask;
    world.anyMask |= mask;
  }
  view_.treeMask |= world.anyMask;
}

std::uint64_t Bvh::MemoryBytes() const {
  return arrays_.nodes.size() * sizeof(WideNode) + arrays_.blocks.size() * sizeof(PairBlock) +
         arrays_.items.size() * sizeof(std::uint32_t) + trees_.size() * sizeof(Tree);
}

}  // namespace snell::bvh
