// SPDX-License-Identifier: Apache-2.0
#include "scene/sky/sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/sky/atmosphere.h"
#include "util/threads.h"

namespace snell::scene {

namespace {

constexpr double Pi = std::numbers::pi;
constexpr int Width = 512;
constexpr int Height = 256;
constexpr float SunDiameter = 0.0093f;  // as an angle

// A colour of the ground as albedos of the bands: blue to 500 nm, red from 600 nm.
Bands BandsOf(const Spectrum& color) {
  Bands bands;
  for (int band = 0; band < BandCount; ++band) {
    const double nanometres = BandNanometres(band);
    bands[std::size_t(band)] = nanometres < 500 ? color.z : nanometres < 600 ? color.y : color.x;
  }
  return bands;
}

// How much of the sun's disc is above the horizon.
double VisibleShare(double elevation) {
  const double radius = double(SunDiameter) / 2;
  const double x = std::clamp(elevation / radius, -1.0, 1.0);
  return 0.5 + (std::asin(x) + x * std::sqrt(1 - x * x)) / Pi;
}

// Integrates the sky for the rows of the map.
class SkyPainter {
 public:
  explicit SkyPainter(const SkyModel& sky)
      : sky_(sky), albedo_(BandsOf(sky.ground)), atmosphere_(sky.turbidity, albedo_) {}

  SkyLight Paint() {
    SkyLight light;
    Image& map = light.map;
    map.name = "sky";
    map.width = Width;
    map.height = Height;
    map.floats.assign(std::size_t(Width) * Height * 4, 1);

    // The sky first, for it lights the ground
    std::vector<Bands> irradiance(Height / 2);
    ParallelInOrder(Height / 2,
                    [&](std::uint64_t row, int) { irradiance[row] = PaintRow(int(row), map); });
    const double sine = std::sin(sky_.elevation);
    const double share = VisibleShare(sky_.elevation);
    const Bands sun = atmosphere_.Transmittance(0, std::max(sine, 0.0));
    for (std::size_t i = 0; i < BandCount; ++i) {
      for (const Bands& row : irradiance) ground_[i] += row[i];
      const double direct = double(sun[i]) * share * double(SolarIrradiance[i]);
      ground_[i] = float((double(ground_[i]) + direct * std::max(sine, 0.0)) / Pi) * albedo_[i];
      direct_[i] = float(direct);
    }
    ParallelInOrder(Height / 2,
                    [&](std::uint64_t row, int) { PaintRow(int(row) + Height / 2, map); });
    light.sunIrradiance = RgbOf(direct_);
    return light;
  }

 private:
  // Returns what the row adds to the irradiance of the ground.
  Bands PaintRow(int row, Image& map) const {
    const double zenith = Pi * (row + 0.5) / Height;
    const double sunSine = std::sin(sky_.elevation), sunCosine = std::cos(sky_.elevation);
    const double solidAngle =
        2 * Pi / Width * (std::cos(Pi * row / Height) - std::cos(Pi * (row + 1) / Height));
    const bool isSky = row < Height / 2;
    Bands irradiance{};
    for (int column = 0; column < Width / 2; ++column) {
      const double azimuth = 2 * Pi * (column + 0.5) / Width - Pi;
      const double toSun =
          std::cos(zenith) * sunSine + std::sin(zenith) * sunCosine * std::cos(azimuth);
      const auto seen = atmosphere_.See({std::cos(zenith), sunSine, toSun});
      Bands radiance;
      for (std::size_t i = 0; i < BandCount; ++i) {
        radiance[i] = seen.scattered[i] * SolarIrradiance[i];
        if (!isSky) radiance[i] += seen.transmitted[i] * ground_[i];
        irradiance[i] += radiance[i] * float(2 * solidAngle * std::cos(zenith));
      }
      // Both sides of the sun are alike
      const Spectrum color = RgbOf(radiance);
      for (const int x : {column, Width - 1 - column}) {
        float* const texel = &map.floats[4 * (std::size_t(row) * Width + std::size_t(x))];
        for (int c = 0; c < 3; ++c) texel[c] = color[c];
      }
    }
    return irradiance;
  }

  const SkyModel& sky_;
  Bands albedo_;
  Atmosphere atmosphere_;
  Bands ground_{};  // radiance of the lit ground, per nanometre
  Bands direct_{};  // the sun's irradiance on the ground, facing it
};

}  // namespace

vec3 DirectionOf(double elevation, double azimuth) {
  return vec3(glm::dvec3(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                         -std::cos(elevation) * std::cos(azimuth)));
}

SkyLight LightOf(const SkyModel& sky) { return SkyPainter(sky).Paint(); }

void AddSky(const SkyModel& sky, float strength, Scene& scene) {
  SkyLight light = LightOf(sky);
  Environment& environment = scene.environment;
  const double azimuth = sky.azimuth - double(environment.rotation);
  environment.map = ImageIndex(scene.images.size());
  environment.mapScale = Spectrum(strength);
  environment.rotation = float(std::remainder(-azimuth, 2 * Pi));
  environment.ambient = true;
  scene.images.push_back(std::move(light.map));
  if (!sky.sun || light.sunIrradiance == Spectrum(0.0f)) return;
  Light sun;
  sun.name = "sun";
  sun.kind = LightKind::Directional;
  sun.color = light.sunIrradiance;
  sun.strength = strength;
  sun.direction = -DirectionOf(sky.elevation, azimuth);
  sun.angularSize = SunDiameter;
  environment.sun = int(scene.lights.size());
  scene.lights.push_back(sun);
}

}  // namespace snell::scene
