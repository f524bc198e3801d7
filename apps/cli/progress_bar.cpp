// SPDX-License-Identifier: Apache-2.0
#include "cli/progress_bar.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "cli/console.h"
#include "util/text.h"

namespace snell::cli {

namespace {

constexpr auto RedrawInterval = std::chrono::milliseconds(100);
constexpr double EstimateAfter = 0.5;  // seconds until the first estimate of the time left
constexpr double LeastInterval = 1;    // seconds; shorter phases pass without a plain line
constexpr double LineInterval = 10;    // seconds between plain lines, or a tenth of the time so far
constexpr int LinePercent = 10;
constexpr std::size_t SmallestBar = 10;  // characters

std::size_t TerminalWidth() {
  winsize size = {};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  return 80;
}

void WriteRaw(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

// "34 s", "2:05"
std::string TimeLeft(double seconds) {
  return seconds < 60 ? fmt::format("{:.0f} s", std::ceil(seconds)) : Duration(seconds);
}

int Percent(double fraction) { return int(std::floor(fraction * 100)); }

// "12.34 Mrays/s, 34 s left" without what is not known yet.
std::string Figures(double seconds, double fraction, double rays) {
  std::string figures;
  if (rays > 0 && seconds > 0) figures = fmt::format("{:.2f} Mrays/s", rays / seconds * 1e-6);
  if (fraction > 0 && seconds >= EstimateAfter) {
    if (!figures.empty()) figures += ", ";
    figures += TimeLeft(seconds * (1 - fraction) / fraction) + " left";
  }
  return figures;
}

// "rendering  42% [======        ] 12.34 Mrays/s, 34 s left"; the bar takes the room that is left.
std::string BarText(const std::string& phase, double fraction, const std::string& figures,
                    std::size_t width) {
  std::string text = fmt::format("{:<9} {:>3}% ", phase, Percent(fraction));
  const std::size_t taken = text.size() + figures.size() + 3;
  if (taken + SmallestBar <= width) {
    const std::size_t room = width - taken;
    const std::size_t filled = std::size_t(fraction * double(room));
    text += "[" + std::string(filled, '=') + std::string(room - filled, ' ') + "] ";
  }
  return text + figures;
}

}  // namespace

ProgressStyle SuitableStyle() {
  const char* terminal = std::getenv("TERM");
  const bool canRedraw = terminal && *terminal && std::string_view(terminal) != "dumb";
  return isatty(STDERR_FILENO) && canRedraw ? ProgressStyle::Bar : ProgressStyle::Lines;
}

ProgressBar::ProgressBar(ProgressStyle style, const StopFlag* stop) : style_(style), stop_(stop) {
  if (style_ != ProgressStyle::None) watcher_ = std::thread([this] { Watch(); });
}

ProgressBar::~ProgressBar() {
  if (!watcher_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    finished_ = true;
    Clear();
  }
  wake_.notify_one();
  watcher_.join();
}

void ProgressBar::Begin(std::string_view phase, std::uint64_t total) {
  const std::lock_guard lock(mutex_);
  phase_ = phase;
  total_ = total;
  timer_ = {};
  done_ = 0;
  rays_ = 0;
  lineSeconds_ = 0;
  linePercent_ = 0;
}

void ProgressBar::Update(std::uint64_t done, std::uint64_t rays) {
  // Workers may overtake one another; progress only goes forward
  for (std::uint64_t old = done_; old < done && !done_.compare_exchange_weak(old, done);) {
  }
  for (std::uint64_t old = rays_; old < rays && !rays_.compare_exchange_weak(old, rays);) {
  }
}

void ProgressBar::End() {
  const std::lock_guard lock(mutex_);
  Clear();
  phase_.clear();
}

void ProgressBar::Interrupt(const std::function<void()>& print) {
  const std::lock_guard lock(mutex_);
  Clear();
  print();
}

void ProgressBar::Watch() {
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, RedrawInterval, [this] { return finished_; })) {
    if (phase_.empty()) continue;
    if (style_ == ProgressStyle::Bar)
      Draw();
    else
      PrintLineIfDue();
  }
}

ProgressBar::State ProgressBar::Now() const {
  State state;
  state.phase = stop_ && stop_->raised() ? "stopping" : phase_;
  state.seconds = timer_.Seconds();
  if (total_ > 0) state.fraction = std::min(1.0, double(done_) / double(total_));
  state.rays = double(rays_);
  return state;
}

void ProgressBar::Draw() {
  const State state = Now();
  const std::size_t width = TerminalWidth() - 1;
  std::string line = state.fraction < 0
                         ? fmt::format("{} {}", state.phase, Duration(state.seconds))
                         : BarText(state.phase, state.fraction,
                                   Figures(state.seconds, state.fraction, state.rays), width);
  line.resize(width, ' ');
  WriteRaw("\r" + line);
  drawn_ = true;
}

void ProgressBar::Clear() {
  if (!drawn_) return;
  WriteRaw("\r" + std::string(TerminalWidth() - 1, ' ') + "\r");
  drawn_ = false;
}

void ProgressBar::PrintLineIfDue() {
  const State state = Now();
  const int percent = Percent(std::max(state.fraction, 0.0));
  const bool farther = percent / LinePercent > linePercent_ / LinePercent && percent < 100;
  const bool first = lineSeconds_ == 0;
  const double since = state.seconds - lineSeconds_;
  const bool due = since >= std::max(LineInterval, state.seconds / 10);
  if (since < LeastInterval || !(first || farther || due)) return;

  lineSeconds_ = state.seconds;
  linePercent_ = percent;
  if (state.fraction < 0)
    return PrintNote(fmt::format("{} {}", state.phase, Duration(state.seconds)));
  const std::string figures = Figures(state.seconds, state.fraction, state.rays);
  PrintNote(fmt::format("{} {} %{}{}", state.phase, percent, figures.empty() ? "" : ", ", figures));
}

}  // namespace snell::cli
