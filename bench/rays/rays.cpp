// SPDX-License-Identifier: Apache-2.0
//
// snell-rays: Snell's traversal beside Embree's, on the same rays in one process, as Markdown tables.
#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "rays/contestant.h"
#include "rays/workload.h"
#include "util/error.h"
#include "util/threads.h"
#include "util/timer.h"

namespace snell::bench {

namespace {

struct Options {
  std::vector<std::string> scenes;
  std::vector<std::string> rays;
  std::vector<std::string> files;
  std::vector<std::string> contestants;
  std::size_t rayCount = 1000000;
  int repetitions = 5;
  std::vector<int> threads;
  std::uint64_t triangles = 0;
};

// Answer all queries with so many threads; returns the seconds it took.
double Trace(const Contestant& contestant, const std::vector<Query>& queries, bool any, int threads,
             std::vector<Answer>& answers) {
  const auto part = [&](std::size_t first, std::size_t last) {
    const std::span<const Query> some(queries.data() + first, last - first);
    if (any)
      contestant.Any(some, answers.data() + first);
    else
      contestant.Closest(some, answers.data() + first);
  };
  const Timer timer;
  if (threads == 1) {
    part(0, queries.size());
  } else {
    const ThreadLimit limit(threads);
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, queries.size(), 4096),
        [&](const auto& range) { part(range.begin(), range.end()); }, tbb::simple_partitioner());
  }
  return timer.Seconds();
}

double Median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

void Run(const Options& options) {
  std::vector<Scene> scenes;
  for (const std::string& name : options.scenes) {
    fmt::print(stderr, "making {}\n", name);
    const Scene scene = MakeScene(name, options.triangles);
    std::vector<std::unique_ptr<Contestant>> contestants;
    for (const std::string& c : options.contestants) {
      if (c == "snell") contestants.push_back(MakeSnell(Quality::Medium));
      if (c == "embree") contestants.push_back(MakeEmbree(Quality::Medium));
      if (c == "embree-high") contestants.push_back(MakeEmbree(Quality::High));
      if (c == "embree-robust") contestants.push_back(MakeEmbree(Quality::Medium, true));
    }
    for (auto& c : contestants) {
      Timer timer;
      c->Build(scene);
      fmt::print("{} {} tris: {} build {:.3f} s, {:.1f} B/tri\n", scene.name,
                 scene.triangles.size(), c->Name(), timer.Seconds(),
                 double(c->MemoryBytes()) / double(scene.triangles.size()));
    }
    const std::vector<Workload> workloads =
        MakeWorkloads(scene, *contestants.back(), options.rayCount);
    std::vector<Answer> answers(options.rayCount);
    for (const Workload& w : workloads) {
      if (!options.rays.empty() && std::ranges::find(options.rays, w.name) == options.rays.end())
        continue;
      for (const bool any : {false, true}) {
        for (const int threads : options.threads) {
          std::vector<std::vector<double>> times(contestants.size());
          for (int r = 0; r < options.repetitions; ++r)
            for (std::size_t c = 0; c < contestants.size(); ++c)
              times[c].push_back(Trace(*contestants[c], w.queries, any, threads, answers));
          fmt::print("{:14} {:8} {:8} {}t", scene.name, w.name, any ? "any" : "closest", threads);
          for (std::size_t c = 0; c < contestants.size(); ++c)
            fmt::print("  {}: {:.2f}", contestants[c]->Name(),
                       double(w.queries.size()) / Median(times[c]) * 1e-6);
          for (std::size_t c = 1; c < contestants.size(); ++c) {
            std::vector<double> ratios;
            for (int r = 0; r < options.repetitions; ++r)
              ratios.push_back(times[c][std::size_t(r)] / times[0][std::size_t(r)]);
            fmt::print("  x{:.2f}", Median(ratios));
          }
          fmt::print("\n");
          std::fflush(stdout);
        }
      }
    }
  }
}

}  // namespace

}  // namespace snell::bench

int main(int argc, char** argv) {
  using namespace snell::bench;
  Options options;
  for (const auto name : SceneNames()) options.scenes.emplace_back(name);
  options.contestants = {"snell", "embree", "embree-high"};
  options.threads = {1};
  CLI::App app("Snell's traversal beside Embree's");
  app.add_option("--scenes", options.scenes)->delimiter(',');
  app.add_option("--kinds", options.rays)->delimiter(',');
  app.add_option("--contestants", options.contestants)->delimiter(',');
  app.add_option("--rays", options.rayCount);
  app.add_option("--repetitions", options.repetitions);
  app.add_option("--threads", options.threads)->delimiter(',');
  app.add_option("--triangles", options.triangles);
  CLI11_PARSE(app, argc, argv);
  try {
    Run(options);
  } catch (const snell::Error& error) {
    std::fprintf(stderr, "snell-rays: %s\n", error.what());
    return 1;
  }
}
