// SPDX-License-Identifier: Apache-2.0
//
// How long the contestants take. They take turns within every repetition, so that what slows the machine down
// for a while slows all of them.
#pragma once

#include <functional>
#include <vector>

#include "rays/workload.h"

namespace snell::bench {

enum class QueryKind { Closest, Any };

using Maker = std::function<std::unique_ptr<Contestant>()>;
using Contestants = std::vector<std::unique_ptr<Contestant>>;

// Flushes denormals to zero on this thread while it lives, as Embree recommends for tracing.
class FlushDenormals {
 public:
  FlushDenormals();
  ~FlushDenormals();
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  unsigned state_;
};

// Answer all rays on so many threads; returns the seconds that it took. `answers` has a place for each ray.
double Trace(const Contestant& contestant, const std::vector<Query>& queries, QueryKind kind,
             int threads, std::vector<Answer>& answers);

// Seconds by contestant and repetition.
using Seconds = std::vector<std::vector<double>>;
Seconds MeasureTracing(const std::vector<const Contestant*>& contestants,
                       const std::vector<Query>& queries, QueryKind kind, int threads,
                       int repetitions);

struct Builds {
  Contestants contestants;  // as built last
  Seconds seconds;          // by contestant and number of threads, the best of three
};
Builds MeasureBuilds(const std::vector<Maker>& makers, const Scene& scene,
                     const std::vector<int>& threads);

// Build over next to nothing, so that the libraries' threads and code are warm.
void WarmUp(const std::vector<Maker>& makers);

// The middle, the least and the most of some values.
struct Spread {
  double median, least, most;
};
Spread SpreadOf(std::vector<double> values);

}  // namespace snell::bench
