// SPDX-License-Identifier: Apache-2.0
//
// What is told of samples: the same radiance as in a render, terms that add up to it bit for bit, what is known of small
// scenes, and the forms that it is written in.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "render/scene_text.h"
#include "support/random.h"
#include "support/scratch_folder.h"

namespace snell::test {
namespace {

namespace fs = std::filesystem;

constexpr int Width = 40, Height = 30;

std::vector<fs::path> Gallery() {
  std::vector<fs::path> scenes;
  for (const auto& entry :
       fs::directory_iterator(fs::path(SNELL_SOURCE_DIR) / "scenes" / "gallery")) {
    if (entry.path().extension() == ".toml") scenes.push_back(entry.path());
  }
  std::ranges::sort(scenes);
  return scenes;
}

std::string NameOf(const testing::TestParamInfo<fs::path>& info) {
  return info.param.stem().string();
}

class ExplainGallery : public testing::TestWithParam<fs::path> {};

// As films keep numbers (render/exact_sum.h).
float InFilm(float x) { return float(std::nearbyint(double(x) * 0x1p56) * 0x1p-56); }

// Twelve samples of each scene with each integrator: a thousand of the gallery
TEST_P(ExplainGallery, TermsAddUpToTheSampleBitForBit) {
  const Scene scene = LoadScene(GetParam());
  Random random(7);
  for (const char* integrator : {"whitted", "path"}) {
    for (const std::uint32_t sample : {0u, 5u}) {
      RenderOptions options;
      options.width = Width;
      options.height = Height;
      options.integrator = integrator;
      options.clampIndirect = 0.0f;
      options.device = "cpu";
      options.samples = {sample, sample + 1};
      const Picture picture = Render(scene, options).picture;
      const PixelExplainer explainer(scene, options);
      for (int i = 0; i < 6; ++i) {
        const int x = int(random.Index(Width)), y = int(random.Index(Height));
        const SampleExplanation told = explainer.Explain(x, y, sample);
        std::array<float, 3> sum{};
        for (const std::array<float, 3>& term : told.terms)
          for (std::size_t k = 0; k < 3; ++k) sum[k] += term[k];
        const float* shown = &picture.rgb[3 * (std::size_t(y) * Width + std::size_t(x))];
        for (std::size_t k = 0; k < 3; ++k) {
          EXPECT_EQ(InFilm(told.radiance[k]), shown[k])
              << integrator << " pixel " << x << "," << y << " sample " << sample;
          EXPECT_EQ(sum[k], told.radiance[k])
              << integrator << " pixel " << x << "," << y << " sample " << sample;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, ExplainGallery, testing::ValuesIn(Gallery()), NameOf);

// A floor under a lamp; `more` adds to it.
Scene FloorUnderLamp(const std::string& integrator, const std::string& more = "") {
  return SceneOf(fmt::format(R"(
[render]
size = [8, 8]
integrator = "{}"
[camera]
position = [0, 2, 6]
look_at = [0, 0, 0]
fov = 20
[[light]]
name = "lamp"
type = "point"
position = [0, 4, 0]
intensity = 30
[[object]]
name = "floor"
shape = "plane"
material = {{ type = "diffuse", color = [0.5, 0.5, 0.5] }}
{})",
                             integrator, more));
}

bool Has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Explain, TellsWhatIsMetAndWhichLightCounts) {
  for (const char* integrator : {"whitted", "path"}) {
    const SampleExplanation told = PixelExplainer(FloorUnderLamp(integrator)).Explain(4, 4, 0);
    EXPECT_TRUE(Has(told.text, "1. camera ray from (0, 2, 6)")) << told.text;
    EXPECT_TRUE(Has(told.text, "meets 'floor'")) << told.text;
    EXPECT_TRUE(Has(told.text, "plane, from its front")) << told.text;
    EXPECT_TRUE(Has(told.text, "asks the light 'lamp'")) << told.text;
    EXPECT_TRUE(Has(told.text, "1 arrives")) << told.text;
    EXPECT_GT(told.radiance[0], 0.1f);
  }
}

TEST(Explain, NamesWhatBlocksALight) {
  const std::string lid =
      "[[object]]\nname = 'lid'\nshape = 'disk'\ncenter = [0, 3, 0]\nnormal = [0, 1, 0]\nradius = "
      "2\n"
      "material = { type = 'diffuse', color = 0.5 }\n";
  for (const char* integrator : {"whitted", "path"}) {
    const PixelExplainer explainer(FloorUnderLamp(integrator, lid));
    const SampleExplanation told = explainer.Explain(4, 4, 0);
    EXPECT_TRUE(Has(told.text, "asks the light 'lamp': blocked by 'lid'")) << told.text;
    const std::string why = explainer.Why(PixelQuestion::Black, 4, 4, 16);
    EXPECT_TRUE(Has(why, "100.0 %  'floor' of material")) << why;
    EXPECT_TRUE(Has(why, "the light 'lamp': blocked by 'lid'")) << why;
  }
}

TEST(Explain, TellsRefractionAndTotalReflection) {
  // From within glass, at 60° to the normal of a flat boundary
  const Scene scene = SceneOf(R"(
[render]
size = [1, 1]
integrator = "whitted"
filter_radius = 0.0001
[camera]
position = [0, 1, 0]
look_at = [1.7320508, 0, 0]
fov = 1
[environment]
bottom = [1, 1, 1]
top = [1, 1, 1]
[[object]]
name = "block"
shape = "box"
min = [-50, 0, -50]
max = [50, 50, 50]
material = { type = "dielectric", ior = 1.5 }
)");
  const SampleExplanation told = PixelExplainer(scene).Explain(0, 0, 0);
  EXPECT_TRUE(Has(told.text, "runs inside 'block'")) << told.text;
  EXPECT_TRUE(Has(told.text, "leaves (index 1.5 to 1): total internal reflection")) << told.text;
  EXPECT_TRUE(Has(told.text, "2. reflected ray")) << told.text;
}

TEST(Explain, SortsTheWaysOfLightByWhatTheyBring) {
  const std::string shine = "[environment]\nbottom = [0.1, 0.1, 0.1]\ntop = [0.1, 0.1, 0.1]\n";
  const PixelExplainer explainer(FloorUnderLamp("path", shine));
  const std::string why = explainer.Why(PixelQuestion::Bright, 4, 4, 32);
  const std::size_t lamp = why.find("'floor' -> the light 'lamp': in 32 of 32 samples");
  const std::size_t sky = why.find("'floor' -> the background");
  ASSERT_NE(lamp, std::string::npos) << why;
  ASSERT_NE(sky, std::string::npos) << why;
  EXPECT_LT(lamp, sky);
}

TEST(Explain, RaysAsGltfAreASceneOfLines) {
  const ScratchFolder folder;
  const SampleExplanation told = PixelExplainer(FloorUnderLamp("path")).Explain(4, 4, 0);
  folder.Write("rays.gltf", told.gltf);
  // A reader of glTF accepts it, and says that lines have no area
  std::vector<std::string> warnings;
  LoadOptions options;
  options.warn = [&](const Diagnostic& warning) { warnings.push_back(warning.message); };
  try {
    LoadScene(folder.Path("rays.gltf"), options);
  } catch (const Error& error) {
    warnings.push_back(error.what());
  }
  ASSERT_FALSE(warnings.empty());
  EXPECT_TRUE(Has(warnings.front(), "line")) << warnings.front();
  EXPECT_TRUE(told.svg.starts_with("<svg ")) << told.svg;
  EXPECT_TRUE(Has(told.svg, "</svg>"));
  EXPECT_TRUE(Has(told.json, "\"object\": \"floor\"")) << told.json;
}

TEST(Explain, PixelsOutsideAreAnError) {
  const PixelExplainer explainer(FloorUnderLamp("path"));
  EXPECT_THROW(explainer.Explain(8, 0, 0), Error);
  EXPECT_THROW(explainer.Explain(0, -1, 0), Error);
}

}  // namespace
}  // namespace snell::test
