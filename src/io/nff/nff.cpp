// SPDX-License-Identifier: Apache-2.0
#include "io/nff/nff.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <utility>
#include <vector>

#include "io/nff/scene.h"
#include "io/nff/words.h"
#include "util/file.h"
#include "util/text.h"

namespace snell::io {
namespace {

using scene::vec3;

constexpr std::uint64_t FileLimit = 2'000'000'000;  // lines and columns fit an int
constexpr int CornerLimit = 10'000;                 // of one polygon, whose cost is quadratic
constexpr int ResolutionLimit = 65'536;
constexpr std::size_t ErrorLimit = 20;

// Reads entity after entity; each function reads what follows the entity's keyword.
class NffReader {
 public:
  NffReader(std::string_view text, const std::string& file, const WarningSink& warn)
      : words_(text, file), scene_(file, warn) {}

  scene::Scene Read() {
    if (words_.Peek().text == "nff")
      words_.Fail(words_.Peek(),
                  "this is WorldToolKit's file format of the same name, not Haines' NFF");
    while (!words_.AtEnd() && errors_.size() < ErrorLimit) {
      try {
        Entity(words_.Next());
      } catch (const Error& error) {
        errors_.push_back(error.diagnostics().front());
        SkipEntity();
      }
    }
    if (!errors_.empty()) throw Error(std::move(errors_));
    return scene_.Finish();
  }

 private:
  struct Form {
    std::string_view keyword;
    void (NffReader::*read)(const NffWord& keyword);
    std::string_view form;
  };
  static const std::array<Form, 8> Forms;
  static constexpr std::array<std::string_view, 6> ViewKeywords = {"from",  "at",     "up",
                                                                   "angle", "hither", "resolution"};

  static bool IsViewKeyword(const NffWord& word) {
    return std::ranges::find(ViewKeywords, word.text) != ViewKeywords.end();
  }

  void SkipEntity() {
    words_.SkipToNextEntity();
    while (IsViewKeyword(words_.Peek())) {
      words_.Next();
      words_.SkipToNextEntity();
    }
  }

  void Entity(const NffWord& word) {
    const auto form = std::ranges::find(Forms, word.text, &Form::keyword);
    if (form != Forms.end()) {
      form_ = form->form;
      (this->*form->read)(word);
    } else if (NffWords::LooksNumeric(word)) {
      words_.Fail(word, fmt::format("{} is a number too many", NffWords::Quoted(word)), Hint());
    } else if (IsViewKeyword(word)) {
      words_.Fail(word, fmt::format("{} stands outside of a view", NffWords::Quoted(word)),
                  "a view begins with 'v'");
    } else {
      words_.Fail(word, fmt::format("unknown entity {}", NffWords::Quoted(word)),
                  "NFF has v, b, l, f, s, c, p and pp");
    }
  }

  std::string Hint() const { return NffWords::Hint(form_); }
  float Number() { return words_.Number(form_); }
  vec3 Vector() { return words_.Vector(form_); }

  float NotNegative() {
    const NffWord word = words_.Peek();
    const float value = Number();
    if (value < 0) words_.Fail(word, fmt::format("{} must not be negative", word.text), Hint());
    return value;
  }

  scene::Spectrum Color() {
    const float red = NotNegative(), green = NotNegative(), blue = NotNegative();
    return scene::Spectrum(red, green, blue);
  }

  void View(const NffWord& keyword) {
    NffView view;
    std::array<bool, ViewKeywords.size()> given{};
    while (IsViewKeyword(words_.Peek())) {
      const NffWord word = words_.Next();
      const auto index = std::ranges::find(ViewKeywords, word.text) - ViewKeywords.begin();
      if (std::exchange(given[std::size_t(index)], true))
        words_.Fail(word, fmt::format("the view has a second {}", NffWords::Quoted(word)), Hint());
      switch (index) {
        case 0: view.from = Vector(); break;
        case 1: view.at = Vector(); break;
        case 2: view.up = Vector(); break;
        case 3: view.angleDegrees = Angle(); break;
        case 4: Number(); break;  // hither: rays need no plane to begin at
        default:
          view.width = words_.Integer(form_, 1, ResolutionLimit);
          view.height = words_.Integer(form_, 1, ResolutionLimit);
      }
    }
    for (std::size_t i = 0; i < 4; ++i)
      if (!given[i])
        words_.Fail(keyword, fmt::format("the view has no '{}'", ViewKeywords[i]), Hint());
    CheckDirections(view, keyword);
    scene_.AddView(view, words_.PlaceOf(keyword));
  }

  float Angle() {
    const NffWord word = words_.Peek();
    const float angle = Number();
    if (!(angle > 0 && angle < 179))
      words_.Fail(word, fmt::format("the angle must lie between 0 and 179 degrees, not {}", angle));
    return angle;
  }

  void CheckDirections(const NffView& view, const NffWord& keyword) const {
    const glm::dvec3 forward = glm::dvec3(view.at) - glm::dvec3(view.from), up(view.up);
    const double sine = glm::length(glm::cross(forward, up));
    if (forward == glm::dvec3(0.0))
      words_.Fail(keyword, "the view's 'from' and 'at' are the same point");
    if (!(sine > 1e-6 * glm::length(forward) * glm::length(up)))
      words_.Fail(keyword, "the view's 'up' has no length or points along the view");
  }

  void Background(const NffWord&) { scene_.SetBackground(Color()); }

  void Light(const NffWord&) {
    const vec3 position = Vector();
    if (words_.AtNumber()) {
      scene_.AddLight(position, Color());
    } else {
      scene_.AddLight(position);
    }
  }

  void Fill(const NffWord& keyword) {
    NffFill fill;
    fill.color = Color();
    fill.diffuse = NotNegative();
    fill.specular = NotNegative();
    fill.shine = NotNegative();
    fill.transmittance = NotNegative();
    const NffWord word = words_.Peek();
    fill.ior = NotNegative();
    if (fill.transmittance > 0 && fill.ior == 0)
      words_.Fail(word, "a surface that light passes through needs an index of refraction",
                  "1 lets light pass straight on");
    scene_.SetFill(fill, words_.PlaceOf(keyword));
  }

  void Sphere(const NffWord& keyword) {
    const vec3 center = Vector();
    const float radius = Number();
    scene_.AddSphere(center, radius, words_.PlaceOf(keyword));
  }

  void Cone(const NffWord& keyword) {
    const vec3 base = Vector();
    const float radius = Number();
    const vec3 top = Vector();
    const float topRadius = Number();
    if (base == top) words_.Fail(keyword, "the cone's base and apex are the same point");
    if ((radius < 0 && topRadius > 0) || (radius > 0 && topRadius < 0))
      words_.Fail(keyword, "the cone's radii must not differ in sign");
    scene_.AddCone(base, radius, top, topRadius, words_.PlaceOf(keyword));
  }

  void Polygon(const NffWord& keyword) { Corners(keyword, false); }
  void Patch(const NffWord& keyword) { Corners(keyword, true); }

  void Corners(const NffWord& keyword, bool withNormals) {
    const int count = words_.Integer(form_, 3, CornerLimit);
    corners_.clear();
    normals_.clear();
    for (int i = 0; i < count; ++i) {
      corners_.push_back(Vector());
      if (withNormals) normals_.push_back(Vector());
    }
    scene_.AddPolygon(corners_, normals_, words_.PlaceOf(keyword));
  }

  NffWords words_;
  NffScene scene_;
  std::string_view form_;  // of the entity that is being read
  std::vector<Diagnostic> errors_;
  std::vector<vec3> corners_, normals_;
};

const std::array<NffReader::Form, 8> NffReader::Forms = {{
    {"v", &NffReader::View,
     "v, then from X Y Z, at X Y Z, up X Y Z, angle DEGREES, hither DISTANCE, resolution WIDTH "
     "HEIGHT"},
    {"b", &NffReader::Background, "b RED GREEN BLUE"},
    {"l", &NffReader::Light, "l X Y Z [RED GREEN BLUE]"},
    {"f", &NffReader::Fill, "f RED GREEN BLUE KD KS SHINE T INDEX"},
    {"s", &NffReader::Sphere, "s X Y Z RADIUS"},
    {"c", &NffReader::Cone, "c X Y Z RADIUS X Y Z RADIUS"},
    {"p", &NffReader::Polygon, "p COUNT, then X Y Z of each corner"},
    {"pp", &NffReader::Patch, "pp COUNT, then X Y Z and a normal of each corner"},
}};

}  // namespace

scene::Scene ParseNff(std::string_view text, const std::filesystem::path& file,
                      const WarningSink& warn) {
  const std::size_t zero = text.find('\0');
  if (zero != std::string_view::npos)
    throw Error("this is not an NFF file, which is text",
                {file.string(), 0, 0, std::int64_t(zero)});
  return NffReader(text, file.string(), warn).Read();
}

scene::Scene ReadNff(const std::filesystem::path& path, const WarningSink& warn,
                     const ReadLimits& limits) {
  const bool isLower = limits.fileBytes < FileLimit;
  return ParseNff(isLower ? ReadWithin(path, limits) : ReadFile(path, FileLimit), path, warn);
}

}  // namespace snell::io
