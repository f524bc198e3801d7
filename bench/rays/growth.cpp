// SPDX-License-Identifier: Apache-2.0
#include "rays/growth.h"

#include <fmt/format.h>

#include <algorithm>

#include "rays/report.h"
#include "util/text.h"
#include "util/threads.h"

namespace snell::bench {

namespace {

struct Column {
  const char* rays;
  QueryKind kind;
};
constexpr Column Columns[] = {
    {"primary", QueryKind::Closest}, {"diffuse", QueryKind::Closest}, {"shadow", QueryKind::Any}};

// For each contestant the seconds to build, then the million rays per second of each column.
std::vector<std::vector<double>> MeasureSize(const Scene& scene, const std::vector<Maker>& makers,
                                             std::size_t rays, int repetitions) {
  const Builds builds = MeasureBuilds(makers, scene, {HardwareThreads()});
  std::vector<std::vector<double>> values = builds.seconds;
  std::vector<const Contestant*> contestants;
  for (const auto& contestant : builds.contestants) contestants.push_back(contestant.get());

  const std::vector<Workload> workloads = MakeWorkloads(scene, *contestants[0], rays);
  for (const auto& [name, kind] : Columns) {
    const std::vector<Query>& queries =
        std::ranges::find(workloads, name, &Workload::name)->queries;
    const Seconds seconds = MeasureTracing(contestants, queries, kind, 1, repetitions);
    for (std::size_t c = 0; c < seconds.size(); ++c)
      values[c].push_back(double(queries.size()) * 1e-6 / SpreadOf(seconds[c]).median);
  }
  return values;
}

}  // namespace

std::string GrowthTable(const std::vector<std::string>& scenes, std::uint64_t triangles,
                        std::size_t rays, int repetitions) {
  const std::vector<Maker> makers = {[] { return MakeSnell(Quality::Medium); },
                                     [] { return MakeEmbree(Quality::Medium); }};
  WarmUp(makers);
  Table table(
      {"scene", "build", "triangles", fmt::format("build, s, {}", Threads(HardwareThreads())),
       "primary, closest", "diffuse, closest", "shadow, any"},
      2);
  for (const std::string& name : scenes) {
    std::vector<std::vector<double>> before;
    for (const std::uint64_t divisor : {1000, 100, 10, 1}) {
      const std::uint64_t size = std::max<std::uint64_t>(triangles / divisor, 1);
      fmt::print(stderr, "{} of {} triangles\n", name, WithCommas(size));
      const Scene scene = MakeScene(name, size);
      const auto values = MeasureSize(scene, makers, rays, repetitions);
      for (std::size_t c = 0; c < values.size(); ++c) {
        std::vector<std::string> cells = {name, c == 0 ? "Snell fast" : "Embree medium",
                                          WithCommas(scene.triangles.size())};
        for (std::size_t i = 0; i < values[c].size(); ++i) {
          const std::string ratio =
              before.empty() ? "" : fmt::format(" (×{:.2f})", values[c][i] / before[c][i]);
          cells.push_back(fmt::format("{:#.3g}{}", values[c][i], ratio));
        }
        table.Add(cells);
      }
      before = values;
    }
  }
  return fmt::format(
      "## Growth\n\nSeconds to build and million rays per second on 1 thread; in parentheses, the "
      "ratio to the\nsize before.\n\n{}",
      table.Markdown());
}

}  // namespace snell::bench
