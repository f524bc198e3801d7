// SPDX-License-Identifier: Apache-2.0
//
// How far a render is: in samples, or, where time or noise may end it sooner, in millionths of it.
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>

#include "render/schedule.h"

namespace snell::render {

class Meter {
 public:
  Meter(Progress* progress, const StopConditions& stop, const PassPlan& plan)
      : progress_(progress), stop_(stop), plain_(!(stop.noise > 0) && std::isinf(stop.seconds)) {
    Plan(plan);
    if (progress_) progress_->Begin("rendering", plain_ ? plan.remaining : Millionths);
  }
  ~Meter() {
    if (progress_) progress_->End();
  }
  Meter(const Meter&) = delete;
  Meter& operator=(const Meter&) = delete;

  // Between passes.
  void Plan(const PassPlan& plan) { expected_ = samples_ + plan.remaining; }

  // For any thread.
  void Add(std::uint64_t newSamples, std::uint64_t newRays) {
    const std::uint64_t samples = samples_ += newSamples;
    const std::uint64_t rays = rays_ += newRays;
    if (!progress_) return;
    const double share =
        std::max(double(samples) / double(expected_), timer_.Seconds() / stop_.seconds);
    progress_->Update(plain_ ? samples : std::uint64_t(std::min(share, 1.0) * Millionths), rays);
  }

 private:
  static constexpr std::uint64_t Millionths = 1000000;

  Progress* const progress_;
  const StopConditions& stop_;
  const bool plain_;
  Timer timer_;
  std::uint64_t expected_ = 0;
  std::atomic<std::uint64_t> samples_{0};
  std::atomic<std::uint64_t> rays_{0};
};

}  // namespace snell::render
