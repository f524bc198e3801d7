// SPDX-License-Identifier: Apache-2.0
//
// Light of the sun in a clear atmosphere, by integration along rays: scattering and absorption by air (Rayleigh), haze
// (Mie) and ozone in spherical layers; what is scattered more than once by the approximation of Hillaire 2020, "A
// scalable and production ready sky and atmosphere rendering technique", section 5.5. Coefficients: Bruneton 2017,
// "A qualitative and quantitative evaluation of 8 clear sky models", sections 3 and 4.
#pragma once

#include <vector>

#include "scene/sky/bands.h"

namespace snell::scene {

// Lengths in metres. A zenith cosine is that of the angle between a direction and the vertical.
class Atmosphere {
 public:
  // Turbidity is the optical thickness of air and haze over that of air alone: 1 in pure air, 2 to 3 on clear days, 10
  // in thick haze. The ground's albedo counts for light that comes up again.
  Atmosphere(double turbidity, const Bands& groundAlbedo);

  // The share of light that comes from space to a height from a direction; none if the ground is in between.
  Bands Transmittance(double height, double zenithCosine) const;

  // What is seen from just above the ground in a direction.
  struct View {
    double zenithCosine;
    double sunZenithCosine;
    double cosineToSun;  // of the angle between the direction and the sun's
  };
  struct Seen {
    Bands scattered{};  // radiance per irradiance of the sun in space, 1/sr
    Bands
        transmitted{};  // the share of the light from the end of the ray, which is the ground or space
  };
  Seen See(const View& view) const;

 private:
  // Amounts of air, haze and ozone, as lengths at the density that the coefficients are for.
  struct Amounts {
    double air = 0, haze = 0, ozone = 0;
  };
  static Amounts DensitiesAt(double height);
  Amounts AmountsToSpace(double radius, double zenithCosine) const;
  Bands Transmit(const Amounts& amounts) const;
  Bands SunAt(double radius, double sunZenithCosine) const;
  Bands MultipleAt(double radius, double sunZenithCosine) const;
  void FillAmounts();
  void FillMultiple();
  Bands MultipleFor(double radius, double sunZenithCosine) const;

  Bands air_{}, haze_{}, ozone_{};  // extinction per metre
  Bands groundAlbedo_;
  std::vector<Amounts> amounts_;  // to space, by height and angle
  std::vector<Bands> multiple_;   // radiance scattered more than once, of all directions the same
};

}  // namespace snell::scene
