// SPDX-License-Identifier: Apache-2.0
#include "scene/sky/atmosphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/math.h"
#include "util/threads.h"

namespace snell::scene {

namespace {

constexpr double Pi = std::numbers::pi;
constexpr double Ground = 6360e3;  // radii
constexpr double Space = 6460e3;
constexpr double EyeHeight = 2;
constexpr double SunRadius = 0.00465;  // as an angle
constexpr double AirScale = 8000;      // heights over which densities fall to 1/e
constexpr double HazeScale = 1200;
constexpr float HazeAlbedo = 0.9f;
constexpr double HazeForward = 0.8;  // g of its phase function

constexpr int AngleCount = 256;  // of the table of amounts
constexpr int HeightCount = 48;
constexpr int SunCount = 48;  // of the table of multiple scattering
constexpr int LayerCount = 12;
constexpr int Steps = 40;  // along a ray

double Sqr(double x) { return x * x; }
double SafeSqrt(double x) { return std::sqrt(std::max(x, 0.0)); }

// Along a ray from a radius: to a sphere around the centre that is met from within, and to the ground or -1.
double ToSphere(double radius, double cosine, double sphere) {
  return -radius * cosine + SafeSqrt(Sqr(radius * cosine) + Sqr(sphere) - Sqr(radius));
}
double ToGround(double radius, double cosine) {
  const double discriminant = Sqr(radius * cosine) + Sqr(Ground) - Sqr(radius);
  if (cosine >= 0 || discriminant < 0) return -1;
  return std::max(-radius * cosine - std::sqrt(discriminant), 0.0);
}

double RadiusAt(double radius, double cosine, double distance) {
  return std::clamp(std::sqrt(Sqr(radius) + Sqr(distance) + 2 * radius * cosine * distance), Ground,
                    Space);
}

// The zenith cosine of the horizon.
double HorizonCosine(double radius) { return -SafeSqrt(1 - Sqr(Ground / radius)); }

// Per steradian, integrals over the sphere are 1. Haze: Cornette and Shanks 1992.
double AirPhase(double cosine) { return 3 / (16 * Pi) * (1 + Sqr(cosine)); }
double HazePhase(double cosine) {
  const double g = HazeForward;
  return 3 / (8 * Pi) * (1 - g * g) * (1 + Sqr(cosine)) /
         ((2 + g * g) * std::pow(1 + g * g - 2 * g * cosine, 1.5));
}

// Fractions of a ray, finer near its start.
double StepEnd(int step) { return Sqr(double(step) / Steps); }

struct Cell {
  std::size_t index;
  double share;  // of the next index
};
Cell CellOf(double x, int count) {
  const double place = std::clamp(x, 0.0, 1.0) * (count - 1);
  const double index = std::min(std::floor(place), double(count - 2));
  return {std::size_t(index), place - index};
}

}  // namespace

Atmosphere::Atmosphere(double turbidity, const Bands& groundAlbedo) : groundAlbedo_(groundAlbedo) {
  // Cross sections of ozone in 10⁻²⁵ m² at 233 K (Gorshelev et al. 2014), means over the bands; 300 Dobson units
  constexpr Bands Ozone = {0.0047f, 0.0215f, 0.0699f, 0.195f, 0.430f, 0.838f, 1.541f, 2.447f,
                           3.296f,  4.469f,  4.550f,  4.662f, 3.478f, 2.450f, 1.663f, 1.076f};
  constexpr double OzonePeak = 300 * 2.687e20 / 15e3;  // molecules per m³
  // Ångström's coefficient of haze of a turbidity: Preetham, Shirley and Smits 1999, appendix 2
  const double haze = std::max(0.04608 * turbidity - 0.04586, 0.0);
  for (int band = 0; band < BandCount; ++band) {
    const double micrometres = BandNanometres(band) / 1000;
    const std::size_t i = std::size_t(band);
    air_[i] = float(1.24062e-6 * std::pow(micrometres, -4));
    haze_[i] = float(haze * std::pow(micrometres, -1.3) / HazeScale);
    ozone_[i] = float(double(Ozone[i]) * 1e-25 * OzonePeak);
  }
  FillAmounts();
  FillMultiple();
}

Atmosphere::Amounts Atmosphere::DensitiesAt(double height) {
  return {std::exp(-height / AirScale), std::exp(-height / HazeScale),
          std::max(0.0, 1 - std::abs(height - 25e3) / 15e3)};
}

// The table's axes are those of Bruneton's transmittance: the distance to space between its extremes, and that to the
// horizon.
void Atmosphere::FillAmounts() {
  const double horizon = SafeSqrt(Sqr(Space) - Sqr(Ground));
  amounts_.resize(std::size_t(AngleCount) * HeightCount);
  for (int row = 0; row < HeightCount; ++row) {
    const double rho = horizon * row / (HeightCount - 1);
    const double radius = std::sqrt(Sqr(rho) + Sqr(Ground));
    for (int column = 0; column < AngleCount; ++column) {
      const double least = Space - radius, most = rho + horizon;
      const double distance = least + (most - least) * column / (AngleCount - 1);
      const double cosine =
          distance == 0
              ? 1
              : std::clamp((Sqr(horizon) - Sqr(rho) - Sqr(distance)) / (2 * radius * distance),
                           -1.0, 1.0);
      constexpr int Fine = 128;
      Amounts sum;
      for (int i = 0; i < Fine; ++i) {
        const double at = Sqr((i + 0.5) / Fine) * distance;
        const double length = distance * (Sqr((i + 1.0) / Fine) - Sqr(double(i) / Fine));
        const Amounts here = DensitiesAt(RadiusAt(radius, cosine, at) - Ground);
        sum.air += here.air * length;
        sum.haze += here.haze * length;
        sum.ozone += here.ozone * length;
      }
      amounts_[std::size_t(row) * AngleCount + std::size_t(column)] = sum;
    }
  }
}

Atmosphere::Amounts Atmosphere::AmountsToSpace(double radius, double zenithCosine) const {
  const double horizon = SafeSqrt(Sqr(Space) - Sqr(Ground));
  const double rho = SafeSqrt(Sqr(radius) - Sqr(Ground));
  const double least = Space - radius, most = rho + horizon;
  const double distance = ToSphere(radius, zenithCosine, Space);
  const Cell row = CellOf(rho / horizon, HeightCount);
  const Cell column = CellOf((distance - least) / (most - least), AngleCount);
  Amounts sum;
  for (std::size_t i = 0; i < 4; ++i) {
    const double weight =
        (i % 2 == 1 ? column.share : 1 - column.share) * (i / 2 == 1 ? row.share : 1 - row.share);
    const Amounts& entry =
        amounts_[(row.index + i / 2) * std::size_t(AngleCount) + column.index + i % 2];
    sum.air += entry.air * weight;
    sum.haze += entry.haze * weight;
    sum.ozone += entry.ozone * weight;
  }
  return sum;
}

Bands Atmosphere::Transmit(const Amounts& amounts) const {
  Bands share;
  const float air = float(amounts.air), haze = float(amounts.haze), ozone = float(amounts.ozone);
  for (std::size_t i = 0; i < BandCount; ++i)
    share[i] = kernel::Exp(-(air_[i] * air + haze_[i] * haze + ozone_[i] * ozone));
  return share;
}

Bands Atmosphere::Transmittance(double height, double zenithCosine) const {
  const double radius = Ground + height;
  if (zenithCosine < HorizonCosine(radius)) return {};
  return Transmit(AmountsToSpace(radius, zenithCosine));
}

// The sun's share of light at a point, also where only a part of its disc is above the horizon.
Bands Atmosphere::SunAt(double radius, double sunZenithCosine) const {
  const double horizon = HorizonCosine(radius);
  const double blur = SunRadius * (Ground / radius);
  if (sunZenithCosine <= horizon - blur) return {};
  Bands share = Transmit(AmountsToSpace(radius, std::max(sunZenithCosine, horizon)));
  if (sunZenithCosine < horizon + blur) {
    const float visible =
        kernel::SmoothStep(float(horizon - blur), float(horizon + blur), float(sunZenithCosine));
    for (float& band : share) band *= visible;
  }
  return share;
}

Atmosphere::Seen Atmosphere::See(const View& view) const {
  const double radius = Ground + EyeHeight;
  const double toGround = ToGround(radius, view.zenithCosine);
  const double length = toGround >= 0 ? toGround : ToSphere(radius, view.zenithCosine, Space);
  const float airPhase = float(AirPhase(view.cosineToSun));
  const float hazePhase = float(HazePhase(view.cosineToSun)) * HazeAlbedo;
  Seen seen;
  seen.transmitted.fill(1);
  for (int step = 0; step < Steps; ++step) {
    const double begin = StepEnd(step) * length, end = StepEnd(step + 1) * length;
    const double at = (begin + end) / 2;
    const double here = RadiusAt(radius, view.zenithCosine, at);
    const double sun =
        std::clamp((radius * view.sunZenithCosine + at * view.cosineToSun) / here, -1.0, 1.0);
    const Amounts density = DensitiesAt(here - Ground);
    const Bands direct = SunAt(here, sun);
    const Bands multiple = MultipleAt(here, sun);
    const float air = float(density.air), haze = float(density.haze), ozone = float(density.ozone);
    for (std::size_t i = 0; i < BandCount; ++i) {
      // What is scattered along the step, weakened on the step itself
      const float byAir = air_[i] * air, byHaze = haze_[i] * haze;
      const float extinction = byAir + byHaze + ozone_[i] * ozone;
      const float kept = kernel::Exp(-extinction * float(end - begin));
      const float source = (byAir * airPhase + byHaze * hazePhase) * direct[i] +
                           (byAir + byHaze * HazeAlbedo) * multiple[i];
      seen.scattered[i] += seen.transmitted[i] * source * (1 - kept) / std::max(extinction, 1e-12f);
      seen.transmitted[i] *= kept;
    }
  }
  return seen;
}

// --- Multiple scattering ------------------------------------------------------------------------------------

// Rows are heights, closer near the ground; columns the sun's elevation, closer near the horizon.
static double LayerRadius(int layer) {
  return Ground + (Space - Ground) * Sqr(double(layer) / (LayerCount - 1));
}
static double SunCosine(int column) {
  const double x = 2.0 * column / (SunCount - 1) - 1;
  return x * std::abs(x);
}

void Atmosphere::FillMultiple() {
  multiple_.resize(std::size_t(SunCount) * LayerCount);
  ParallelInOrder(multiple_.size(), [&](std::uint64_t i, int) {
    multiple_[i] = MultipleFor(LayerRadius(int(i / SunCount)), SunCosine(int(i % SunCount)));
  });
}

Bands Atmosphere::MultipleAt(double radius, double sunZenithCosine) const {
  const double angle = std::copysign(std::sqrt(std::abs(sunZenithCosine)), sunZenithCosine);
  const Cell row = CellOf(SafeSqrt((radius - Ground) / (Space - Ground)), LayerCount);
  const Cell column = CellOf((angle + 1) / 2, SunCount);
  Bands sum{};
  for (std::size_t k = 0; k < 4; ++k) {
    const float weight = float((k % 2 == 1 ? column.share : 1 - column.share) *
                               (k / 2 == 1 ? row.share : 1 - row.share));
    const Bands& entry =
        multiple_[(row.index + k / 2) * std::size_t(SunCount) + column.index + k % 2];
    for (std::size_t i = 0; i < BandCount; ++i) sum[i] += entry[i] * weight;
  }
  return sum;
}

// Light of the second order of scattering and what a single scattering keeps, both as means over directions, as if
// light were scattered to all sides alike and the surroundings were everywhere as here; all orders are a geometric sum.
Bands Atmosphere::MultipleFor(double radius, double sunZenithCosine) const {
  constexpr int Rings = 8, Spokes = 8, RaySteps = 20;
  Bands second{}, kept{};
  const double sunSine = SafeSqrt(1 - Sqr(sunZenithCosine));
  for (int direction = 0; direction < Rings * Spokes; ++direction) {
    const double cosine = 2 * (direction / Spokes + 0.5) / Rings - 1;
    const double phi = 2 * Pi * (direction % Spokes + 0.5) / Spokes;
    const double toSun =
        cosine * sunZenithCosine + SafeSqrt(1 - Sqr(cosine)) * sunSine * std::cos(phi);
    const double toGround = ToGround(radius, cosine);
    const double length = toGround >= 0 ? toGround : ToSphere(radius, cosine, Space);
    Bands transmitted;
    transmitted.fill(1);
    for (int step = 0; step < RaySteps; ++step) {
      const double begin = length * Sqr(double(step) / RaySteps);
      const double end = length * Sqr((step + 1.0) / RaySteps);
      const double at = (begin + end) / 2;
      const double here = RadiusAt(radius, cosine, at);
      const double sun = std::clamp((radius * sunZenithCosine + at * toSun) / here, -1.0, 1.0);
      const Amounts density = DensitiesAt(here - Ground);
      const Bands direct = SunAt(here, sun);
      for (std::size_t i = 0; i < BandCount; ++i) {
        const float scattering =
            air_[i] * float(density.air) + haze_[i] * float(density.haze) * HazeAlbedo;
        const float extinction = air_[i] * float(density.air) + haze_[i] * float(density.haze) +
                                 ozone_[i] * float(density.ozone);
        const float through = kernel::Exp(-extinction * float(end - begin));
        const float along =
            transmitted[i] * scattering * (1 - through) / std::max(extinction, 1e-12f);
        second[i] += along * direct[i] * float(1 / (4 * Pi));
        kept[i] += along;
        transmitted[i] *= through;
      }
    }
    if (toGround < 0) continue;
    // The ground sends up what the sun gives it there
    const double sun =
        std::clamp((radius * sunZenithCosine + toGround * toSun) / Ground, -1.0, 1.0);
    const Bands direct = SunAt(Ground, sun);
    for (std::size_t i = 0; i < BandCount; ++i)
      second[i] += transmitted[i] * direct[i] * groundAlbedo_[i] * float(std::max(sun, 0.0) / Pi);
  }
  constexpr float Directions = Rings * Spokes;
  for (std::size_t i = 0; i < BandCount; ++i)
    second[i] = second[i] / Directions / (1 - std::min(kept[i] / Directions, 0.99f));
  return second;
}

}  // namespace snell::scene
