// SPDX-License-Identifier: Apache-2.0
//
// A scene made ready for rendering, on whatever device: flattened, and with its tree.
#pragma once

#include "bvh/bvh.h"
#include "cpu/flatten.h"
#include "render/renderer.h"
#include "util/timer.h"

namespace snell::cpu {

class PreparedScene {
 public:
  // Tells times, sizes and warnings. Throws Error, also if the film holds samples of another picture.
  PreparedScene(const scene::Scene& scene, const render::RenderRequest& request, render::Film& film,
                Progress* progress, render::Statistics& statistics);
  PreparedScene(const PreparedScene&) = delete;
  PreparedScene& operator=(const PreparedScene&) = delete;

  // See it by another camera, as ReplaceCamera (cpu/flatten_camera.h). Nobody may be rendering it.
  void SetCamera(const scene::Camera& camera, const scene::RenderSettings& settings);

  const FlatScene& flat() const { return flat_; }
  const bvh::Bvh& bvh() const { return bvh_; }
  // What the tree was built over.
  const bvh::Geometry& geometry() const { return geometry_; }

 private:
  FlatScene flat_;
  Timer sinceFlattened_;
  bvh::Geometry geometry_;
  bvh::Bvh bvh_;
};

}  // namespace snell::cpu
