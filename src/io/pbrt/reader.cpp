// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/mesh/text.h"
#include "util/file.h"
#include "util/text.h"

namespace snell::io {

static constexpr std::size_t MaxOpenFiles = 32;
static constexpr std::uint64_t MaxFiles = 10'000;

const std::vector<PbrtReader::Statement>& PbrtReader::Statements() {
  using R = PbrtReader;
  static const std::vector<Statement> statements = {
      {"Accelerator", &R::Accelerator},
      {"ActiveTransform", &R::ActiveTransform},
      {"AreaLightSource", &R::AreaLightSource},
      {"Attribute", &R::Attribute},
      {"AttributeBegin", &R::AttributeBegin},
      {"AttributeEnd", &R::AttributeEnd},
      {"Camera", &R::Camera},
      {"ColorSpace", &R::ColorSpace},
      {"ConcatTransform", &R::ConcatTransform},
      {"CoordSysTransform", &R::CoordSysTransform},
      {"CoordinateSystem", &R::CoordinateSystem},
      {"Film", &R::Film},
      {"Identity", &R::Identity},
      {"Import", &R::Import},
      {"Include", &R::Include},
      {"Integrator", &R::Integrator},
      {"LightSource", &R::LightSource},
      {"LookAt", &R::LookAt},
      {"MakeNamedMaterial", &R::MakeNamedMaterial},
      {"MakeNamedMedium", &R::MakeNamedMedium},
      {"Material", &R::Material},
      {"MediumInterface", &R::MediumInterface},
      {"NamedMaterial", &R::NamedMaterial},
      {"ObjectBegin", &R::ObjectBegin},
      {"ObjectEnd", &R::ObjectEnd},
      {"ObjectInstance", &R::ObjectInstance},
      {"Option", &R::Option},
      {"PixelFilter", &R::PixelFilter},
      {"ReverseOrientation", &R::ReverseOrientation},
      {"Rotate", &R::Rotate},
      {"Sampler", &R::Sampler},
      {"Scale", &R::Scale},
      {"Shape", &R::Shape},
      {"Texture", &R::Texture},
      {"Transform", &R::Transform},
      {"TransformBegin", &R::TransformBegin},
      {"TransformEnd", &R::TransformEnd},
      {"TransformTimes", &R::TransformTimes},
      {"Translate", &R::Translate},
      {"WorldBegin", &R::WorldBegin},
      {"WorldEnd", &R::WorldEnd},
  };
  return statements;
}

void PbrtReader::Read(std::string_view text) {
  std::error_code ignored;
  openFiles_.push_back(std::filesystem::weakly_canonical(context_.file, ignored).string());
  bytesRead_ = text.size();
  ReadText(text, context_.file);
  if (!saved_.empty())
    throw Error(fmt::format("'{}Begin' has no end", saved_.back().kind == 'o'   ? "Object"
                                                    : saved_.back().kind == 't' ? "Transform"
                                                                                : "Attribute"),
                saved_.back().place);
  if (!isInWorld_)
    throw Error("the file has no 'WorldBegin'", {context_.file},
                "it may be a part that another file includes");
  view_.Finish();
}

void PbrtReader::ReadText(std::string_view text, const std::string& file) {
  RequireText(text, file);
  PbrtWords words(text, file);
  PbrtWords* const outer = std::exchange(words_, &words);
  while (words.Peek().kind != PbrtWord::Kind::End) ReadStatement();
  words_ = outer;
}

// Read a file that another one names, in its place.
void PbrtReader::ReadFileOf(const std::string& name, const Place& place) {
  if (name.ends_with(".gz"))
    throw Error(fmt::format("the compressed file {} is not read", Quoted(name)), place,
                "unpack it with gunzip, and change the name");
  // Exactly the file that is named: a likely one would be a guess at the scene
  std::filesystem::path path;
  std::error_code ignored;
  try {
    path = ConfinedPath(FoldersOf(context_.file, context_.options), context_.folder, name);
  } catch (const Error&) {
  }
  if (path.empty() || !std::filesystem::is_regular_file(path, ignored))
    throw Error(fmt::format("the file {} is not found in the scene's folder", Quoted(name)), place);
  const std::string real = std::filesystem::weakly_canonical(path, ignored).string();
  if (std::ranges::find(openFiles_, real) != openFiles_.end())
    throw Error(fmt::format("the file {} includes itself", Quoted(name)), place);
  if (openFiles_.size() >= MaxOpenFiles)
    throw Error(fmt::format("files include each other over more than {} levels", MaxOpenFiles),
                place);
  if (++filesRead_ > MaxFiles)
    throw Error(fmt::format("more than {} are included", Plural(MaxFiles, "file")), place);
  const std::string text =
      ReadWithin(path, context_.options.limits, &ReadLimits::fileBytes, bytesRead_);
  bytesRead_ += text.size();
  openFiles_.push_back(real);
  ReadText(text, path.string());
  openFiles_.pop_back();
}

void PbrtReader::ReadStatement() {
  const PbrtWord word = words_->Next();
  place_ = words_->PlaceOf(word);
  statement_ = word.text;
  const std::vector<Statement>& statements = Statements();
  const auto statement = std::ranges::find(statements, word.text, &Statement::name);
  if (word.kind == PbrtWord::Kind::Bare && statement != statements.end())
    return (this->*statement->read)();

  double number = 0;
  if (word.kind != PbrtWord::Kind::Bare || ParseNumber(word.text, number))
    throw Error(fmt::format("a statement is expected, not {}", Quoted(word)), place_);
  std::vector<std::string> names;
  for (const Statement& known : statements) names.emplace_back(known.name);
  throw Error(fmt::format("there is no statement {}", Quoted(word)), place_,
              DidYouMean(word.text.substr(0, 40), names));
}

std::string PbrtReader::String(std::string_view what) {
  const PbrtWord word = words_->Next();
  if (word.kind != PbrtWord::Kind::String)
    throw Error(fmt::format("{} needs {} in quotes, not {}", statement_, what, Quoted(word)),
                words_->PlaceOf(word));
  return Unescaped(word.text);
}

// So many numbers, in brackets or without.
std::vector<double> PbrtReader::Numbers(std::size_t count) {
  const bool isBracketed = words_->Peek().kind == PbrtWord::Kind::Open;
  if (isBracketed) words_->Next();
  std::vector<double> numbers(count);
  for (double& number : numbers) {
    const PbrtWord word = words_->Next();
    if (word.kind != PbrtWord::Kind::Bare || !ParseNumber(word.text, number) ||
        !(std::abs(number) < 1e30))
      throw Error(
          fmt::format("{} needs {}, not {}", statement_, Plural(count, "number"), Quoted(word)),
          words_->PlaceOf(word));
  }
  if (!isBracketed) return numbers;
  const PbrtWord word = words_->Next();
  if (word.kind != PbrtWord::Kind::Close)
    throw Error(fmt::format("a bracket that closes is expected, not {}", Quoted(word)),
                words_->PlaceOf(word));
  return numbers;
}

PbrtParameters PbrtReader::Parameters(std::string_view title) {
  context_.colorSpace = state_.colorSpace;
  return {*words_, std::string(statement_) + " '" + std::string(title.substr(0, 40)) + "'", place_};
}

void PbrtReader::RequireWorld(bool isInWorld) const {
  if (isInWorld == isInWorld_) return;
  throw Error(
      fmt::format("'{}' must stand {} 'WorldBegin'", statement_, isInWorld ? "after" : "before"),
      place_, isInWorld ? "a file without one may be a part that another file includes" : "");
}

}  // namespace snell::io
