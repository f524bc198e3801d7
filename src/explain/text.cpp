// SPDX-License-Identifier: Apache-2.0
//
// An explanation as a tree of lines, as people read it.
#include <fmt/format.h>

#include <cmath>

#include "explain/explanation.h"

namespace snell::explain {

namespace {

using kernel::Spectrum;
using kernel::vec2;
using kernel::vec3;

std::string Numbers(const vec3& v) {
  return fmt::format("({:.5g}, {:.5g}, {:.5g})", double(v.x), double(v.y), double(v.z));
}
std::string Color(const Spectrum& s) {
  if (s.x == s.y && s.y == s.z) return fmt::format("{:.5g}", double(s.x));
  return Numbers(s);
}

class Tree {
 public:
  explicit Tree(const Explanation& explanation) : explanation_(explanation) {
    Head();
    if (!explanation.rays.empty()) Branch(0, "", "");
  }
  std::string text;

 private:
  void Line(const std::string& indent, const std::string& line) { text += indent + line + '\n'; }

  void Head() {
    const Explanation& e = explanation_;
    Line("", fmt::format("{}: pixel {},{} of {}×{}, sample {}, integrator {}", e.scene, e.x, e.y,
                         e.width, e.height, e.sample, e.integrator));
    Line("", fmt::format("radiance {}, the sum of {} term{}", Numbers(e.radiance), e.terms.size(),
                         e.terms.size() == 1 ? "" : "s"));
    for (std::size_t i = 0; i < e.terms.size(); ++i) {
      const Contribution& term = e.terms[i];
      Line("", fmt::format("  {:>3}  {}  {}, at the end of ray {}{}", i + 1, Numbers(term.L),
                           term.source, term.ray + 1, term.held ? "; held to clamp_indirect" : ""));
    }
    Line("", "");
  }

  void SurfaceLines(const std::string& indent, const Segment& ray) {
    const Surface& s = *ray.surface;
    Line(indent, fmt::format("meets '{}'{}, material '{}', {}, from {}, after {:.5g} m", s.object,
                             s.place.empty() ? "" : " (" + s.place + ")", s.material, s.part,
                             s.fromOutside ? "its front" : "its back", double(ray.length)));
    Line(indent, fmt::format("  at {}, normal {}{}, uv ({:.4g}, {:.4g})", Numbers(s.p),
                             Numbers(s.n), s.n == s.ns ? "" : ", shading normal " + Numbers(s.ns),
                             double(s.uv.x), double(s.uv.y)));
    if (s.refracts)
      Line(indent,
           fmt::format("  {} (index {:.4g} to {:.4g}): {}", s.fromOutside ? "enters" : "leaves",
                       double(s.nearIor), double(s.nearIor * s.eta),
                       s.totalReflection
                           ? "total internal reflection"
                           : fmt::format("Fresnel reflectance {:.4g}", double(s.fresnel))));
    for (const TextureRead& read : ray.reads)
      Line(indent,
           fmt::format("  reads '{}' at ({:.4g}, {:.4g}): ({:.4g}, {:.4g}, {:.4g}, {:.4g})",
                       read.texture, double(read.uv.x), double(read.uv.y), double(read.value.x),
                       double(read.value.y), double(read.value.z), double(read.value.w)));
  }

  void LightLine(const std::string& indent, const LightTry& light) {
    std::string line = fmt::format("asks {}", light.light);
    if (light.pick < 1) line += fmt::format(" (chosen with {:.3g})", double(light.pick));
    line += ": ";
    if (light.outcome == "lit") {
      line += fmt::format("irradiance {}, scatters {}, {} arrives, weight {:.4g}",
                          Color(light.irradiance), Color(light.f), Color(light.passed),
                          double(light.weight));
    } else if (light.outcome == "blocked") {
      line += fmt::format("blocked by '{}'", light.blocker);
    } else {
      line += light.outcome;
    }
    Line(indent, line);
  }

  // A ray with what follows it; `first` stands before its first line, `rest` before the others.
  void Branch(std::size_t index, const std::string& first, const std::string& rest) {
    const Segment& ray = explanation_.rays[index];
    Line(first, fmt::format("{}. {} ray from {} towards {}", index + 1, ray.kind, Numbers(ray.o),
                            Numbers(ray.d)));
    std::vector<std::size_t> children;
    for (std::size_t i = index + 1; i < explanation_.rays.size(); ++i) {
      if (explanation_.rays[i].parent == int(index)) children.push_back(i);
    }
    const std::string indent = rest + (children.empty() ? "     " : "│    ");
    if (!ray.media.empty()) {
      std::string inside;
      for (const std::string& name : ray.media) inside += fmt::format(" '{}'", name);
      Line(indent, "runs inside" + inside);
    }
    if (ray.surface) SurfaceLines(indent, ray);
    if (!ray.surface && ray.scattered)
      Line(indent, fmt::format("is scattered by the medium after {:.5g} m", double(ray.length)));
    if (!ray.surface && !ray.scattered && std::isinf(ray.length)) Line(indent, "leaves the scene");
    Line(indent, "light from its end counts " + Color(ray.weight));
    for (const LightTry& light : ray.lights) LightLine(indent, light);
    for (const int term : ray.terms) {
      const Contribution& found = explanation_.terms[std::size_t(term)];
      Line(indent, fmt::format("adds term {}: {} from {}", term + 1, Color(found.L), found.source));
    }
    if (ray.way && ray.way->pdf > 0)
      Line(indent, fmt::format("goes on by {}: density {:.4g}, weight {}", ray.way->lobe,
                               double(ray.way->pdf), Color(ray.way->weight)));
    for (const std::string& note : ray.notes) Line(indent, note);
    for (std::size_t i = 0; i < children.size(); ++i) {
      const bool isLast = i + 1 == children.size();
      Branch(children[i], rest + (isLast ? "└ " : "├ "), rest + (isLast ? "  " : "│ "));
    }
  }

  const Explanation& explanation_;
};

}  // namespace

std::string ToText(const Explanation& explanation) { return Tree(explanation).text; }

}  // namespace snell::explain
