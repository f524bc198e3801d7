// SPDX-License-Identifier: Apache-2.0
//
// Snell's public interface: why a pixel looks as it does. Installed as <snell/api/explain.h>. docs/debugging.md
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "render.h"

namespace snell {

namespace explain {
class Explainer;
}

// How one sample of a pixel came about.
struct SampleExplanation {
  std::array<float, 3> radiance{};  // as a render has it
  std::vector<std::array<float, 3>>
      terms;         // added up in this order, as floats, they are the radiance to the bit
  std::string text;  // the path or tree of rays, to read
  std::string json;  // the same as data
  std::string svg;   // as a drawing
  std::string gltf;  // as lines to show over the scene
};

enum class PixelQuestion { Black, Bright, Noisy };

// A scene prepared for questions about its pixels, which are those of a render with the same options. It always works
// on the processor.
class SNELL_EXPORT PixelExplainer {
 public:
  // Throws Error.
  explicit PixelExplainer(const Scene& scene, const RenderOptions& options = {});
  ~PixelExplainer();

  int width() const;
  int height() const;

  // Of a pixel counted from the upper left corner. Throws Error if it lies outside of the picture.
  SampleExplanation Explain(int x, int y, std::uint32_t sample) const;
  // The causes, from that many samples, as lines to read.
  std::string Why(PixelQuestion question, int x, int y, std::uint32_t samples) const;

 private:
  void RequireInside(int x, int y) const;

  Scene scene_;
  std::unique_ptr<explain::Explainer> explainer_;
};

}  // namespace snell
