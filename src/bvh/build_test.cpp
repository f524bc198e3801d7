// SPDX-License-Identifier: Apache-2.0
//
// The built arrays themselves: every primitive in one leaf, boxes that hold what is below them, trees of
// bounded depth whatever the input, the same bytes at any number of threads.
#include <gtest/gtest.h>

#include <cstring>
#include <map>

#include "bvh/blocks.h"
#include "bvh/bvh.h"
#include "bvh/tree_bytes.h"
#include "support/soups.h"
#include "util/threads.h"

namespace snell::bvh {
namespace {

using test::Random;
using test::Soup;

// What a walk through one tree finds.
struct Census {
  std::map<std::uint32_t, int> triangles, shapes, instances;  // how often each was met
  int depth = 0;
  int stack = 0;  // the most entries that may wait while a ray goes down
  std::size_t nodes = 0;
  std::size_t faults = 0;
};

class Walker {
 public:
  Walker(const Bvh& bvh, const Geometry& geometry) : arrays_(bvh.arrays()), geometry_(geometry) {}

  Census Walk(const Tree& tree) {
    if (tree.root == None) return {};
    constexpr float Inf = std::numeric_limits<float>::infinity();
    Visit(tree.root, {vec3(-Inf), vec3(Inf)}, 1, 0);
    for (const auto& [id, times] : census_.triangles) {
      // The tree's slack must cover its vertices
      const kernel::Triangle& t = geometry_.triangles[id];
      for (const std::uint32_t v : {t.v0, t.v1, t.v2}) {
        for (int axis = 0; axis < 3; ++axis) {
          if (kernel::Gamma(8.0f) * std::abs(geometry_.positions[v][axis]) > tree.slack[axis])
            ++census_.faults;
        }
      }
    }
    return census_;
  }

 private:
  static bool Holds(const Bounds& outer, vec3 p) {
    return outer.lower.x <= p.x && outer.lower.y <= p.y && outer.lower.z <= p.z &&
           p.x <= outer.upper.x && p.y <= outer.upper.y && p.z <= outer.upper.z;
  }

  void Visit(ChildRef ref, const Bounds& bounds, int depth, int waiting) {
    census_.depth = std::max(census_.depth, depth);
    census_.stack = std::max(census_.stack, waiting);
    if (IsLeaf(ref)) return VisitLeaf(ref, bounds);
    ++census_.nodes;
    const WideNode& node = arrays_.nodes.at(ref);
    int children = 0;
    for (int i = 0; i < Width; ++i)
      children += node.planes[0][i] <= -node.planes[0][Width + i] ? 1 : 0;
    if (children < 2) ++census_.faults;
    for (int i = children; i < Width; ++i) census_.faults += node.child[i] != NoChild;
    for (int i = 0; i < children; ++i) {
      const auto upper = [&](int axis) { return -node.planes[axis][Width + i]; };
      const Bounds box{{node.planes[0][i], node.planes[1][i], node.planes[2][i]},
                       {upper(0), upper(1), upper(2)}};
      if (!Holds(bounds, box.lower) || !Holds(bounds, box.upper)) ++census_.faults;
      Visit(node.child[i], box, depth + 1, waiting + children - 1);
    }
  }

  void VisitLeaf(ChildRef leaf, const Bounds& bounds) {
    for (std::uint32_t i = FirstOf(leaf); i < FirstOf(leaf) + CountOf(leaf); ++i) {
      switch (KindOf(leaf)) {
        case LeafKind::Triangles: VisitBlock(arrays_.blocks.at(i), bounds); break;
        case LeafKind::Shapes: VisitShape(arrays_.shapes.at(i), bounds); break;
        case LeafKind::Instances: VisitInstance(arrays_.placed.at(i).instance, bounds); break;
        default: ++census_.faults;
      }
    }
  }

  void VisitBlock(const PairBlock& block, const Bounds& bounds) {
    for (std::uint32_t lane = 0; lane < BlockWidth; ++lane) {
      for (std::uint32_t second = 0; second < 2; ++second) {
        const std::uint32_t id = block.id[second * BlockWidth + lane];
        if (id == None) continue;
        ++census_.triangles[TriangleOf(id)];
        const kernel::Triangle& t = geometry_.triangles[TriangleOf(id)];
        const std::uint32_t vertices[3] = {t.v0, t.v1, t.v2};
        for (std::uint32_t v = 0; v < 3; ++v) {
          const std::uint32_t corners[3] = {0, 1 + second, 2 + second};
          const std::uint32_t place = corners[(TurnOf(id) + v) % 3] * BlockWidth + lane;
          const vec3 p(block.corner[0][place], block.corner[1][place], block.corner[2][place]);
          if (p != geometry_.positions[vertices[v]] || !Holds(bounds, p)) ++census_.faults;
        }
      }
    }
  }

  void VisitShape(std::uint32_t id, const Bounds& bounds) {
    ++census_.shapes[id];
    const Bounds own = ShapeBounds(geometry_.shapes[id]);
    if (!Holds(bounds, own.lower) || !Holds(bounds, own.upper)) ++census_.faults;
  }

  void VisitInstance(std::uint32_t id, const Bounds& bounds) {
    ++census_.instances[id];
    const kernel::Instance& instance = geometry_.instances[id];
    for (std::uint32_t i = 0; i < instance.triangleCount; ++i) {
      const kernel::Triangle& t = geometry_.triangles[instance.firstTriangle + i];
      for (const std::uint32_t v : {t.v0, t.v1, t.v2}) {
        if (!Holds(bounds, kernel::ToWorldPoint(instance.toWorld, geometry_.positions[v])))
          ++census_.faults;
      }
    }
  }

  const WideArrays& arrays_;
  const Geometry& geometry_;
  Census census_;
};

// Of traverse.inl, without the room for Append.
constexpr int StackSize = 80 * (Width - 1) + 1;

bool AllOnce(const std::map<std::uint32_t, int>& times, std::uint32_t first, std::size_t count) {
  if (times.size() != count) return false;
  for (const auto& [id, n] : times) {
    if (n != 1 || id < first || id >= first + count) return false;
  }
  return true;
}

class Build : public testing::TestWithParam<std::tuple<test::SoupKind, BuildQuality>> {
 protected:
  Soup MakeSoup(Random& random, unsigned count) const {
    Soup soup;
    std::get<0>(GetParam()).fill(soup, random, count);
    return soup;
  }
  BuildQuality quality() const { return std::get<1>(GetParam()); }
};

TEST_P(Build, PutsEveryPrimitiveIntoOneLeafWithinItsBox) {
  Random random(710);
  for (const unsigned count : {1u, 2u, 3u, 7u, 8u, 9u, 40u, 300u, 3000u}) {
    Soup soup = MakeSoup(random, count);
    const Geometry geometry = soup.Geometry();
    const Bvh bvh(geometry, quality());
    EXPECT_EQ(bvh.droppedPrimitives(), 0u);
    const Census world = Walker(bvh, geometry).Walk(bvh.trees()[0]);
    EXPECT_EQ(world.faults, 0u);
    EXPECT_TRUE(AllOnce(world.triangles, 0, geometry.worldTriangles));
    EXPECT_LT(world.stack, StackSize);

    // All but infinite shapes and instances of empty meshes
    std::size_t shapes = 0, instances = 0;
    for (const kernel::Shape& shape : geometry.shapes) shapes += shape.kind != kernel::SHAPE_PLANE;
    for (const kernel::Instance& instance : geometry.instances)
      instances += instance.triangleCount > 0;
    EXPECT_EQ(world.shapes.size(), shapes);
    EXPECT_EQ(world.instances.size(), instances);

    // One tree per mesh, each with the mesh's triangles
    for (const kernel::Instance& instance : geometry.instances) {
      const Census mesh = Walker(bvh, geometry).Walk(bvh.trees().at(instance.root));
      EXPECT_EQ(mesh.faults, 0u);
      EXPECT_TRUE(AllOnce(mesh.triangles, instance.firstTriangle, instance.triangleCount));
    }
  }
}

TEST_P(Build, GivesTheSameBytesAtAnyNumberOfThreads) {
  const auto build = [&](int threads) {
    Random random(711);
    Soup soup = MakeSoup(random, 40000);
    const ThreadLimit limit(threads);
    return BytesOf(Bvh(soup.Geometry(), quality()));
  };
  const std::string one = build(1);
  for (const int threads : {2, 4, 0}) EXPECT_TRUE(build(threads) == one) << threads;
}

INSTANTIATE_TEST_SUITE_P(Of, Build,
                         testing::Combine(testing::ValuesIn(test::SoupKinds()),
                                          testing::Values(BuildQuality::Fast, BuildQuality::High)),
                         [](const auto& of) {
                           const bool high = std::get<1>(of.param) == BuildQuality::High;
                           return std::get<0>(of.param).name + (high ? "High" : "Fast");
                         });

constexpr BuildQuality Qualities[] = {BuildQuality::Fast, BuildQuality::High};

Census CensusOf(const std::vector<vec3>& corners, BuildQuality quality) {
  Soup soup;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
    soup.AddTriangle(corners[i], corners[i + 1], corners[i + 2]);
  const Geometry geometry = soup.Geometry();
  const Bvh bvh(geometry, quality);
  return Walker(bvh, geometry).Walk(bvh.trees()[0]);
}

TEST(TreeDepth, IsLogarithmicForEqualTriangles) {
  for (const bool points : {false, true}) {
    std::vector<vec3> corners;
    for (int i = 0; i < 100000; ++i)
      corners.insert(corners.end(), {vec3(0), vec3(points ? 0 : 1, 0, 0), vec3(0, 0, 0)});
    for (const BuildQuality quality : Qualities) {
      const Census census = CensusOf(corners, quality);
      EXPECT_EQ(census.triangles.size(), 100000u);
      EXPECT_LE(census.depth, 17);
      EXPECT_LE(census.nodes, 100000u / 4);
    }
  }
}

TEST(TreeDepth, IsBoundedForProgressionsOfSizes) {
  // Along one axis and all, tiny ones that large ones hold, and many at each size
  for (const double ratio : {1.05, 1.5, 2.0, 16.0}) {
    for (const int copies : {1, 20}) {
      for (const int pattern : {0, 1, 2}) {
        std::vector<vec3> corners;
        for (double s = 1e-17; s < 1e17; s *= ratio) {
          const float f = float(s);
          for (int copy = 0; copy < copies; ++copy) {
            switch (pattern) {
              case 0:
                corners.insert(corners.end(), {vec3(f, 0, 0), vec3(f, f, 0), vec3(f, 0, f)});
                break;
              case 1:
                corners.insert(corners.end(), {vec3(f), vec3(f, f, 0.5f * f), vec3(f * 1.1f)});
                break;
              case 2: corners.insert(corners.end(), {vec3(-f), vec3(f), vec3(f, -f, f)}); break;
            }
          }
        }
        for (const BuildQuality quality : Qualities) {
          const Census census = CensusOf(corners, quality);
          EXPECT_EQ(census.faults, 0u);
          EXPECT_EQ(census.triangles.size(), corners.size() / 3);
          EXPECT_LE(census.depth, 80);
          EXPECT_LT(census.stack, StackSize);
        }
      }
    }
  }
}

TEST(TreeDepth, StaysSmallForOrdinaryMeshes) {
  const test::TriangleMesh mesh = test::Icosphere(5);
  Soup soup;
  soup.AddWorldMesh(mesh);
  const Geometry geometry = soup.Geometry();
  const Bvh bvh(geometry);
  const Census census = Walker(bvh, geometry).Walk(bvh.trees()[0]);
  EXPECT_LE(census.depth, 10);
  // Leaves are well filled: at least two triangles to a block
  EXPECT_LE(bvh.arrays().blocks.size(), mesh.triangles.size() / 2);
  EXPECT_EQ(bvh.MemoryBytes(), bvh.arrays().nodes.size() * sizeof(WideNode) +
                                   bvh.arrays().blocks.size() * sizeof(PairBlock) +
                                   bvh.trees().size() * sizeof(Tree));
}

TEST(InstanceBoxes, AreTightAroundTurnedMeshes) {
  Random random(712);
  Soup soup;
  soup.AddInstance(soup.AddMesh(test::Icosphere(4)), glm::dmat4(1.0));
  const Geometry geometry = soup.Geometry();
  const Bvh bvh(geometry);
  const std::vector<Bounds> boxes =
      OuterBoxes(bvh.trees()[1].root, {vec3(-1.0f), vec3(1.0f)}, bvh.arrays().nodes);
  EXPECT_GT(boxes.size(), 8u);
  EXPECT_LE(boxes.size(), 64u);
  float tight = 0, loose = 0;
  for (int i = 0; i < 100; ++i) {
    const kernel::Transform map =
        test::ToKernel(test::RandomMap(random, test::MapKind::Rigid, 1.0, 0.0));
    const Bounds bounds = TransformedBounds(map, boxes);
    for (int axis = 0; axis < 3; ++axis) EXPECT_GE(bounds.Size()[axis], 1.99f);
    tight += bounds.HalfArea();
    loose += TransformedBounds(map, {vec3(-1.0f), vec3(1.0f)}).HalfArea();
  }
  // The ball's own box has the half area 12
  EXPECT_LT(tight / 100, 21.0f);
  EXPECT_GT(loose / 100, 25.0f);
}

}  // namespace
}  // namespace snell::bvh
