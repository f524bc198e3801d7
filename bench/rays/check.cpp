// SPDX-License-Identifier: Apache-2.0
#include "rays/check.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "util/threads.h"

namespace snell::bench {

namespace {

using Answers = std::vector<Answer>;

constexpr int Described = 3;
constexpr double Inf = std::numeric_limits<double>::infinity();

Answers AnswersOf(const Contestant& contestant, const std::vector<Query>& queries, QueryKind kind) {
  Answers answers(queries.size());
  Trace(contestant, queries, kind, HardwareThreads(), answers);
  return answers;
}

bool IsHit(const Answer& answer) { return std::isfinite(answer.t); }

bool SameBits(const Answer& a, const Answer& b) {
  return std::bit_cast<std::uint32_t>(a.t) == std::bit_cast<std::uint32_t>(b.t) &&
         (!IsHit(a) || (a.primitive == b.primitive && a.instance == b.instance));
}

bool SameHit(const Answer& a, const Answer& b) { return IsHit(a) == IsHit(b); }
bool SameDistance(const Answer& a, const Answer& b) {
  return !IsHit(a) || std::abs(a.t - b.t) <= 1e-4f * std::max(a.t, b.t);
}
bool Alike(const Answer& a, const Answer& b) { return SameHit(a, b) && SameDistance(a, b); }

Difference Compare(const Answers& a, const Answers& b) {
  Difference difference;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!SameHit(a[i], b[i]))
      ++difference.hits;
    else if (!SameDistance(a[i], b[i]))
      ++difference.distances;
  }
  return difference;
}

std::uint64_t DifferencesWithItself(const Judges& judges, const std::vector<Query>& queries,
                                    const Answers& fast) {
  const Answers high = AnswersOf(judges.high, queries, QueryKind::Closest);
  const Answers batches = AnswersOf(judges.batches, queries, QueryKind::Closest);
  const Answers anyFast = AnswersOf(judges.fast, queries, QueryKind::Any);
  const Answers anyHigh = AnswersOf(judges.high, queries, QueryKind::Any);
  const Answers anyBatches = AnswersOf(judges.batches, queries, QueryKind::Any);
  Answers denormals(queries.size());
  judges.fast.Closest(queries, denormals.data());
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    count += !SameBits(fast[i], high[i]) || !SameBits(fast[i], batches[i]) ||
             !SameBits(fast[i], denormals[i]) || !SameHit(fast[i], anyFast[i]) ||
             !SameHit(fast[i], anyHigh[i]) || !SameHit(fast[i], anyBatches[i]);
  }
  return count;
}

// The smaller, the nearer.
double Distance(const Answer& answer, const Truth& truth) {
  if (IsHit(answer) != std::isfinite(truth.nearest)) return Inf;
  return IsHit(answer) ? std::abs(double(answer.t) - truth.nearest) : 0;
}

void Describe(const Workload& workload, std::size_t ray, const Answer& answer, const Truth& truth) {
  const auto& [o, d, time] = workload.queries[ray].ray;
  fmt::print(stderr,
             "  wrong: {} ray {} from ({:a}, {:a}, {:a}) towards ({:a}, {:a}, {:a}), tMax {}: "
             "t = {} instead of {}\n",
             workload.name, ray, o.x, o.y, o.z, d.x, d.y, d.z, workload.queries[ray].tMax, answer.t,
             truth.nearest);
}

}  // namespace

Disagreements Check(const Judges& judges, const Workload& workload, std::size_t count) {
  const std::vector<Query>& queries = workload.queries;
  const Answers fast = AnswersOf(judges.fast, queries, QueryKind::Closest);
  const Answers embree = AnswersOf(judges.embree, queries, QueryKind::Closest);
  const Answers robust = AnswersOf(judges.robust, queries, QueryKind::Closest);
  Disagreements result;
  result.itself = DifferencesWithItself(judges, queries, fast);
  result.embree = Compare(fast, embree);
  result.robust = Compare(fast, robust);

  // Choose the rays for the referee
  const std::size_t stride = std::max<std::size_t>(queries.size() / count, 1);
  std::vector<std::size_t> rays;
  std::size_t differing = 0;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const bool differs = !Alike(fast[i], embree[i]) || !Alike(fast[i], robust[i]);
    if (i % stride == 0 || (differs && differing++ < count)) rays.push_back(i);
  }
  std::vector<Truth> truths(rays.size());
  tbb::parallel_for(std::size_t(0), rays.size(),
                    [&](std::size_t i) { truths[i] = judges.bruteForce.Trace(queries[rays[i]]); });

  result.judged = rays.size();
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Answer& ours = fast[rays[i]];
    const Answer& theirs = embree[rays[i]];
    if (!truths[i].Allows(theirs.t)) ++result.wrongEmbree;
    if (!truths[i].Allows(ours.t) && ++result.wrongSnell <= Described)
      Describe(workload, rays[i], ours, truths[i]);
    if (Alike(ours, theirs)) continue;
    const double our = Distance(ours, truths[i]), their = Distance(theirs, truths[i]);
    result.nearerSnell += our < their;
    result.nearerEmbree += their < our;
  }
  return result;
}

}  // namespace snell::bench
