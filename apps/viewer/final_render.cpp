// SPDX-License-Identifier: Apache-2.0
#include "viewer/final_render.h"

#include <algorithm>
#include <exception>

namespace snell::viewer {

void FinalRender::Start(const Scene& scene, const RenderOptions& options) {
  Clear();
  stop_.emplace();
  done_ = total_ = 0;
  start_ = Clock::now();
  state_ = State::Rendering;
  work_.Start([this, scene, options] { return Render(scene, options, this, &*stop_); });
}

void FinalRender::Stop() {
  if (stop_) stop_->Raise();
}

bool FinalRender::Update() {
  if (!rendering()) return false;
  seconds_ = std::chrono::duration<double>(Clock::now() - start_).count();
  try {
    std::optional<RenderResult> result = work_.Take();
    if (!result) return false;
    result_ = std::move(result);
    fault_ = result_->report.fault;
    state_ = result_->report.stopped ? State::Stopped : State::Done;
    if (!fault_.empty()) state_ = State::Failed;
  } catch (const std::exception& error) {
    fault_ = error.what();
    state_ = State::Failed;
  }
  return true;
}

void FinalRender::Clear() {
  if (rendering()) return;
  result_.reset();
  fault_.clear();
  seconds_ = 0;
  state_ = State::None;
}

double FinalRender::Share() const {
  const std::uint64_t total = total_;
  return total > 0 ? std::min(1.0, double(done_) / double(total)) : 0;
}

double FinalRender::Seconds() const { return seconds_; }

double FinalRender::Left() const {
  const double share = Share();
  if (share < 0.001) return -1;
  const Clock::duration taken = Clock::now().time_since_epoch() - Clock::duration(phaseStart_);
  return std::chrono::duration<double>(taken).count() * (1 - share) / share;
}

void FinalRender::Begin(std::string_view, std::uint64_t total) {
  done_ = 0;
  total_ = total;
  phaseStart_ = Clock::now().time_since_epoch().count();
}

void FinalRender::Update(std::uint64_t done, std::uint64_t) { done_ = done; }

}  // namespace snell::viewer
