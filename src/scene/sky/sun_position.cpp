// SPDX-License-Identifier: Apache-2.0
#include "scene/sky/sun_position.h"

#include <chrono>
#include <cmath>
#include <numbers>

namespace snell::scene {

SunPosition SunAt(double days, double latitude, double longitude) {
  constexpr double Pi = std::numbers::pi;
  constexpr double Degree = Pi / 180;

  // On the ecliptic
  const double meanLongitude = 280.460 + 0.9856474 * days;
  const double anomaly = (357.528 + 0.9856003 * days) * Degree;
  const double ecliptic =
      (meanLongitude + 1.915 * std::sin(anomaly) + 0.020 * std::sin(2 * anomaly)) * Degree;
  const double obliquity = (23.439 - 4e-7 * days) * Degree;

  // On the celestial sphere, and as seen from the place, whose sidereal time tells how far the earth has turned
  const double ascension = std::atan2(std::cos(obliquity) * std::sin(ecliptic), std::cos(ecliptic));
  const double declination = std::asin(std::sin(obliquity) * std::sin(ecliptic));
  const double sidereal = (280.46062 + 360.98564737 * days) * Degree + longitude;
  const double hour = std::remainder(sidereal - ascension, 2 * Pi);
  const double elevation = std::asin(std::sin(declination) * std::sin(latitude) +
                                     std::cos(declination) * std::cos(latitude) * std::cos(hour));
  const double azimuth =
      std::atan2(-std::cos(declination) * std::sin(hour),
                 std::sin(declination) * std::cos(latitude) -
                     std::cos(declination) * std::sin(latitude) * std::cos(hour));
  return {elevation, azimuth < 0 ? azimuth + 2 * Pi : azimuth};
}

// Takes `count` digits from the front of the text.
static std::optional<int> Digits(std::string_view& text, std::size_t count) {
  if (text.size() < count) return std::nullopt;
  int number = 0;
  for (const char c : text.substr(0, count)) {
    if (c < '0' || c > '9') return std::nullopt;
    number = number * 10 + (c - '0');
  }
  text.remove_prefix(count);
  return number;
}

static bool Take(std::string_view& text, char c) {
  if (text.empty() || text.front() != c) return false;
  text.remove_prefix(1);
  return true;
}

// Hours and minutes, as days.
static std::optional<double> Clock(std::string_view& text) {
  const auto hours = Digits(text, 2);
  if (!hours || *hours > 23 || !Take(text, ':')) return std::nullopt;
  const auto minutes = Digits(text, 2);
  if (!minutes || *minutes > 59) return std::nullopt;
  return (*hours + *minutes / 60.0) / 24;
}

std::optional<double> DaysOf(std::string_view time) {
  const auto year = Digits(time, 4);
  if (!year || !Take(time, '-')) return std::nullopt;
  const auto month = Digits(time, 2);
  if (!month || !Take(time, '-')) return std::nullopt;
  const auto day = Digits(time, 2);
  if (!day || !(Take(time, 'T') || Take(time, ' '))) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(*year),
                                         std::chrono::month(unsigned(*month)),
                                         std::chrono::day(unsigned(*day))};
  if (!date.ok()) return std::nullopt;
  auto clock = Clock(time);
  if (!clock) return std::nullopt;
  if (Take(time, ':')) {
    const auto seconds = Digits(time, 2);
    if (!seconds || *seconds > 60) return std::nullopt;
    *clock += *seconds / 86400.0;
  }

  // What the clock is ahead of universal time
  double ahead = 0;
  if (!Take(time, 'Z')) {
    const bool isWest = Take(time, '-');
    if (!isWest && !Take(time, '+')) return std::nullopt;
    const auto offset = Clock(time);
    if (!offset) return std::nullopt;
    ahead = isWest ? -*offset : *offset;
  }
  if (!time.empty()) return std::nullopt;
  using std::chrono::sys_days;
  const auto since = sys_days(date) - sys_days(std::chrono::year(2000) / 1 / 1);
  return double(since.count()) - 0.5 + *clock - ahead;
}

}  // namespace snell::scene
