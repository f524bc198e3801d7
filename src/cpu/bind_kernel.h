// SPDX-License-Identifier: Apache-2.0
//
// The kernel over the arrays of a flattened scene.
#pragma once

#include "cpu/flatten.h"
#include "cpu/kernel.h"

namespace snell::cpu {

// Views of both, which must outlive the kernel.
inline Kernel BindKernel(const FlatScene& flat, const bvh::Bvh& bvh) {
  return {flat.params,         flat.objects.data(),    flat.shapes.data(),    flat.instances.data(),
          flat.meshes.data(),  flat.triangles.data(),  flat.positions.data(), flat.normals.data(),
          flat.uvs.data(),     flat.tangents.data(),   flat.colors.data(),    flat.materials.data(),
          flat.terms.data(),   flat.physicals.data(),  flat.textures.data(),  flat.images.data(),
          flat.texels.data(),  flat.grids.data(),      flat.lights.data(),    flat.emitters.data(),
          flat.albedos.data(), flat.lightNodes.data(), flat.motions.data(),   bvh};
}

}  // namespace snell::cpu
