// SPDX-License-Identifier: Apache-2.0
//
// Renders a sphere through the installed library and looks at the result; then asks for a scene that is
// wrong, to see the error arrive across the library's border.
#include <snell/api/snell.h>

#include <cmath>
#include <cstdio>
#include <fstream>

namespace {

// A glowing sphere without lights: 1 in its middle, 0 around it.
constexpr const char* SphereScene = R"(
[render]
size = [32, 24]
spp  = 4

[camera]
position = [0, 0, 5]
look_at  = [0, 0, 0]

[[object]]
shape    = "sphere"
material = { type = "classic", emission = 1 }
)";

class Counter final : public snell::Progress {
 public:
  void Begin(std::string_view, std::uint64_t) override { ++phases; }
  void Update(std::uint64_t, std::uint64_t) override {}
  void End() override {}

  int phases = 0;
};

int Fail(const char* what) {
  std::fprintf(stderr, "consumer: %s\n", what);
  return 1;
}

}  // namespace

int main() {
  // A picture in three lines
  std::ofstream("consumer.toml") << SphereScene;
  Counter counter;
  const snell::Scene scene = snell::LoadScene("consumer.toml");
  const snell::RenderResult result = snell::Render(scene, {}, &counter);
  snell::WritePicture("consumer.exr", result.picture);

  const snell::Picture picture = snell::ReadPicture("consumer.exr");
  if (picture.width != 32 || picture.height != 24) return Fail("the picture has the wrong size");
  const float middle = picture.rgb[3 * (12 * 32 + 16)];
  if (std::abs(middle - 1) > 1e-3f || picture.rgb[0] != 0) return Fail("the picture is wrong");
  if (counter.phases == 0) return Fail("no progress was reported");
  if (snell::Inspect(scene).objects != 1) return Fail("the scene has not one object");

  std::ofstream("consumer.toml") << "[camera]\nfov = -1\n";
  try {
    snell::LoadScene("consumer.toml");
    return Fail("a wrong scene was accepted");
  } catch (const snell::Error& error) {
    if (error.diagnostics().front().place.line != 2) return Fail("the error has no line");
  }
  return 0;
}
