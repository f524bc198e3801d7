// SPDX-License-Identifier: Apache-2.0
#include "explain/why.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "kernel/values.h"

namespace snell::explain {

namespace {

constexpr std::size_t Listed = 6;  // causes that are told

// How often something happened, and in which sample first.
struct Count {
  std::uint64_t times = 0;
  std::uint32_t firstSample = 0;

  void Add(std::uint32_t sample) {
    if (times++ == 0) firstSample = sample;
  }
};
using Counts = std::map<std::string, Count>;

// What one way of light to the pixel has brought.
struct Route {
  double sum = 0;
  double squares = 0;
  double largest = 0;
  std::uint32_t largestSample = 0;
  std::uint64_t times = 0;
};

double Brightness(const kernel::Spectrum& L) {
  return (double(L.x) + double(L.y) + double(L.z)) / 3;
}

bool IsFinite(const kernel::Spectrum& L) {
  return std::isfinite(L.x) && std::isfinite(L.y) && std::isfinite(L.z);
}

// "'floor' -> 'ball' -> the light 'lamp'": the surfaces between the camera and a term's source.
std::string RouteOf(const Explanation& explanation, const Contribution& term) {
  std::vector<std::string> stations;
  for (int i = term.ray; i >= 0; i = explanation.rays[std::size_t(i)].parent) {
    const Segment& ray = explanation.rays[std::size_t(i)];
    if (ray.surface)
      stations.push_back(fmt::format("'{}'", ray.surface->object));
    else if (ray.scattered)
      stations.emplace_back("a medium");
  }
  std::ranges::reverse(stations);
  stations.push_back(term.source.substr(0, term.source.find(" (weight")));
  return fmt::format("{}", fmt::join(stations, " -> "));
}

class Answer {
 public:
  Answer(const Explainer& explainer, int x, int y, std::uint32_t samples) : samples_(samples) {
    for (std::uint32_t sample = 0; sample < samples; ++sample)
      Look(explainer.Explain(x, y, sample), sample);
    Line(fmt::format("pixel {},{}: {} samples, mean {:.5g}, standard error {:.3g}, {} black", x, y,
                     samples, sum_ / samples, StandardError(), black_));
    if (nonFinite_.times > 0)
      Line(fmt::format("{} samples are not finite and count as black; the first is sample {}: {}",
                       nonFinite_.times, nonFinite_.firstSample, firstNonFinite_));
  }

  void WhyBlack() {
    Line("what the camera sees first:");
    List(seen_, samples_);
    Line("what became of the lights that were asked:");
    List(lights_, asked_);
    Line("how rays ended, and what else was noticed:");
    List(notes_, samples_);
    if (asked_ == 0 && black_ == samples_)
      Line("no light was ever asked: either nothing was met that scatters light, or there is none");
  }

  // By mean or by spread.
  void WhichLight(bool bySpread) {
    Line(bySpread ? "the ways of light that the noise comes from:"
                  : "the ways of light that the brightness comes from:");
    std::vector<std::pair<std::string, Route>> routes(routes_.begin(), routes_.end());
    const auto spread = [&](const Route& r) { return r.squares - r.sum * r.sum / samples_; };
    const auto size = [&](const Route& r) { return bySpread ? spread(r) : r.sum; };
    std::ranges::sort(
        routes, [&](const auto& a, const auto& b) { return size(a.second) > size(b.second); });
    double all = 0;
    for (const auto& [name, route] : routes) all += std::max(size(route), 0.0);
    for (std::size_t i = 0; i < std::min(Listed, routes.size()); ++i) {
      const auto& [name, route] = routes[i];
      Line(fmt::format("  {:5.1f} %  {}: in {} of {} samples, the largest {:.4g} in sample {}",
                       all > 0 ? 100 * std::max(size(route), 0.0) / all : 0.0, name, route.times,
                       samples_, route.largest, route.largestSample));
    }
    if (sum_ > 0)
      Line(
          fmt::format("sample {} alone brings {:.1f} % of the pixel's light; --sample {} tells how",
                      brightest_, 100 * brightestValue_ / sum_, brightest_));
  }

  std::string text;

 private:
  void Line(const std::string& line) { text += line + '\n'; }

  double StandardError() const {
    if (samples_ < 2) return 0;
    const double mean = sum_ / samples_;
    return std::sqrt(std::max(squares_ / samples_ - mean * mean, 0.0) / (samples_ - 1));
  }

  void Look(const Explanation& explanation, std::uint32_t sample) {
    if (!IsFinite(explanation.radiance)) {
      nonFinite_.Add(sample);
      if (nonFinite_.times == 1) firstNonFinite_ = WhereNotFinite(explanation);
      return;
    }
    const double L = Brightness(explanation.radiance);
    sum_ += L;
    squares_ += L * L;
    if (L == 0) ++black_;
    if (L > brightestValue_) {
      brightestValue_ = L;
      brightest_ = sample;
    }

    // Add up the ways of light of this sample, each once
    std::map<std::string, double> brought;
    for (const Contribution& term : explanation.terms)
      brought[RouteOf(explanation, term)] += Brightness(term.L);
    for (const auto& [name, value] : brought) {
      Route& route = routes_[name];
      route.sum += value;
      route.squares += value * value;
      ++route.times;
      if (value > route.largest) {
        route.largest = value;
        route.largestSample = sample;
      }
    }

    // Count what happened
    const Segment& first = explanation.rays.front();
    seen_[first.surface
              ? fmt::format("'{}' of material '{}', its {}", first.surface->object,
                            first.surface->material, first.surface->fromOutside ? "front" : "back")
          : first.scattered ? "a medium"
                            : "nothing: the background"]
        .Add(sample);
    for (const Segment& ray : explanation.rays) {
      for (const LightTry& light : ray.lights) {
        const std::string by = light.blocker.empty() ? "" : fmt::format(" by '{}'", light.blocker);
        lights_[fmt::format("{}: {}{}", light.light, light.outcome, by)].Add(sample);
        ++asked_;
      }
      for (const std::string& note : ray.notes) notes_[note].Add(sample);
    }
  }

  static std::string WhereNotFinite(const Explanation& explanation) {
    for (std::size_t i = 0; i < explanation.rays.size(); ++i) {
      const Segment& ray = explanation.rays[i];
      const std::string at =
          ray.surface ? fmt::format(", which meets '{}'", ray.surface->object) : "";
      if (!IsFinite(ray.d) || !IsFinite(ray.o))
        return fmt::format("ray {} has no finite direction or origin{}", i + 1, at);
      if (!IsFinite(ray.weight)) return fmt::format("the weight of ray {}{}", i + 1, at);
      if (ray.way && !IsFinite(ray.way->weight))
        return fmt::format("the scattering at the end of ray {}{}", i + 1, at);
      for (const LightTry& light : ray.lights) {
        if (!IsFinite(light.f) || !IsFinite(light.irradiance))
          return fmt::format("{} at the end of ray {}{}", light.light, i + 1, at);
      }
    }
    for (const Contribution& term : explanation.terms) {
      if (!IsFinite(term.L))
        return fmt::format("{} at the end of ray {}", term.source, term.ray + 1);
    }
    return "the sum of finite terms";
  }

  void List(const Counts& counts, std::uint64_t all) {
    std::vector<std::pair<std::string, Count>> sorted(counts.begin(), counts.end());
    std::ranges::stable_sort(
        sorted, [](const auto& a, const auto& b) { return a.second.times > b.second.times; });
    if (sorted.empty()) Line("  nothing");
    for (std::size_t i = 0; i < std::min(Listed, sorted.size()); ++i)
      Line(fmt::format(
          "  {:5.1f} %  {} (first in sample {})",
          100 * double(sorted[i].second.times) / double(std::max<std::uint64_t>(all, 1)),
          sorted[i].first, sorted[i].second.firstSample));
  }

  std::uint32_t samples_;
  double sum_ = 0, squares_ = 0;
  std::uint64_t black_ = 0;
  double brightestValue_ = 0;
  std::uint32_t brightest_ = 0;
  Count nonFinite_;
  std::string firstNonFinite_;
  std::map<std::string, Route> routes_;
  Counts seen_, lights_, notes_;
  std::uint64_t asked_ = 0;
};

}  // namespace

std::string Why(const Explainer& explainer, Question question, int x, int y,
                std::uint32_t samples) {
  Answer answer(explainer, x, y, samples);
  if (question == Question::Black)
    answer.WhyBlack();
  else
    answer.WhichLight(question == Question::Noisy);
  return answer.text;
}

}  // namespace snell::explain
