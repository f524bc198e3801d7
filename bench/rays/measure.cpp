// SPDX-License-Identifier: Apache-2.0
#include "rays/measure.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#ifdef __SSE__
#include <xmmintrin.h>
#endif

#include "util/threads.h"
#include "util/timer.h"

namespace snell::bench {

namespace {

constexpr int BuildRepetitions = 3;
constexpr std::size_t RaysPerTask = 1024;

}  // namespace

#ifdef __SSE__
FlushDenormals::FlushDenormals() : state_(_mm_getcsr()) {
  constexpr unsigned DenormalsAreZero = 0x40;
  _mm_setcsr(state_ | _MM_FLUSH_ZERO_ON | DenormalsAreZero);
}
FlushDenormals::~FlushDenormals() { _mm_setcsr(state_); }
#else
FlushDenormals::FlushDenormals() : state_(0) {}
FlushDenormals::~FlushDenormals() = default;
#endif

double Trace(const Contestant& contestant, const std::vector<Query>& queries, QueryKind kind,
             int threads, std::vector<Answer>& answers) {
  const auto part = [&](std::size_t first, std::size_t last) {
    const FlushDenormals flush;
    const std::span<const Query> some(queries.data() + first, last - first);
    if (kind == QueryKind::Any)
      contestant.Any(some, answers.data() + first);
    else
      contestant.Closest(some, answers.data() + first);
  };
  const ThreadLimit limit(threads);
  const Timer timer;
  if (threads == 1) {
    part(0, queries.size());
  } else {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, queries.size(), RaysPerTask),
        [&](const auto& range) { part(range.begin(), range.end()); }, tbb::simple_partitioner());
  }
  return timer.Seconds();
}

Seconds MeasureTracing(const std::vector<const Contestant*>& contestants,
                       const std::vector<Query>& queries, QueryKind kind, int threads,
                       int repetitions) {
  std::vector<Answer> answers(queries.size());
  // Wake threads and fill caches
  const std::vector<Query> few(queries.begin(),
                               queries.begin() + std::ptrdiff_t(queries.size() / 8));
  for (const Contestant* contestant : contestants) Trace(*contestant, few, kind, threads, answers);

  Seconds seconds(contestants.size());
  for (int r = 0; r < repetitions; ++r) {
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      // Another one begins each time
      const std::size_t c = (i + std::size_t(r)) % contestants.size();
      seconds[c].push_back(Trace(*contestants[c], queries, kind, threads, answers));
    }
  }
  return seconds;
}

Builds MeasureBuilds(const std::vector<Maker>& makers, const Scene& scene,
                     const std::vector<int>& threads) {
  Builds builds;
  builds.contestants.resize(makers.size());
  builds.seconds.assign(
      makers.size(), std::vector<double>(threads.size(), std::numeric_limits<double>::infinity()));
  for (int r = 0; r < BuildRepetitions; ++r) {
    for (std::size_t t = 0; t < threads.size(); ++t) {
      const ThreadLimit limit(threads[t]);
      for (std::size_t c = 0; c < makers.size(); ++c) {
        // The old one goes first, which bounds the memory
        builds.contestants[c].reset();
        builds.contestants[c] = makers[c]();
        const Timer timer;
        builds.contestants[c]->Build(scene);
        builds.seconds[c][t] = std::min(builds.seconds[c][t], timer.Seconds());
      }
    }
  }
  return builds;
}

void WarmUp(const std::vector<Maker>& makers) {
  const Scene scene = MakeScene("sphereflake", 10000);
  for (const Maker& make : makers) make()->Build(scene);
}

Spread SpreadOf(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t n = values.size();
  const double median = n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
  return {median, values.front(), values.back()};
}

}  // namespace snell::bench
