// SPDX-License-Identifier: Apache-2.0
//
// A drawing of an explanation's rays: from above (x to the right, z down) and from the side on which they are widest.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "explain/lines.h"

namespace snell::explain {

namespace {

constexpr double Panel = 480;  // side of a view, pixels
constexpr double Margin = 24;
constexpr double Head = 40;

struct Point {
  double x, y;
};

// One view: which coordinates go right and down.
struct View {
  const char* title;
  int right;
  int down;
  double downSign;
};

double At(const kernel::vec3& v, int axis) {
  return double(axis == 0 ? v.x : axis == 1 ? v.y : v.z);
}

std::string Escape(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '<')
      escaped += "&lt;";
    else if (c == '&')
      escaped += "&amp;";
    else
      escaped += c;
  }
  return escaped;
}

std::string ColorOf(const LineStyle& style) {
  const auto byte = [](float x) { return int(std::lround(255 * x)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(style.color[0]), byte(style.color[1]),
                     byte(style.color[2]));
}

void Draw(const std::vector<Line>& lines, const View& view, double left, std::string& svg) {
  // Fit the lines into the panel
  Point low{1e300, 1e300}, high{-1e300, -1e300};
  const auto project = [&](const kernel::vec3& v) {
    return Point{At(v, view.right), view.downSign * At(v, view.down)};
  };
  for (const Line& line : lines) {
    for (const Point& p : {project(line.from), project(line.to)}) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  const double size = std::max({high.x - low.x, high.y - low.y, 1e-9});
  const double scale = (Panel - 2 * Margin) / size;
  const Point middle{(low.x + high.x) / 2, (low.y + high.y) / 2};
  const auto place = [&](const kernel::vec3& v) {
    const Point p = project(v);
    return Point{left + Panel / 2 + (p.x - middle.x) * scale,
                 Head + Panel / 2 + (p.y - middle.y) * scale};
  };

  svg += fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"white\" "
      "stroke=\"#cccccc\"/>\n<text x=\"{:.1f}\" y=\"{:.1f}\">{}; {:.3g} m wide</text>\n",
      left + 4, Head, Panel - 8, Panel, left + 12, Head + 18, view.title, size);
  for (const Line& line : lines) {
    const LineStyle& style = LineStyles[line.style];
    const Point a = place(line.from), b = place(line.to);
    const bool isLight = style.name == std::string("light") || style.name == std::string("blocked");
    svg += fmt::format(
        "<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" stroke=\"{}\" "
        "stroke-width=\"1.5\"{} marker-end=\"url(#{})\"/>\n",
        a.x, a.y, b.x, b.y, ColorOf(style), isLight ? " stroke-dasharray=\"5 3\"" : "", style.name);
  }
}

}  // namespace

std::string ToSvg(const Explanation& explanation) {
  const std::vector<Line> lines = LinesOf(explanation);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\" font-size=\"13\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#f4f4f4\"/>\n<defs>\n",
      2 * Panel, Head + Panel + 34);
  for (const LineStyle& style : LineStyles)
    svg += fmt::format(
        "<marker id=\"{}\" viewBox=\"0 0 8 8\" refX=\"8\" refY=\"4\" markerWidth=\"6\" "
        "markerHeight=\"6\" orient=\"auto\"><path d=\"M0 0 L8 4 L0 8 z\" fill=\"{}\"/></marker>\n",
        style.name, ColorOf(style));
  svg += "</defs>\n";
  svg += fmt::format(
      "<text x=\"12\" y=\"26\">{}: pixel {},{}, sample {}: radiance {:.4g}, {:.4g}, "
      "{:.4g}</text>\n",
      Escape(explanation.scene), explanation.x, explanation.y, explanation.sample,
      double(explanation.radiance.x), double(explanation.radiance.y),
      double(explanation.radiance.z));
  if (!lines.empty()) {
    // Look along the horizontal axis in which the lines are shorter
    double alongX = 0, alongZ = 0;
    for (const Line& line : lines) {
      alongX += std::abs(double(line.to.x) - double(line.from.x));
      alongZ += std::abs(double(line.to.z) - double(line.from.z));
    }
    Draw(lines, {"from above", 0, 2, 1}, 0, svg);
    Draw(lines,
         alongX >= alongZ ? View{"from the front", 0, 1, -1} : View{"from the side", 2, 1, -1},
         Panel, svg);
  }
  double x = 12;
  for (const LineStyle& style : LineStyles) {
    svg += fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" fill=\"{}\">{}</text>\n", x,
                       Head + Panel + 22, ColorOf(style), style.name);
    x += 90;
  }
  return svg + "</svg>\n";
}

}  // namespace snell::explain
