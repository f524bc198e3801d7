// SPDX-License-Identifier: Apache-2.0
//
// The render that counts: with the final settings, on a thread of its own, with progress and a way to stop it.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "api/render.h"
#include "viewer/background.h"

namespace snell::viewer {

class FinalRender : private Progress {
 public:
  enum class State { None, Rendering, Done, Stopped, Failed };

  ~FinalRender() override { Stop(); }

  // Only when none is under way.
  void Start(const Scene& scene, const RenderOptions& options);
  // The picture so far becomes the result.
  void Stop();
  // Look whether it has ended. True: just now.
  bool Update();
  // Forget the result.
  void Clear();

  State state() const { return state_; }
  bool rendering() const { return state_ == State::Rendering; }
  // If it is Done or Stopped.
  const std::optional<RenderResult>& result() const { return result_; }
  const std::string& fault() const { return fault_; }  // if it has Failed

  double Share() const;    // of the work, 0 to 1
  double Seconds() const;  // that it has taken
  double Left() const;     // seconds, a guess; below 0: not known yet

 private:
  using Clock = std::chrono::steady_clock;

  void Begin(std::string_view phase, std::uint64_t total) override;
  void Update(std::uint64_t done, std::uint64_t rays) override;
  void End() override {}

  State state_ = State::None;
  std::optional<RenderResult> result_;
  std::string fault_;
  Clock::time_point start_;
  double seconds_ = 0;
  std::atomic<std::uint64_t> done_{0};
  std::atomic<std::uint64_t> total_{0};
  std::atomic<Clock::rep> phaseStart_{0};
  std::optional<StopFlag> stop_;
  Background<RenderResult> work_;  // last: it uses all of these until it ends
};

}  // namespace snell::viewer
