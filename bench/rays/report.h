// SPDX-License-Identifier: Apache-2.0
//
// The benchmark's tables, as Markdown that can also be read as plain text.
#pragma once

#include <string>
#include <vector>

#include "rays/check.h"
#include "rays/measure.h"

namespace snell::bench {

class Table {
 public:
  // The first `names` columns are words, the rest numbers.
  Table(std::vector<std::string> heads, std::size_t names)
      : rows_{std::move(heads)}, names_(names) {}
  void Add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  std::string Markdown() const;

 private:
  std::vector<std::vector<std::string>> rows_;
  std::size_t names_;
};

// One line of the tables of speed.
struct SpeedRow {
  std::string scene;
  std::string rays;
  QueryKind query;
  int threads;
  // Per second: Snell fast and high, Embree medium and high, Snell's batches, and maybe Embree's packets
  std::vector<double> megaRays;
  Spread fast, high;  // times the speed of Embree's better build
};

struct BuildRow {
  std::string scene;
  std::uint64_t placed, inMemory;  // triangles
  std::vector<std::string> names;  // of the contestants, Snell's first
  Seconds seconds;                 // by contestant and number of threads
  std::vector<std::uint64_t> bytes;
};

struct CheckRow {
  std::string scene;
  std::string rays;
  Disagreements counts;
};

std::string SpeedTable(const std::vector<SpeedRow>& rows, int threads);
std::string BuildTable(const std::vector<BuildRow>& rows, const std::vector<int>& threads);
std::string CheckTable(const std::vector<CheckRow>& rows);

// "1 thread".
std::string Threads(int count);
// "1.25 [1.22–1.31]".
std::string ToString(const Spread& spread);

}  // namespace snell::bench
