// SPDX-License-Identifier: Apache-2.0
#include "io/toml/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "util/file.h"
#include "util/text.h"

namespace snell::io {

namespace fs = std::filesystem;

// More findings than this are only counted, so that a broken 100-MB file does not fill the memory.
static constexpr std::size_t MaxKeptFindings = 10'000;
static constexpr std::size_t MaxQuoted = 60;

Reader::Reader(const fs::path& sceneFile, const ReadOptions& options)
    : limits(options.limits),
      inclusion(options.inclusion ? options.inclusion : std::make_shared<Inclusion>()),
      folders(FoldersOf(sceneFile, options)),
      time(options.time) {
  scene.name = sceneFile.filename().string();
}

void Reader::Report(std::string message, Place place, std::string hint) {
  ++findingCount_;
  if (findings_.size() < MaxKeptFindings)
    findings_.push_back({std::move(message), std::move(place), std::move(hint)});
}

bool Reader::Refuse(const Node& value, std::string_view expected, std::string hint) {
  Report(fmt::format("'{}': expected {}, found {}", key, expected, value.Description()),
         value.place(), std::move(hint));
  return false;
}

void Reader::ThrowFindings() {
  if (findings_.empty()) return;
  SortByPlace(findings_);
  if (findings_.size() > MaxFindings) findings_.resize(MaxFindings);
  if (findingCount_ > findings_.size())
    findings_.push_back({fmt::format("and {} more", findingCount_ - findings_.size())});
  throw Error(std::move(findings_));
}

void Reader::Warn(std::string message, Place place, std::string hint) {
  if (warnings_.size() < MaxKeptFindings)
    warnings_.push_back({std::move(message), std::move(place), std::move(hint)});
}

void Reader::EmitWarnings(const WarningSink& sink) {
  SortByPlace(warnings_);
  for (const Diagnostic& warning : warnings_)
    if (sink) sink(warning);
}

void Reader::SortByPlace(std::vector<Diagnostic>& list) const {
  const auto order = [this](const Diagnostic& diagnostic) {
    const auto file = std::find(files.begin(), files.end(), diagnostic.place.file);
    return std::tuple(file - files.begin(), diagnostic.place.line, diagnostic.place.column);
  };
  std::stable_sort(list.begin(), list.end(),
                   [&](const Diagnostic& a, const Diagnostic& b) { return order(a) < order(b); });
}

bool Reader::FindFile(const Node& name, fs::path& path) {
  const auto text = name.String();
  if (!text) return Refuse(name, "the name of a file");
  const Place place = name.place();
  try {
    path = ConfinedPath(folders, fs::path(place.file).parent_path(), *text);
  } catch (const Error& error) {
    Report(error.diagnostics().front().message, place, error.diagnostics().front().hint);
    return false;
  }
  std::error_code ignored;
  if (fs::is_regular_file(path, ignored)) return true;
  const bool exists = fs::exists(path, ignored);
  Report(exists ? QuotedName(*text) + " is not a file" : "there is no file " + QuotedName(*text),
         place);
  return false;
}

std::string Printable(std::string_view name) {
  std::size_t length = std::min(name.size(), MaxQuoted);
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(name[i]); };
  while (length < name.size() && length > 0 && (byte(length) & 0xc0) == 0x80)
    --length;  // whole characters
  std::string text;
  for (std::size_t i = 0; i < length; ++i)
    text += byte(i) < 0x20 || byte(i) == 0x7f ? '?' : name[i];
  return length < name.size() ? text + "…" : text;
}

std::string QuotedName(std::string_view name) { return "'" + Printable(name) + "'"; }

std::string Suggestion(std::string_view name, const std::vector<std::string>& known) {
  return name.size() <= MaxQuoted ? DidYouMean(name, known) : "";
}

}  // namespace snell::io
