// SPDX-License-Identifier: Apache-2.0
//
// Which samples come next, and when a render ends. Work goes in passes over the picture: at the end of each, every
// pixel gets a goal for the next one, from what the film holds and nothing else. So a render that is gone on with
// from a saved film takes the same decisions as one that was never interrupted.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>

#include "render/film.h"
#include "util/progress.h"
#include "util/timer.h"

namespace snell::render {

// Why a render ended.
enum class End { Samples, Noise, Time, Stopped, Fault };

// A render ends at the first of these.
struct StopConditions {
  double seconds =
      std::numeric_limits<double>::infinity();  // but not before each pixel has a sample
  float noise = 0;        // the largest error that pixels may have (noise.h); 0: none is asked
  double noiseScale = 1;  // the exposure at which it counts
};

// Samples that a pixel has before its noise is judged: rare light is overlooked less often.
inline constexpr std::uint32_t LeastSamplesForNoise = 64;

// Samples that the next pass adds to a pixel with `count` of them: 1, 1, 2, 4, … 64, 64, ….
std::uint32_t PassSize(std::uint32_t count);

struct PassPlan {
  std::uint64_t samples = 0;    // in this pass; 0: the render has ended
  std::uint64_t remaining = 0;  // in this and all that come, as a guess if noise ends the render
  std::uint64_t resting = 0;    // pixels that have reached the noise
  bool hasPicture = true;       // each pixel has a sample
};

// Set the goals of the next pass, or keep those of one that is not finished. No pixel goes on to sample
// `lastSample`; pixels rest while they and all within two pixels of them have reached the noise.
PassPlan PlanPass(Film& film, std::uint32_t lastSample, const StopConditions& stop);

// Saving a film while it is rendered.
struct SavePlan {
  std::function<void(const Film&)> save;  // empty: never
  double interval = 60;                   // seconds; more if saving takes more than 5 % of them
};

// What interrupts workers: the wish to stop, the end of the time, a film that is due to be saved.
class Interruptions {
 public:
  Interruptions(const StopConditions& conditions, const SavePlan& plan, const StopFlag* stop)
      : conditions_(conditions), plan_(plan), stop_(stop) {}

  // For any thread. `hasPicture`: each pixel has a sample.
  bool Stopped() const { return stop_ && stop_->raised(); }
  bool TimeIsOver(bool hasPicture) const {
    return hasPicture && timer_.Seconds() >= conditions_.seconds;
  }
  bool SaveIsDue() const { return plan_.save && timer_.Seconds() >= nextSave_; }
  bool Any(bool hasPicture) const { return Stopped() || TimeIsOver(hasPicture) || SaveIsDue(); }

  // Between passes or while workers pause.
  void SaveIfDue(const Film& film);
  // Why a render ended that had this plan.
  End Ended(const PassPlan& plan, const Film& film) const;

 private:
  const StopConditions& conditions_;
  const SavePlan& plan_;
  const StopFlag* stop_;
  Timer timer_;
  double nextSave_ = plan_.interval;
};

}  // namespace snell::render
