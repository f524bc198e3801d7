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

// The kinds of rays: primary, shadow (to the point light), AO (short, at most a twentieth of what is seen),
// diffuse bounce, and second bounce.
const std::vector<std::string_view>& WorkloadNames();

// `count` rays of each kind, in the order in which a renderer's tiles reach them. `tracer` finds the hits
// that later rays start from; every contestant gets the same rays. There are no second bounces where no
// diffuse ray hits anything. Throws Error if the camera sees nothing.
std::vector<Workload> MakeWorkloads(const Scene& scene, const Contestant& tracer,
                                    std::size_t count);

}  // namespace snell::bench
