// SPDX-License-Identifier: Apache-2.0
//
// Closed rooms whose walls glow with L and send back the share a of all light: each wall is L (1 + a + a² + …) bright.
#include <fmt/format.h>

#include "selftest/scenes.h"
#include "selftest/selftest.h"

namespace snell::selftest {

void ClosedRooms(const CheckSink& sink) {
  const std::pair<const char*, scene::Geometry> rooms[] = {
      {"sphere", scene::Sphere{}}, {"box", scene::Box{{-1, -0.7f, -1.3f}, {1, 0.7f, 1.3f}}}};
  for (const auto& [name, room] : rooms) {
    for (const double albedo : {0.3, 0.6, 0.9}) {
      scene::Scene scene = Empty(12, 400, 400);
      LookAt(scene, {0.3f, 0.1f, 0}, {1, 0, 0}, 80);
      scene::Material wall = Physical(Spectrum(float(albedo)));
      wall.physical->emission.value = Spectrum(0.2f);
      Add(scene, room, wall);
      const double expected = 0.2 / (1 - albedo);
      sink(Near("closed", fmt::format("{}, albedo {}", name, albedo), MeanRadiance(scene).y,
                expected, 0.006 * expected));
    }
  }
}

}  // namespace snell::selftest
