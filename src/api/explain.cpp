// SPDX-License-Identifier: Apache-2.0
#include "api/explain.h"

#include <fmt/format.h>

#include "api/request.h"
#include "explain/explain.h"
#include "explain/why.h"
#include "util/threads.h"

namespace snell {

static std::unique_ptr<explain::Explainer> Prepare(const Scene& scene,
                                                   const RenderOptions& options) {
  const ThreadLimit limit(options.threads);
  return std::make_unique<explain::Explainer>(scene.contents(),
                                              RequestOf(scene.contents(), options).first);
}

PixelExplainer::PixelExplainer(const Scene& scene, const RenderOptions& options)
    : scene_(scene), explainer_(Prepare(scene_, options)) {}
PixelExplainer::~PixelExplainer() = default;

int PixelExplainer::width() const { return explainer_->width(); }
int PixelExplainer::height() const { return explainer_->height(); }

void PixelExplainer::RequireInside(int x, int y) const {
  if (x < 0 || y < 0 || x >= width() || y >= height())
    throw Error(fmt::format("pixel {},{} lies outside of the picture of {}×{} pixels", x, y,
                            width(), height()));
}

SampleExplanation PixelExplainer::Explain(int x, int y, std::uint32_t sample) const {
  RequireInside(x, y);
  const explain::Explanation explanation = explainer_->Explain(x, y, sample);
  const auto floats = [](const kernel::Spectrum& s) { return std::array<float, 3>{s.x, s.y, s.z}; };
  SampleExplanation told;
  told.radiance = floats(explanation.radiance);
  for (const explain::Contribution& term : explanation.terms) told.terms.push_back(floats(term.L));
  told.text = ToText(explanation);
  told.json = ToJson(explanation);
  told.svg = ToSvg(explanation);
  told.gltf = ToGltf(explanation);
  return told;
}

std::string PixelExplainer::Why(PixelQuestion question, int x, int y, std::uint32_t samples) const {
  RequireInside(x, y);
  const explain::Question asked = question == PixelQuestion::Black    ? explain::Question::Black
                                  : question == PixelQuestion::Bright ? explain::Question::Bright
                                                                      : explain::Question::Noisy;
  return explain::Why(*explainer_, asked, x, y, samples);
}

}  // namespace snell
