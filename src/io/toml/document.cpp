// SPDX-License-Identifier: Apache-2.0
#include "io/toml/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "io/toml/limits.h"
#include "io/toml/sections.h"
#include "util/file.h"

namespace snell::io {

namespace fs = std::filesystem;

std::vector<Fields> TablesOf(Reader& reader, const std::string& title, const Node::Entry* list) {
  std::vector<Fields> tables;
  if (!list) return tables;
  const auto refuse = [&](const Node& value) {
    reader.Report(fmt::format("'{}': expected tables, found {}", list->name, value.Description()),
                  value.place());
  };
  if (list->value.IsTable()) {
    reader.Report(fmt::format("there may be several of '{}': write {} with double brackets",
                              list->name, title),
                  list->value.place());
  } else if (!list->value.IsArray()) {
    refuse(list->value);
  }
  tables.reserve(list->value.size());
  for (std::size_t i = 0; i < list->value.size(); ++i) {
    if (list->value[i].IsTable())
      tables.emplace_back(title, list->value[i]);
    else
      refuse(list->value[i]);
  }
  return tables;
}

void ReportUnknownKey(Reader& reader, const Section& section, const Node::Entry& entry,
                      const std::string& title) {
  std::vector<std::string> known;
  std::string hint;
  for (const Key& key : section.keys) {
    known.push_back(key.name);
    if (std::find(key.mistakes.begin(), key.mistakes.end(), entry.name) != key.mistakes.end())
      hint = fmt::format("did you mean '{}'?", key.name);
  }

  // A key that has slipped out of its table
  for (const Section* other : {static_cast<const Section*>(&RenderSection()),
                               static_cast<const Section*>(&CameraSection())})
    for (const Key& key : other->keys)
      if (hint.empty() && key.name == entry.name)
        hint = fmt::format("it belongs in {}", other->title);
  reader.Report(fmt::format("unknown key {} in {}", QuotedName(entry.name), title), entry.place(),
                hint.empty() ? Suggestion(entry.name, known) : hint);
}

namespace {

// Reads files in the order main file, its first include with all of that's includes, and so on.
class DocumentReader {
 public:
  explicit DocumentReader(Reader& reader) : reader_(reader) {}

  void AddFile(const fs::path& path) {
    const std::string text =
        ReadWithin(path, reader_.limits, &ReadLimits::tomlBytes, reader_.inclusion->bytes);
    reader_.inclusion->bytes += text.size();
    reader_.files.push_back(path.string());
    document.files.push_back(ParseToml(text, path.string()));
    const Fields file("the scene file", Node(document.files.back().get()));
    Collect(file);
    if (const Node::Entry* include = file.Find("include")) {
      open_.push_back(Real(path));
      ReadIncludes(include->value);
      open_.pop_back();
    }
  }

  Document document;

 private:
  static std::string Real(const fs::path& path) {
    std::error_code ignored;
    return fs::weakly_canonical(path, ignored).string();
  }

  // --- Includes

  void ReadIncludes(const Node& include) {
    const KeyScope scope(reader_, "include");
    if (include.String()) return ReadInclude(include);
    if (!include.IsArray()) {
      reader_.Refuse(include, "a file name or a list of file names");
      return;
    }
    for (std::size_t i = 0; i < include.size(); ++i) ReadInclude(include[i]);
  }

  void ReadInclude(const Node& name) {
    fs::path path;
    if (!reader_.FindFile(name, path)) {
      reader_.filesMissing = true;
      return;
    }
    const std::string real = Real(path);
    if (std::find(open_.begin(), open_.end(), real) != open_.end()) {
      reader_.Report(fmt::format("{} includes itself", QuotedName(*name.String())), name.place(),
                     Chain(real));
    } else if (open_.size() > MaxIncludeDepth) {
      reader_.Report(fmt::format("files are included more than {} deep", MaxIncludeDepth),
                     name.place());
      reader_.filesMissing = true;
    } else if (done_.insert(real).second) {
      try {
        AddFile(path);
      } catch (const Error& error) {
        ReportFileError(error, name.place());
      }
    }
  }

  // A syntax error stands at its own place, a file that cannot be read where it is named.
  void ReportFileError(const Error& error, const Place& includePlace) {
    reader_.filesMissing = true;
    for (const Diagnostic& cause : error.diagnostics()) {
      const bool hasPlace = cause.place.line > 0;
      reader_.Report(hasPlace
                         ? cause.message
                         : fmt::format("cannot include {}: {}", cause.place.file, cause.message),
                     hasPlace ? cause.place : includePlace, cause.hint);
    }
  }

  // "through a.toml, b.toml" for files between the first opening of `real` and now.
  std::string Chain(const std::string& real) const {
    std::string chain;
    for (auto file = std::find(open_.begin(), open_.end(), real) + 1; file != open_.end(); ++file)
      chain += (chain.empty() ? "through " : ", ") + fs::path(*file).filename().string();
    return chain;
  }

  // --- Tables

  void Collect(const Fields& file) {
    for (const Node::Entry& entry : file.entries) {
      const auto& name = entry.name;
      const auto list = [&] { return TablesOf(reader_, fmt::format("[[{}]]", name), &entry); };
      if (name == "render") {
        Merge(RenderSection(), entry, document.render);
      } else if (name == "environment") {
        Merge(EnvironmentSection(), entry, document.environment);
      } else if (name == "camera") {
        CollectCameras(entry);
      } else if (name == "light") {
        Append(document.lights, list());
      } else if (name == "object") {
        Append(document.objects, list());
      } else if (name == "group") {
        CollectNamed(entry, document.groups);
      } else if (name == "material") {
        CollectNamed(entry, document.materials);
      } else if (name == "texture") {
        CollectNamed(entry, document.textures);
      } else if (name != "include") {
        ReportUnknownKey(reader_, FileSection(), entry, file.title);
      }
    }
  }

  static void Append(std::vector<Fields>& list, std::vector<Fields> more) {
    list.insert(list.end(), std::make_move_iterator(more.begin()),
                std::make_move_iterator(more.end()));
  }

  void Merge(const Section& section, const Node::Entry& entry, Fields& fields) {
    if (entry.value.IsTable()) {
      const Fields more(section.title, entry.value);
      if (fields.title.empty())
        fields = more;
      else
        MergeUnder(section, more, fields);
    } else if (entry.value.IsArray()) {
      reader_.Report(fmt::format("there is only one '{}': write [{}] with single brackets",
                                 entry.name, entry.name),
                     entry.value.place());
    } else {
      reader_.Report(
          fmt::format("'{}': expected a table, found {}", entry.name, entry.value.Description()),
          entry.value.place());
    }
  }

  // Single cameras of several files are the same camera; those of lists are cameras of their own.
  void CollectCameras(const Node::Entry& entry) {
    if (entry.value.IsArray())
      return Append(document.cameras, TablesOf(reader_, "[[camera]]", &entry));
    const bool isFirst = !hasSingleCamera_;
    hasSingleCamera_ |= entry.value.IsTable();
    if (isFirst && hasSingleCamera_) document.cameras.insert(document.cameras.begin(), Fields());
    Fields none;
    Merge(CameraSection(), entry, hasSingleCamera_ ? document.cameras.front() : none);
  }

  void CollectNamed(const Node::Entry& tables, std::vector<NamedFields>& list) {
    if (!tables.value.IsTable()) {
      reader_.Report(fmt::format("'{}': expected tables by name, found {}", tables.name,
                                 tables.value.Description()),
                     tables.value.place(), fmt::format("write [{}.NAME]", tables.name));
      return;
    }
    for (const Node::Entry& entry : tables.value.Entries()) {
      const std::string title = fmt::format("[{}.{}]", tables.name, Printable(entry.name));
      if (!entry.value.IsTable()) {
        reader_.Report(fmt::format("{}: expected a table, found {}", QuotedName(entry.name),
                                   entry.value.Description()),
                       entry.value.place(), fmt::format("write [{}.NAME]", tables.name));
        continue;
      }
      const auto [first, isNew] = places_.emplace(
          std::pair(std::string(tables.name), std::string(entry.name)), entry.place());
      if (isNew)
        list.push_back({std::string(entry.name), Fields(title, entry.value)});
      else
        reader_.Report(fmt::format("{} is defined twice", title), entry.place(),
                       fmt::format("the first is at {}", ToString(first->second)));
    }
  }

  Reader& reader_;
  std::vector<std::string> open_;
  std::set<std::string> done_;
  bool hasSingleCamera_ = false;
  std::map<std::pair<std::string, std::string>, Place> places_;  // of names
};

}  // namespace

Document ReadDocument(Reader& reader, const fs::path& sceneFile) {
  DocumentReader document(reader);
  document.AddFile(sceneFile);
  return std::move(document.document);
}

}  // namespace snell::io
