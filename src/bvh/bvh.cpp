// SPDX-License-Identifier: Apache-2.0
#include "bvh/bvh.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <map>
#include <utility>

#include "bvh/blocks.h"
#include "bvh/bounds.h"
#include "bvh/refit.h"
#include "bvh/reinsert.h"
#include "util/error.h"

namespace snell::bvh {

static void SetSlack(Tree& tree, const Bounds& bounds) {
  for (int axis = 0; axis < 3; ++axis)
    tree.slack[axis] =
        kernel::Gamma(8.0f) * std::max(std::abs(bounds.lower[axis]), std::abs(bounds.upper[axis]));
}

Bvh::Bvh(const Geometry& geometry, BuildQuality quality)
    : geometry_(geometry), quality_(quality), traversal_(&TraversalFor(BestInstructionSet())) {
  if (geometry.triangles.size() > MaxTriangles)
    throw Error(fmt::format("the scene has more triangles than a BVH holds ({})", MaxTriangles));
  trees_.emplace_back();

  // Build one tree per mesh that instances place
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> treeOfMesh;
  std::vector<std::vector<Bounds>> treeBoxes(1);
  for (kernel::Instance& instance : geometry.instances) {
    const auto [known, isNew] = treeOfMesh.try_emplace(
        {instance.firstTriangle, instance.triangleCount}, std::uint32_t(trees_.size()));
    if (isNew) {
      const std::uint32_t first = instance.firstTriangle, count = instance.triangleCount;
      const bool deforms = count > 0 && geometry.IsDeforming(first);
      HugeVector<PrimitiveRef> references =
          deforms ? DeformingTriangles(geometry, first, count, dropped_)
                  : PairTriangles(geometry, first, count, dropped_);
      trees_.push_back(BuildTree(references, treeBoxes.emplace_back()));
      trees_.back().deforms = deforms ? 1 : 0;
    }
    instance.root = known->second;
  }

  // Build the world's tree over triangles, shapes and instances
  HugeVector<PrimitiveRef> references =
      PairTriangles(geometry, 0, geometry.worldTriangles, dropped_);
  for (std::uint32_t i = 0; i < geometry.shapes.size(); ++i) {
    const Bounds bounds = PlacedBounds(geometry, geometry.shapes[i]);
    if (bounds.Finite()) {
      references.emplace_back(BoxOf(bounds), LeafKind::Shapes, i);
      view_.treeMask |= MaskOf(geometry.shapes[i].object);
    } else {
      unbounded_.push_back(i);
    }
  }
  std::vector<Bounds> instanceBounds(geometry.instances.size());
  tbb::parallel_for(std::size_t(0), instanceBounds.size(), [&](std::size_t i) {
    const kernel::Instance& instance = geometry.instances[i];
    instanceBounds[i] = PlacedBounds(geometry, instance, treeBoxes[instance.root]);
  });
  for (std::uint32_t i = 0; i < geometry.instances.size(); ++i) {
    const kernel::Instance& instance = geometry.instances[i];
    const Bounds& bounds = instanceBounds[i];
    if (treeBoxes[instance.root].empty()) continue;
    if (bounds.Finite()) {
      references.emplace_back(BoxOf(bounds), LeafKind::Instances, i);
      view_.treeMask |= MaskOf(instance.object);
    } else {
      ++dropped_;
    }
  }
  trees_[0] = BuildTree(references, treeBoxes[0]);
  FindTriangleMasks();
  arrays_.nodes.shrink_to_fit();
  arrays_.blocks.shrink_to_fit();

  view_ = {arrays_.nodes.data(),
           arrays_.blocks.data(),
           arrays_.shapes.data(),
           arrays_.placed.data(),
           trees_.data(),
           unbounded_.data(),
           std::uint32_t(unbounded_.size()),
           0,
           view_.treeMask,
           geometry.positions.data(),
           geometry.triangles.data(),
           geometry.meshes.empty() ? nullptr : geometry.meshes.data(),
           geometry.shapes.data(),
           geometry.instances.data(),
           geometry.objects.empty() ? nullptr : geometry.objects.data(),
           geometry.motions.empty() ? nullptr : geometry.motions.data(),
           HitFilter{}};
  FindPlainMask();
}

void Bvh::SetFilter(const HitFilter& filter) {
  view_.filter = filter;
  FindPlainMask();
}

void Bvh::FindPlainMask() {
  const bool plain = trees_[0].root != None && geometry_.shapes.empty() &&
                     geometry_.instances.empty() && view_.filter.accepts == nullptr;
  view_.plainMask = plain ? trees_[0].commonMask : 0;
}

Tree Bvh::BuildTree(HugeVector<PrimitiveRef>& references, std::vector<Bounds>& boxes) {
  Tree tree;
  if (references.empty()) return tree;
  BinaryTree binary = BuildBinaryTree(references);
  if (quality_ == BuildQuality::High) ReinsertSubtrees(binary, references);
  const Bounds bounds = BoundsOf(binary[0].box);
  SetSlack(tree, bounds);
  tree.root = AppendWideTree(binary, references, geometry_, arrays_);
  boxes = OuterBoxes(tree.root, bounds, arrays_.nodes);
  return tree;
}

std::uint32_t Bvh::MaskOf(std::uint32_t object) const {
  return geometry_.objects.empty() ? ~0u : geometry_.objects[object].mask;
}

void Bvh::FindTriangleMasks() {
  Tree& world = trees_[0];
  world.commonMask = ~0u;
  if (geometry_.meshes.empty()) {
    world.anyMask = geometry_.worldTriangles > 0 ? ~0u : 0u;
  } else {
    // Triangles of a mesh follow each other
    std::uint32_t mesh = None;
    for (std::uint32_t i = 0; i < geometry_.worldTriangles; ++i) {
      if (geometry_.triangles[i].mesh == mesh) continue;
      mesh = geometry_.triangles[i].mesh;
      const std::uint32_t mask = MaskOf(geometry_.meshes[mesh].object);
      world.commonMask &= mask;
      world.anyMask |= mask;
    }
  }
  view_.treeMask |= world.anyMask;
}

void Bvh::Refit() {
  std::vector<std::vector<Bounds>> boxes(trees_.size());
  for (std::size_t i = 1; i <= trees_.size(); ++i) {
    // The world comes last, since it holds the others' bounds
    const std::size_t tree = i % trees_.size();
    if (trees_[tree].root == None) continue;
    const Bounds bounds = RefitTree(trees_[tree].root, geometry_, boxes, arrays_);
    SetSlack(trees_[tree], bounds);
    boxes[tree] = OuterBoxes(trees_[tree].root, bounds, arrays_.nodes);
  }
}

std::uint64_t Bvh::MemoryBytes() const {
  return arrays_.nodes.size() * sizeof(WideNode) + arrays_.blocks.size() * sizeof(PairBlock) +
         arrays_.shapes.size() * sizeof(std::uint32_t) +
         arrays_.placed.size() * sizeof(PlacedTree) + trees_.size() * sizeof(Tree);
}

}  // namespace snell::bvh
