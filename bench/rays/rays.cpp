// SPDX-License-Identifier: Apache-2.0
//
// snell-rays: Snell's traversal beside Embree's, on the same rays in one process, as Markdown tables. Exit
// codes: 0; 1 if a mesh cannot be read or Snell's answers are wrong; 2 for wrong use.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "rays/growth.h"
#include "rays/machine.h"
#include "rays/report.h"
#include "util/error.h"
#include "util/text.h"
#include "util/threads.h"

namespace snell::bench {

namespace {

struct Options {
  std::vector<std::string> scenes;
  std::vector<std::string> files;
  std::vector<std::string> kinds;
  std::vector<int> threads;
  std::uint64_t triangles = 0;
  std::size_t rays = 1000000;
  int repetitions = 5;
  std::size_t check = 100;
  bool growth = false;
};

struct Results {
  std::vector<SpeedRow> speeds;
  std::vector<BuildRow> builds;
  std::vector<CheckRow> checks;
};

// Those whose builds are measured. In the tables of speed, Snell's batches and Embree's packets follow.
std::vector<Maker> Makers() {
  return {[] { return MakeSnell(Quality::Medium); }, [] { return MakeSnell(Quality::High); },
          [] { return MakeEmbree(Quality::Medium); }, [] { return MakeEmbree(Quality::High); }};
}
constexpr std::size_t Fast = 0, High = 1, EmbreeMedium = 2, EmbreeHigh = 3;
constexpr std::size_t MostRays = 1000000000;

void AddDefaults(Options& options) {
  if (options.scenes.empty() && options.files.empty())
    options.scenes = {options.growth ? "height field" : "all"};
  if (options.scenes == std::vector<std::string>{"all"})
    options.scenes.assign(SceneNames().begin(), SceneNames().end());
  if (options.kinds.empty()) options.kinds.assign(WorkloadNames().begin(), WorkloadNames().end());
  if (options.threads.empty()) options.threads = {1, HardwareThreads()};
  std::ranges::sort(options.threads);
  const auto repeated = std::ranges::unique(options.threads);
  options.threads.erase(repeated.begin(), repeated.end());
}

void RequireKnown(const char* what, const std::vector<std::string>& names,
                  const std::vector<std::string_view>& known) {
  for (const std::string& name : names) {
    if (std::ranges::find(known, name) == known.end())
      throw CLI::ValidationError(
          fmt::format("no {} '{}'; known are {}", what, name, fmt::join(known, ", ")));
  }
}

void Validate(const Options& options) {
  RequireKnown("scene", options.scenes, SceneNames());
  RequireKnown("kind of rays", options.kinds, WorkloadNames());
  for (const int count : options.threads) {
    if (count < 1 || count > HardwareThreads())
      throw CLI::ValidationError(
          fmt::format("--threads: between 1 and {}, not {}", HardwareThreads(), count));
  }
  if (options.growth && !options.files.empty())
    throw CLI::ValidationError("--growth takes scenes that can be made larger, no files");
}

std::unique_ptr<Contestant> Built(std::unique_ptr<Contestant> contestant, const Scene& scene) {
  contestant->Build(scene);
  return contestant;
}

// The ratio of one contestant's speed to that of Embree's better build, repetition by repetition.
Spread RatioToEmbree(const Seconds& seconds, std::size_t contestant) {
  std::vector<double> ratios;
  for (std::size_t r = 0; r < seconds[contestant].size(); ++r)
    ratios.push_back(std::min(seconds[EmbreeMedium][r], seconds[EmbreeHigh][r]) /
                     seconds[contestant][r]);
  return SpreadOf(ratios);
}

SpeedRow MeasureSpeed(const std::vector<const Contestant*>& contestants, const Scene& scene,
                      const Workload& workload, QueryKind kind, int threads, int repetitions) {
  const Seconds seconds = MeasureTracing(contestants, workload.queries, kind, threads, repetitions);
  std::vector<double> speeds;
  for (const auto& some : seconds)
    speeds.push_back(double(workload.queries.size()) * 1e-6 / SpreadOf(some).median);
  const SpeedRow row = {scene.name,
                        workload.name,
                        kind,
                        threads,
                        speeds,
                        RatioToEmbree(seconds, Fast),
                        RatioToEmbree(seconds, High)};
  fmt::print(stderr, "  {}, {}, {}: {} fast, {} high\n", workload.name,
             kind == QueryKind::Any ? "any" : "closest", Threads(threads), ToString(row.fast),
             ToString(row.high));
  return row;
}

void RunScene(const Options& options, const Scene& scene, Results& results) {
  fmt::print(stderr, "{}: {} triangles\n", scene.name, WithCommas(scene.triangles.size()));
  const Builds builds = MeasureBuilds(Makers(), scene, options.threads);
  BuildRow build = {scene.name, scene.PlacedTriangles(), scene.triangles.size(),
                    {},         builds.seconds,          {}};
  for (const auto& contestant : builds.contestants) {
    build.names.push_back(contestant->Name());
    build.bytes.push_back(contestant->MemoryBytes());
  }
  results.builds.push_back(build);

  std::vector<Workload> workloads = MakeWorkloads(scene, *builds.contestants[Fast], options.rays);
  std::erase_if(workloads, [&](const Workload& workload) {
    return std::ranges::find(options.kinds, workload.name) == options.kinds.end();
  });
  const std::unique_ptr<Contestant> batches = Built(MakeSnellBatches(), scene);
  for (const Workload& workload : workloads) {
    std::vector<const Contestant*> contestants;
    for (const auto& contestant : builds.contestants) contestants.push_back(contestant.get());
    contestants.push_back(batches.get());
    std::unique_ptr<Contestant> packets;
    if (workload.name == "primary") {
      packets = Built(MakeEmbreePackets(Quality::Medium), scene);
      contestants.push_back(packets.get());
    }
    for (const QueryKind kind : {QueryKind::Closest, QueryKind::Any}) {
      for (const int threads : options.threads)
        results.speeds.push_back(
            MeasureSpeed(contestants, scene, workload, kind, threads, options.repetitions));
    }
  }

  if (options.check == 0) return;
  fmt::print(stderr, "  checking\n");
  const std::unique_ptr<Contestant> robust = Built(MakeEmbree(Quality::Medium, true), scene);
  const BruteForce bruteForce(scene);
  const Judges judges = {*builds.contestants[Fast],
                         *builds.contestants[High],
                         *batches,
                         *builds.contestants[EmbreeMedium],
                         *robust,
                         bruteForce};
  for (const Workload& workload : workloads)
    results.checks.push_back({scene.name, workload.name, Check(judges, workload, options.check)});
}

// Whether Snell's answers are right.
bool Run(const Options& options) {
  fmt::print("{}\n\n", DescribeMachine());
  if (options.growth) {
    const std::uint64_t triangles = options.triangles == 0 ? 10000000 : options.triangles;
    fmt::print("{}", GrowthTable(options.scenes, triangles, options.rays, options.repetitions));
    return true;
  }
  fmt::print(
      "{} rays of each kind, medians of {}. Ratios are of the same repetition, in brackets the "
      "least\n"
      "and the most; above 1, Snell is faster. Denormals are flushed to zero while rays are "
      "traced.\n\n",
      WithCommas(options.rays), Plural(std::uint64_t(options.repetitions), "repetition"));
  std::fflush(stdout);
  WarmUp(Makers());
  Results results;
  for (const std::string& name : options.scenes)
    RunScene(options, MakeScene(name, options.triangles), results);
  for (const std::string& path : options.files) RunScene(options, ReadScene(path), results);

  for (const int threads : options.threads) fmt::print("{}\n", SpeedTable(results.speeds, threads));
  fmt::print("{}", BuildTable(results.builds, options.threads));
  if (options.check > 0) fmt::print("\n{}", CheckTable(results.checks));
  return std::ranges::all_of(results.checks, [](const CheckRow& row) {
    return row.counts.wrongSnell == 0 && row.counts.itself == 0;
  });
}

void Define(CLI::App& app, Options& options) {
  app.add_option("files", options.files, "Meshes to trace too, or alone without --scenes")
      ->check(CLI::ExistingFile);
  app.add_option("--scenes", options.scenes,
                 fmt::format("Scenes to trace, or all: {}", fmt::join(SceneNames(), ", ")))
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--kinds", options.kinds,
                 fmt::format("Kinds of rays; all by default: {}", fmt::join(WorkloadNames(), ", ")))
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--threads", options.threads,
                 "Numbers of threads, such as 1,2; by default 1 and all that the machine has")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--triangles", options.triangles,
                 "Triangles of each scene, about; by default each scene's own number")
      ->check(CLI::Range(std::uint64_t(100), std::uint64_t(1000000000)));
  app.add_option("--rays", options.rays, "Rays of each kind")
      ->check(CLI::Range(std::size_t(256), MostRays))
      ->capture_default_str();
  app.add_option("--repetitions", options.repetitions, "Times that every measurement is taken")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--check", options.check,
                 "Rays of each kind that brute force answers too, and as many more on which Snell "
                 "and Embree differ; 0: no checks at all")
      ->check(CLI::Range(std::size_t(0), MostRays))
      ->capture_default_str();
  app.add_flag(
      "--growth", options.growth,
      "Instead, let a scene (the height field, or --scenes) grow by tens up to --triangles "
      "(10,000,000)");
}

}  // namespace

}  // namespace snell::bench

int main(int argc, char** argv) {
  using namespace snell::bench;
  Options options;
  CLI::App app("Snell's traversal beside Embree's, on the same rays in one process.", "snell-rays");
  Define(app, options);
  try {
    app.parse(argc, argv);
    AddDefaults(options);
    Validate(options);
    return Run(options) ? 0 : 1;
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "snell-rays: {}\n", error.what());
    return 2;
  } catch (const snell::Error& error) {
    fmt::print(stderr, "snell-rays: {}\n", error.what());
    return 1;
  }
}
