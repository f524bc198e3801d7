// SPDX-License-Identifier: Apache-2.0
//
// The statements about the state, the files and the options.
#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <glm/matrix.hpp>
#include <utility>

#include "io/mesh/text.h"
#include "io/pbrt/reader.h"

namespace snell::io {

static constexpr std::size_t MaxSaved = 4096;
static constexpr std::size_t MaxDefaults = 100;

void PbrtReader::Push(char kind) {
  if (saved_.size() >= MaxSaved) throw Error("attributes are nested too deeply", place_);
  saved_.push_back({state_, kind, place_});
}

void PbrtReader::Pop(char kind) {
  if (saved_.empty() || saved_.back().kind != kind)
    throw Error(fmt::format("'{}' has no beginning", statement_), place_);
  state_ = std::move(saved_.back().state);
  saved_.pop_back();
}

void PbrtReader::AttributeBegin() { Push('a'); }
void PbrtReader::AttributeEnd() { Pop('a'); }
void PbrtReader::TransformBegin() { Push('t'); }

// Only the transform is as before.
void PbrtReader::TransformEnd() {
  PbrtState now = state_;
  Pop('t');
  now.transform = state_.transform;
  now.transformEnd = state_.transformEnd;
  now.startCounts = state_.startCounts;
  now.endCounts = state_.endCounts;
  state_ = std::move(now);
}

void PbrtReader::Attribute() {
  const std::string target = String("a target");
  const PbrtParameters parameters = Parameters(target);
  PbrtDefaults* defaults = target == "shape"      ? &state_.shapes
                           : target == "light"    ? &state_.lights
                           : target == "material" ? &state_.materials
                           : target == "medium"   ? &state_.media
                           : target == "texture"  ? &state_.textures
                                                  : nullptr;
  if (!defaults)
    throw Error(fmt::format("'Attribute' is for shape, light, material, medium or texture, not {}",
                            Quoted(target)),
                place_);
  for (const auto& parameter : parameters.All()) {
    std::erase_if(*defaults, [&](const auto& old) { return old->name == parameter->name; });
    defaults->push_back(parameter);
  }
  if (defaults->size() > MaxDefaults) throw Error("there are too many attributes", place_);
}

void PbrtReader::ReverseOrientation() { state_.isReversed = !state_.isReversed; }

void PbrtReader::ColorSpace() {
  const std::string name = String("a name");
  if (name == "srgb") {
    state_.colorSpace = {};
  } else if (name == "dci-p3") {
    state_.colorSpace = {{0.68, 0.32}, {0.265, 0.69}, {0.15, 0.06}, {0.3127, 0.329}};
  } else if (name == "rec2020") {
    state_.colorSpace = {{0.708, 0.292}, {0.17, 0.797}, {0.131, 0.046}, {0.3127, 0.329}};
  } else if (name == "aces2065-1") {
    state_.colorSpace = {{0.7347, 0.2653}, {0, 1}, {0.0001, -0.077}, {0.32168, 0.33767}};
  } else {
    throw Error(fmt::format("there is no colour space {}", Quoted(name)), place_,
                "pbrt has srgb, dci-p3, rec2020 and aces2065-1");
  }
}

void PbrtReader::Include() {
  const Place place = place_;
  ReadFileOf(String("a file's name"), place);
}

// Like Include, but the state afterwards is as before.
void PbrtReader::Import() {
  const Place place = place_;
  const std::string name = String("a file's name");
  Push('f');
  const std::size_t depth = saved_.size();
  ReadFileOf(name, place);
  if (saved_.size() != depth || saved_.back().kind != 'f')
    throw Error(fmt::format("the file {} has a beginning without an end", Quoted(name)), place);
  Pop('f');
}

void PbrtReader::WorldBegin() {
  RequireWorld(false);
  isInWorld_ = true;
  fromPbrt_ = view_.FromPbrt();
  state_.transform = state_.transformEnd = scene::Affine(1.0);
  state_.startCounts = state_.endCounts = true;
  coordinateSystems_["world"] = {state_.transform, state_.transformEnd};
}

void PbrtReader::WorldEnd() {
  context_.findings.Add("'WorldEnd'", "not needed: this may be a file for pbrt-v3", "", place_);
}

void PbrtReader::Camera() {
  RequireWorld(false);
  const std::string type = String("a type");
  const PbrtParameters parameters = Parameters(type);
  view_.ReadCamera(type, parameters, state_.transform, MotionOf(scene::Affine(1.0)));
  coordinateSystems_["camera"] = {glm::inverse(state_.transform),
                                  glm::inverse(state_.transformEnd)};
  parameters.ReportUnused(context_.findings);
}

void PbrtReader::Film() {
  RequireWorld(false);
  const PbrtParameters parameters = Parameters(String("a type"));
  view_.ReadFilm(parameters);
  parameters.ReportUnused(context_.findings);
}

void PbrtReader::Sampler() {
  RequireWorld(false);
  const std::string type = String("a type");
  const PbrtParameters parameters = Parameters(type);
  view_.ReadSampler(type, parameters);
  parameters.ReportUnused(context_.findings);
}

void PbrtReader::PixelFilter() {
  RequireWorld(false);
  const std::string type = String("a type");
  const PbrtParameters parameters = Parameters(type);
  view_.ReadFilter(type, parameters);
  parameters.ReportUnused(context_.findings);
}

void PbrtReader::Integrator() {
  RequireWorld(false);
  const std::string type = String("a type");
  const PbrtParameters parameters = Parameters(type);
  view_.ReadIntegrator(type, parameters);
  parameters.ReportUnused(context_.findings);
}

// A name, before which a type may stand, and a value.
void PbrtReader::Option() {
  std::string name = String("a name");
  name = name.substr(name.find_last_of(' ') + 1);
  const bool isBracketed = words_->Peek().kind == PbrtWord::Kind::Open;
  if (isBracketed) words_->Next();
  const PbrtWord value = words_->Next();
  double number = 0;
  const bool isNumber = value.kind == PbrtWord::Kind::Bare && ParseNumber(value.text, number);
  if (value.kind != PbrtWord::Kind::Bare && value.kind != PbrtWord::Kind::String)
    throw Error(fmt::format("option {} needs a value, not {}", Quoted(name), Quoted(value)),
                words_->PlaceOf(value));
  if (isBracketed && words_->Next().kind != PbrtWord::Kind::Close)
    throw Error(fmt::format("option {} needs one value", Quoted(name)), place_);
  if (name == "seed" && isNumber && std::abs(number) < 1e9) {
    context_.scene.settings.seed = std::uint32_t(std::int64_t(number));
  } else if (name != "rendercoordsys") {
    context_.findings.Add("option", "of pbrt's not used", name, place_);
  }
}

// How pbrt finds hits does not change the picture.
void PbrtReader::Accelerator() { Parameters(String("a type")); }

}  // namespace snell::io
