// SPDX-License-Identifier: Apache-2.0
#include "rays/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "util/text.h"

namespace snell::bench {

namespace {

// Characters, not bytes.
std::size_t WidthOf(const std::string& text) {
  return std::size_t(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) >> 6) != 2; }));
}

std::string Ratio(double value) { return fmt::format("{:.2f}", value); }

// Three digits, of which two may be decimals.
std::string Speed(double value) {
  return fmt::format("{:.{}f}", value, value < 9.995 ? 2 : value < 99.95 ? 1 : 0);
}

// The row with the smallest of a ratio and the geometric mean of all.
std::string Closing(const std::vector<const SpeedRow*>& rows, const char* name,
                    Spread SpeedRow::*ratio) {
  const SpeedRow* worst = rows.front();
  double logs = 0;
  for (const SpeedRow* row : rows) {
    if ((row->*ratio).median < (worst->*ratio).median) worst = row;
    logs += std::log((row->*ratio).median);
  }
  return fmt::format("{}: smallest {:.2f} ({}, {}, {}), geometric mean {:.2f}", name,
                     (worst->*ratio).median, worst->scene, worst->rays,
                     worst->query == QueryKind::Any ? "any" : "closest",
                     std::exp(logs / double(rows.size())));
}

}  // namespace

std::string Table::Markdown() const {
  std::vector<std::size_t> widths(rows_[0].size(), 3);
  for (const auto& row : rows_) {
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], WidthOf(row[c]));
  }
  std::string text;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    for (std::size_t c = 0; c < widths.size(); ++c) {
      const std::string& cell = rows_[r][c];
      const std::string padding(widths[c] - WidthOf(cell), ' ');
      text += c < names_ ? "| " + cell + padding + " " : "| " + padding + cell + " ";
    }
    text += "|\n";
    for (std::size_t c = 0; c < widths.size() && r == 0; ++c)
      text += "|" + std::string(widths[c] + 1, '-') + (c < names_ ? "-" : ":");
    if (r == 0) text += "|\n";
  }
  return text;
}

std::string SpeedTable(const std::vector<SpeedRow>& rows, int threads) {
  std::vector<const SpeedRow*> chosen;
  for (const SpeedRow& row : rows) {
    if (row.threads == threads) chosen.push_back(&row);
  }
  if (chosen.empty()) return "";
  std::size_t speeds = 0;
  for (const SpeedRow* row : chosen) speeds = std::max(speeds, row->megaRays.size());
  std::vector<std::string> heads = {"scene",    "rays",   "query",   "fast",     "high",
                                    "E medium", "E high", "batches", "E packets"};
  heads.resize(3 + speeds);
  heads.insert(heads.end(), {"fast/best E", "high/best E"});
  Table table(heads, 3);
  for (const SpeedRow* row : chosen) {
    std::vector<std::string> cells = {row->scene, row->rays,
                                      row->query == QueryKind::Any ? "any" : "closest"};
    for (const double speed : row->megaRays) cells.push_back(Speed(speed));
    cells.resize(3 + speeds);
    cells.insert(cells.end(), {ToString(row->fast), ToString(row->high)});
    table.Add(cells);
  }
  return fmt::format(
      "## Million rays per second, {}\n\n{}\nRatios to Embree's better build on {}. {}. {}.\n",
      Threads(threads), table.Markdown(), Threads(threads),
      Closing(chosen, "Fast", &SpeedRow::fast), Closing(chosen, "High", &SpeedRow::high));
}

std::string BuildTable(const std::vector<BuildRow>& rows, const std::vector<int>& threads) {
  std::vector<std::string> heads = {"scene", "build", "triangles placed", "in memory"};
  for (const int count : threads) heads.push_back(fmt::format("s, {}", Threads(count)));
  heads.push_back("bytes/triangle");
  for (const int count : threads) heads.push_back(fmt::format("ratio, {}", Threads(count)));
  heads.push_back("ratio of bytes");
  Table table(heads, 2);
  for (const BuildRow& row : rows) {
    // Snell's builds stand before Embree's of the same quality
    const std::size_t qualities = row.names.size() / 2;
    for (std::size_t c = 0; c < row.names.size(); ++c) {
      const bool first = c == 0, ours = c < qualities;
      std::vector<std::string> cells = {first ? row.scene : "", row.names[c],
                                        first ? WithCommas(row.placed) : "",
                                        first ? WithCommas(row.inMemory) : ""};
      for (const double seconds : row.seconds[c]) cells.push_back(fmt::format("{:#.3g}", seconds));
      cells.push_back(fmt::format("{:.1f}", double(row.bytes[c]) / double(row.inMemory)));
      for (std::size_t t = 0; t < threads.size(); ++t)
        cells.push_back(ours ? Ratio(row.seconds[c + qualities][t] / row.seconds[c][t]) : "");
      cells.push_back(ours ? Ratio(double(row.bytes[c + qualities]) / double(row.bytes[c])) : "");
      table.Add(cells);
    }
  }
  return fmt::format(
      "## Builds\n\nRatios compare Embree's medium build with Snell's fast one, and high with "
      "high; "
      "above 1, Snell takes less.\n\n{}",
      table.Markdown());
}

std::string CheckTable(const std::vector<CheckRow>& rows) {
  Table table({"scene", "rays", "itself", "hits", "t", "robust hits", "robust t", "judged",
               "wrong Snell", "wrong Embree", "nearer Snell", "nearer Embree"},
              2);
  std::uint64_t judged = 0, wrong = 0, itself = 0;
  for (const auto& [scene, rays, counts] : rows) {
    table.Add({scene, rays, WithCommas(counts.itself), WithCommas(counts.embree.hits),
               WithCommas(counts.embree.distances), WithCommas(counts.robust.hits),
               WithCommas(counts.robust.distances), WithCommas(counts.judged),
               WithCommas(counts.wrongSnell), WithCommas(counts.wrongEmbree),
               WithCommas(counts.nearerSnell), WithCommas(counts.nearerEmbree)});
    judged += counts.judged;
    wrong += counts.wrongSnell;
    itself += counts.itself;
  }
  return fmt::format(
      "## Disagreements\n\n"
      "Rays on which Snell differs from itself (between its builds, between closest and any, "
      "between\n"
      "single rays and batches, with and without denormals; to the bit), and from Embree's medium\n"
      "build without and with its robust flag: in whether there is a hit, or in t by more than "
      "1e-4 of\n"
      "it. Of the judged rays, those whose t is beyond rounding from a search of all triangles in\n"
      "double precision, and, where Snell and Embree differ, who is nearer to it.\n\n"
      "{}\nSnell disagrees with brute force on {} of {} rays, with itself on {}.\n",
      table.Markdown(), WithCommas(wrong), WithCommas(judged), WithCommas(itself));
}

std::string Threads(int count) { return Plural(std::uint64_t(count), "thread"); }

std::string ToString(const Spread& spread) {
  return fmt::format("{:.2f} [{:.2f}–{:.2f}]", spread.median, spread.least, spread.most);
}

}  // namespace snell::bench
