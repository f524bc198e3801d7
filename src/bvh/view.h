// SPDX-License-Identifier: Apache-2.0
//
// All that a traversal reads, as plain pointers: the files that are compiled for one instruction set call no
// functions of others (traverse.inl says why).
#pragma once

#include "bvh/node.h"
#include "kernel/types.h"

namespace snell::bvh {

struct View {
  const WideNode* nodes = nullptr;
  const PairBlock* blocks = nullptr;
  const std::uint32_t* items = nullptr;      // shapes or instances of leaves
  const Tree* trees = nullptr;               // the first is the world's
  const std::uint32_t* unbounded = nullptr;  // shapes without bounds, which every ray tests
  std::uint32_t unboundedCount = 0;
  std::uint32_t treeMask = 0;  // of all objects that the world's tree holds, together

  // The caller's geometry
  const kernel::Triangle* triangles = nullptr;
  const kernel::Mesh* meshes = nullptr;
  const kernel::Shape* shapes = nullptr;
  const kernel::Instance* instances = nullptr;
  const kernel::Object* objects = nullptr;
};

}  // namespace snell::bvh
