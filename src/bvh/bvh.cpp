// SPDX-License-Identifier: Apache-2.0
#include "bvh/bvh.h"

#include <map>
#include <utility>

#include "bvh/bounds.h"

namespace snell::bvh {

// Triangles come in blocks of four; two blocks are tested at about the price of a node.
static constexpr std::uint32_t MaxLeafPrimitives = 8;

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
      std::vector<PrimitiveRef> references;
      AddTriangles(instance.firstTriangle, instance.triangleCount, references);
      Bounds bounds;
      for (const PrimitiveRef& ref : references) bounds.Extend(Bounds{ref.lower, ref.upper});
      treeBounds.push_back(bounds);
      trees_.push_back(BuildTree(references));
    }
    instance.root = known->second;
  }

  // Build the world's tree over triangles, shapes and instances
  std::vector<PrimitiveRef> references;
  AddTriangles(0, geometry.worldTriangles, references);
  for (std::uint32_t i = 0; i < geometry.shapes.size(); ++i) {
    const Bounds bounds = ShapeBounds(geometry.shapes[i]);
    if (bounds.Finite()) {
      references.push_back({bounds.lower, i, bounds.upper, LeafKind::Shapes});
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
      references.push_back({bounds.lower, i, bounds.upper, LeafKind::Instances});
      view_.treeMask |= MaskOf(instance.object);
    } else {
      ++dropped_;
    }
  }
  trees_[0] = BuildTree(references);
  FindTriangleMasks();

  view_ = {arrays_.nodes.data(),   arrays_.blocks.data(),     arrays_.items.data(),
           trees_.data(),          unbounded_.data(),         std::uint32_t(unbounded_.size()),
           view_.treeMask,         geometry.triangles.data(), geometry.meshes.data(),
           geometry.shapes.data(), geometry.instances.data(), geometry.objects.data()};
}

void Bvh::AddTriangles(std::uint32_t first, std::uint32_t count,
                       std::vector<PrimitiveRef>& references) {
  references.reserve(references.size() + count);
  for (std::uint32_t i = first; i < first + count; ++i) {
    const Bounds bounds = TriangleBounds(geometry_, i);
    if (bounds.Finite()) {
      references.push_back({bounds.lower, i, bounds.upper, LeafKind::Triangles});
    } else {
      ++dropped_;
    }
  }
}

Tree Bvh::BuildTree(std::vector<PrimitiveRef>& references) {
  Tree tree;
  if (references.empty()) return tree;
  const BinaryTree binary = BuildBinaryTree(references, MaxLeafPrimitives);
  const Bounds& bounds = binary.nodes[0].bounds;
  for (int axis = 0; axis < 3; ++axis)
    tree.reach[axis] = std::max(std::abs(bounds.lower[axis]), std::abs(bounds.upper[axis]));
  tree.root = AppendWideTree(binary, references, geometry_, arrays_);
  return tree;
}

std::uint32_t Bvh::MaskOf(std::uint32_t object) const { return geometry_.objects[object].mask; }

void Bvh::FindTriangleMasks() {
  std::uint32_t& shared = trees_[0].triangleMask;
  for (std::uint32_t i = 0; i < geometry_.worldTriangles; ++i) {
    const std::uint32_t mask = MaskOf(geometry_.meshes[geometry_.triangles[i].mesh].object);
    view_.treeMask |= mask;
    shared = i == 0 || mask == shared ? mask : MixedMask;
  }
}

std::uint64_t Bvh::MemoryBytes() const {
  return arrays_.nodes.size() * sizeof(WideNode) + arrays_.blocks.size() * sizeof(TriangleBlock) +
         arrays_.items.size() * sizeof(std::uint32_t) + trees_.size() * sizeof(Tree);
}

}  // namespace snell::bvh
