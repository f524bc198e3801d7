// SPDX-License-Identifier: Apache-2.0
//
// Progress on the standard error output: at a terminal one line that is redrawn, elsewhere a plain line now
// and then. A thread of its own does the drawing, so that whoever works only stores two numbers.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "util/progress.h"
#include "util/timer.h"

namespace snell::cli {

enum class ProgressStyle { None, Bar, Lines };

// A bar if the standard error output is a terminal that can return to a line's beginning.
ProgressStyle SuitableStyle();

// Progress of one phase at a time.
class ProgressBar final : public Progress {
 public:
  // `stop` may be null; once it is raised the bar says "stopping".
  explicit ProgressBar(ProgressStyle style, const StopFlag* stop = nullptr);
  ~ProgressBar() override;

  void Begin(std::string_view phase, std::uint64_t total) override;
  void Update(std::uint64_t done, std::uint64_t rays) override;
  void End() override;

  // Call `print`, which may print lines, while the bar is out of the way.
  void Interrupt(const std::function<void()>& print);

 private:
  struct State {
    std::string phase;
    double seconds = 0;
    double fraction = -1;  // unknown if negative
    double rays = 0;
  };
  State Now() const;
  void Watch();
  void Draw();
  void Clear();
  void PrintLineIfDue();

  const ProgressStyle style_;
  const StopFlag* const stop_;
  std::atomic<std::uint64_t> done_{0};
  std::atomic<std::uint64_t> rays_{0};

  std::mutex mutex_;   // guards all that follows
  std::string phase_;  // "" between phases
  std::uint64_t total_ = 0;
  Timer timer_;
  bool drawn_ = false;
  double lineSeconds_ = 0;  // when the last plain line was printed, and where the phase stood
  int linePercent_ = 0;
  bool finished_ = false;
  std::condition_variable wake_;
  std::thread watcher_;
};

}  // namespace snell::cli
