// SPDX-License-Identifier: Apache-2.0
#include "io/ies/planes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace snell::io {

namespace {

constexpr double Pi = 3.14159265358979323846;
constexpr double Degree = Pi / 180;

// Where x lies between angles: the place of the one before, and the share of the next. It must lie within.
std::pair<std::size_t, double> Between(const std::vector<double>& angles, double x) {
  if (angles.size() == 1) return {0, 0};
  const auto above = std::upper_bound(angles.begin() + 1, angles.end() - 1, x);
  const std::size_t i = std::size_t(above - angles.begin()) - 1;
  return {i, std::clamp((x - angles[i]) / (angles[i + 1] - angles[i]), 0.0, 1.0)};
}

bool Within(const std::vector<double>& angles, double x) {
  return x >= angles.front() && x <= angles.back();
}

double ValueAt(const Measurement& m, double vertical, double horizontal) {
  const auto [h, s] = Between(m.horizontals, horizontal);
  const auto [v, t] = Between(m.verticals, vertical);
  const double* const plane = &m.values[h * m.verticals.size() + v];
  const double here = std::lerp(plane[0], plane[1], t);
  if (s == 0) return here;
  const double* const next = plane + m.verticals.size();
  return std::lerp(here, std::lerp(next[0], next[1], t), s);
}

// --- Type C -------------------------------------------------------------------------------------------------

// Which planes are measured.
enum class Planes { One, Quarter, Half, HalfFrom90, All, AllButLast, None };

Planes PlanesOf(const std::vector<double>& angles) {
  const double first = angles.front(), last = angles.back();
  if (angles.size() == 1) return Planes::One;
  if (first == 90 && last == 270) return Planes::HalfFrom90;
  if (first != 0) return Planes::None;
  if (last == 90) return Planes::Quarter;
  if (last == 180) return Planes::Half;
  if (last == 360) return Planes::All;
  return last > 270 && last < 360 ? Planes::AllButLast : Planes::None;
}

// The measured plane that is like this one, in [0, 360].
double Folded(Planes planes, double angle) {
  switch (planes) {
    case Planes::Quarter: {
      const double half = std::min(angle, 360 - angle);
      return std::min(half, 180 - half);
    }
    case Planes::Half: return std::min(angle, 360 - angle);
    case Planes::HalfFrom90: return angle < 90 ? 180 - angle : angle > 270 ? 540 - angle : angle;
    default: return angle;
  }
}

// All planes that are like measured ones, with those at 0 and 360.
std::set<double> AllPlanes(Planes planes, const std::vector<double>& measured) {
  std::set<double> all = {0, 360};
  for (const double angle : measured) {
    for (const double image : {angle, 360 - angle, 180 - angle, 180 + angle, 540 - angle}) {
      if (image >= 0 && image <= 360 && Folded(planes, image) == angle) all.insert(image);
    }
  }
  return all;
}

// --- Types A and B ------------------------------------------------------------------------------------------

// Symmetric halves begin at 0.
double Unsigned(const std::vector<double>& angles, double angle) {
  return angles.front() == 0 ? std::abs(angle) : angle;
}

// The directions before the lamp, at even angles. `angles` says the vertical and the horizontal one of a direction: to
// the right, up and ahead.
template <class Angles>
scene::LightProfile ProfileBy(const Measurement& m, const Angles& angles) {
  constexpr int Verticals = 181, Horizontals = 181;
  scene::LightProfile profile;
  for (int v = 0; v < Verticals; ++v)
    profile.verticals.push_back(float(0.5 * Pi * v / (Verticals - 1)));
  for (int h = 0; h < Horizontals; ++h) {
    const double phi = 2 * Pi * h / (Horizontals - 1);
    profile.horizontals.push_back(float(phi));
    for (int v = 0; v < Verticals; ++v) {
      const double theta = 0.5 * Pi * v / (Verticals - 1);
      auto [vertical, horizontal] =
          angles(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
      vertical = Unsigned(m.verticals, vertical / Degree);
      horizontal = Unsigned(m.horizontals, horizontal / Degree);
      const bool isMeasured = Within(m.verticals, vertical) &&
                              (m.horizontals.size() == 1 || Within(m.horizontals, horizontal));
      profile.intensities.push_back(isMeasured ? float(ValueAt(m, vertical, horizontal)) : 0.0f);
    }
  }
  return profile;
}

double Arcsine(double x) { return std::asin(std::clamp(x, -1.0, 1.0)); }

}  // namespace

std::string FaultOfC(const Measurement& m) {
  if (m.verticals.front() < 0 || m.verticals.back() > 180)
    return "vertical angles lie between 0 and 180 degrees";
  if (PlanesOf(m.horizontals) == Planes::None)
    return fmt::format(
        "horizontal angles from {:.6g} to {:.6g} degrees; there may be one, or from 0 to 90, 180 "
        "or 360, or from 90 to 270",
        m.horizontals.front(), m.horizontals.back());
  return "";
}

std::string FaultOfAOrB(const Measurement& m) {
  const auto isOutside = [](double angle) { return std::abs(angle) > 90; };
  if (std::ranges::any_of(m.verticals, isOutside) || std::ranges::any_of(m.horizontals, isOutside))
    return "angles of photometry of types A and B lie between -90 and 90 degrees";
  return "";
}

scene::LightProfile ProfileOfC(const Measurement& measured) {
  Measurement m = measured;
  const Planes planes = PlanesOf(m.horizontals);
  if (planes == Planes::AllButLast) {
    m.horizontals.push_back(360);
    const std::vector<double> first(m.values.begin(),
                                    m.values.begin() + std::ptrdiff_t(m.verticals.size()));
    m.values.insert(m.values.end(), first.begin(), first.end());
  }
  scene::LightProfile profile;
  for (const double angle : m.verticals) profile.verticals.push_back(float(angle * Degree));
  std::set<double> all = {0};
  if (planes != Planes::One) all = AllPlanes(planes, m.horizontals);
  for (const double angle : all) {
    profile.horizontals.push_back(float(angle * Degree));
    for (const double vertical : m.verticals)
      profile.intensities.push_back(
          float(ValueAt(m, vertical, planes == Planes::One ? 0 : Folded(planes, angle))));
  }
  return profile;
}

// About an axis to the right; then along it.
scene::LightProfile ProfileOfB(const Measurement& m) {
  return ProfileBy(m, [](double right, double up, double ahead) {
    return std::pair(std::atan2(up, ahead), Arcsine(right));
  });
}

// About an axis upwards; then along it.
scene::LightProfile ProfileOfA(const Measurement& m) {
  return ProfileBy(m, [](double right, double up, double ahead) {
    return std::pair(Arcsine(up), std::atan2(right, ahead));
  });
}

}  // namespace snell::io
