// SPDX-License-Identifier: Apache-2.0
#include "render/schedule.h"

#include <algorithm>
#include <cmath>

#include "render/noise.h"

namespace snell::render {

namespace {

constexpr int NoiseRadius = 2;
constexpr double SaveShare = 0.05;  // of the time, at most

PassPlan CountRemaining(const Film& film, std::uint32_t most) {
  PassPlan plan;
  for (const Film::Pixel& pixel : film.pixels()) {
    plan.samples += pixel.goal - pixel.count;
    plan.remaining += std::max(most, pixel.count) - pixel.count;
    plan.hasPicture = plan.hasPicture && pixel.count > 0;
  }
  return plan;
}

// Samples that pixels need until their errors fall to the target like 1/√n.
std::uint64_t RemainingForNoise(const Film& film, const std::vector<float>& errors, double noise) {
  double remaining = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const Film::Pixel& pixel = film.pixels()[i];
    const double factor = double(errors[i]) / noise;
    const double needed = std::max(double(LeastSamplesForNoise), pixel.count * factor * factor);
    remaining += std::max(double(pixel.goal - pixel.count), needed - pixel.count);
  }
  return std::uint64_t(std::min(remaining, 1e18));
}

}  // namespace

std::uint32_t PassSize(std::uint32_t count) { return std::clamp(count, 1u, 64u); }

PassPlan PlanPass(Film& film, std::uint32_t lastSample, const StopConditions& stop) {
  const std::uint32_t most = lastSample - std::min(film.firstSample(), lastSample);

  // Finish the pass that a saved film was in
  std::uint64_t unfinished = 0;
  for (Film::Pixel& pixel : film.pixels()) {
    pixel.goal = std::max(std::min(pixel.goal, most), pixel.count);
    unfinished += pixel.goal - pixel.count;
  }
  if (unfinished > 0) return CountRemaining(film, most);

  std::vector<float> errors;
  if (stop.noise > 0)
    errors = LargestNearby(DisplayErrors(film, stop.noiseScale), film.rect().Width(), NoiseRadius);
  std::uint64_t resting = 0;
  for (std::size_t i = 0; i < film.pixels().size(); ++i) {
    Film::Pixel& pixel = film.pixels()[i];
    const bool rests =
        !errors.empty() && pixel.count >= LeastSamplesForNoise && errors[i] <= stop.noise;
    resting += rests ? 1 : 0;
    if (pixel.count < most && !rests)
      pixel.goal = std::min(most - pixel.count, PassSize(pixel.count)) + pixel.count;
  }
  PassPlan plan = CountRemaining(film, most);
  plan.resting = resting;
  if (stop.noise > 0) {
    const std::uint64_t guess = RemainingForNoise(film, errors, double(stop.noise));
    plan.remaining = std::max(plan.samples, std::min(plan.remaining, guess));
  }
  return plan;
}

void Interruptions::SaveIfDue(const Film& film) {
  if (!SaveIsDue()) return;
  const double before = timer_.Seconds();
  plan_.save(film);
  const double after = timer_.Seconds();
  nextSave_ = after + std::max(plan_.interval, (after - before) / SaveShare);
}

End Interruptions::Ended(const PassPlan& plan, const Film& film) const {
  if (plan.samples > 0) return Stopped() ? End::Stopped : End::Time;
  return plan.resting == film.pixels().size() ? End::Noise : End::Samples;
}

}  // namespace snell::render
