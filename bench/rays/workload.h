// SPDX-License-Identifier: Apache-2.0
//
// The rays of the benchmark, as a renderer would trace them: from the camera, and from where those hit on.
#pragma once

#include "rays/contestant.h"

namespace snell::bench {

struct Workload {
  std::string name;
  std::vector<Query> queries;
};

// `count` rays of each kind: primary, shadow (to the point light), AO (short, at most a twentieth of what is
// seen), diffuse bounce, and second bounce, in the order in which a renderer's tiles reach them. `tracer`
// finds the hits that later rays start from; every contestant gets the same rays.
std::vector<Workload> MakeWorkloads(const Scene& scene, const Contestant& tracer,
                                    std::size_t count);

}  // namespace snell::bench
