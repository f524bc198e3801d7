// SPDX-License-Identifier: Apache-2.0
#include "io/toml/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace snell::io {

Fields::Fields(std::string tableTitle, const Node& table)
    : title(std::move(tableTitle)), place(table.place()), entries(table.Entries()) {}

const Node::Entry* Fields::Find(std::string_view name) const {
  for (const Node::Entry& entry : entries)
    if (entry.name == name) return &entry;
  return nullptr;
}

Place Fields::PlaceOf(std::string_view name) const {
  const Node::Entry* entry = Find(name);
  return entry ? entry->value.place() : place;
}

namespace {

// Reads one table: chooses the variant, reads the keys, then sees whether they go together.
class TableReader {
 public:
  TableReader(Reader& reader, const Section& section, Fields fields)
      : reader_(reader), section_(section), fields_(std::move(fields)) {}

  bool Read(void* record) {
    const std::size_t before = reader_.findings();
    if (!ChooseVariant()) return false;
    if (variant_) fields_.title += fmt::format(" ({})", variant_->Title());
    if (variant_ && variant_->begin) variant_->begin(record);
    for (const Node::Entry& entry : fields_.entries) ReadKey(entry, record);
    for (const Either& either : section_.eithers) CheckEither(either);
    CheckRequired();
    if (reader_.findings() != before) return false;

    // Values that are good alone may still not go together
    if (section_.check) section_.check(reader_, fields_, record);
    if (variant_ && variant_->check) variant_->check(reader_, fields_, record);
    return reader_.findings() == before;
  }

 private:
  bool ChooseVariant() {
    if (section_.variants.empty()) return true;
    const Node::Entry* chosen = nullptr;
    for (const std::string& selector : Selectors()) {
      const Node::Entry* entry = fields_.Find(selector);
      if (entry && chosen) return ReportBoth(*chosen, *entry), false;
      if (entry) chosen = entry;
    }
    if (!chosen) return ChooseStandard();

    std::vector<std::string> names;
    for (const Variant& variant : section_.variants) {
      if (variant.selector != chosen->name) continue;
      if (variant.name.empty()) return variant_ = &variant, true;
      names.push_back(variant.name);
    }
    const KeyScope scope(reader_, chosen->name);
    const int index = ReadWord(reader_, chosen->value, names);
    for (const Variant& variant : section_.variants)
      if (index >= 0 && variant.name == names[std::size_t(index)]) variant_ = &variant;
    return index >= 0;
  }

  bool ChooseStandard() {
    for (const Variant& variant : section_.variants)
      for (const Key& key : variant.keys)
        if (key.tells && fields_.Find(key.name)) return variant_ = &variant, true;
    for (const Variant& variant : section_.variants)
      if (variant.name == section_.standard && !section_.standard.empty()) variant_ = &variant;
    if (variant_) return true;

    // A mistyped selector explains why there is none
    const std::vector<std::string> selectors = Selectors();
    for (const Node::Entry& entry : fields_.entries) {
      const std::string hint = Suggestion(entry.name, selectors);
      if (hint.empty() || !VariantsWith(entry.name).empty() || FindIn(section_.keys, entry.name))
        continue;
      reader_.Report(fmt::format("unknown key {} in {}", QuotedName(entry.name), fields_.title),
                     entry.place(), hint);
      return false;
    }
    reader_.Report(fmt::format("missing key {} in {}", OrList(selectors), fields_.title),
                   fields_.place,
                   selectors.size() == 1 ? "choose one of " + WordList(VariantNames()) : "");
    return false;
  }

  void ReadKey(const Node::Entry& entry, void* record) {
    const Key* key = FindIn(section_.keys, entry.name);
    if (!key && variant_) key = FindIn(variant_->keys, entry.name);
    const bool isSelector = variant_ && entry.name == variant_->selector;
    if (!key && !isSelector) return ReportUnknown(entry);
    if (!key || !key->read) return;
    const KeyScope scope(reader_, key->name);
    key->read(reader_, entry.value, record);
  }

  void CheckEither(const Either& either) {
    const Node::Entry* first = nullptr;
    const std::vector<std::string>* firstSide = nullptr;
    std::vector<std::string> all;
    for (const auto& side : either.sides) {
      all.insert(all.end(), side.begin(), side.end());
      for (const std::string& name : side) {
        const Node::Entry* entry = fields_.Find(name);
        if (!entry) continue;
        if (first && firstSide != &side) return ReportBoth(*first, *entry);
        first = entry;
        firstSide = &side;
      }
    }
    if (either.required && !first)
      reader_.Report(fmt::format("missing key {} in {}", OrList(all), fields_.title),
                     fields_.place);
  }

  void CheckRequired() {
    const auto check = [this](const std::vector<Key>& keys) {
      for (const Key& key : keys)
        if (key.required && !fields_.Find(key.name) && !HasMistakeFor(key))
          reader_.Report(fmt::format("missing key '{}' in {}", key.name, fields_.title),
                         fields_.place);
    };
    check(section_.keys);
    if (variant_) check(variant_->keys);
  }

  // Whether the required key seems to be there under a wrong name, which has been reported.
  bool HasMistakeFor(const Key& key) const {
    return std::any_of(fields_.entries.begin(), fields_.entries.end(),
                       [&](const Node::Entry& entry) {
                         if (VisibleNames(entry.name)) return false;
                         const auto& words = key.mistakes;
                         return std::find(words.begin(), words.end(), entry.name) != words.end() ||
                                !Suggestion(entry.name, {key.name}).empty();
                       });
  }

  // Both are of this table's entries, which are in the order of the files.
  void ReportBoth(const Node::Entry& one, const Node::Entry& other) {
    const auto [a, b] =
        std::minmax(one, other, [](const auto& x, const auto& y) { return &x < &y; });
    reader_.Report(
        fmt::format("'{}' and '{}' exclude each other in {}", a.name, b.name, fields_.title),
        b.place());
  }

  void ReportUnknown(const Node::Entry& entry) {
    reader_.Report(fmt::format("unknown key {} in {}", QuotedName(entry.name), fields_.title),
                   entry.place(), HintFor(entry.name));
  }

  // What the writer of an unknown key may have meant.
  std::string HintFor(std::string_view name) const {
    std::vector<std::string> known;
    std::string meant;
    const auto collect = [&](const std::vector<Key>& keys) {
      for (const Key& key : keys) {
        known.push_back(key.name);
        const auto& words = key.mistakes;
        const bool matches = std::find(words.begin(), words.end(), name) != words.end();
        if (matches && meant.empty()) meant = key.name;
      }
    };
    if (variant_) collect(variant_->keys);
    collect(section_.keys);
    if (!meant.empty()) return fmt::format("did you mean '{}'?", meant);
    const std::vector<std::string> others = VariantsWith(name);
    if (!others.empty()) return fmt::format("it belongs to {}", OrList(others, false));
    for (const std::string& selector : Selectors()) known.push_back(selector);
    return Suggestion(name, known);
  }

  bool VisibleNames(std::string_view name) const {
    return FindIn(section_.keys, name) || (variant_ && FindIn(variant_->keys, name));
  }

  static const Key* FindIn(const std::vector<Key>& keys, std::string_view name) {
    const auto found =
        std::find_if(keys.begin(), keys.end(), [&](const Key& key) { return key.name == name; });
    return found == keys.end() ? nullptr : &*found;
  }

  // The variants that have the key, as a file chooses them.
  std::vector<std::string> VariantsWith(std::string_view name) const {
    std::vector<std::string> choices;
    for (const Variant& variant : section_.variants) {
      if (!FindIn(variant.keys, name)) continue;
      choices.push_back(variant.name.empty() ? InQuotes(variant.selector)
                                             : variant.selector + " " + InQuotes(variant.name));
    }
    return choices;
  }

  std::vector<std::string> VariantNames() const {
    std::vector<std::string> names;
    for (const Variant& variant : section_.variants) names.push_back(variant.name);
    return names;
  }

  std::vector<std::string> Selectors() const {
    std::vector<std::string> selectors;
    for (const Variant& variant : section_.variants)
      if (std::find(selectors.begin(), selectors.end(), variant.selector) == selectors.end())
        selectors.push_back(variant.selector);
    return selectors;
  }

  static std::string OrList(const std::vector<std::string>& words, bool quoted = true) {
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (i > 0) list += i + 1 < words.size() ? ", " : " or ";
      list += quoted ? "'" + words[i] + "'" : words[i];
    }
    return list;
  }

  Reader& reader_;
  const Section& section_;
  Fields fields_;  // with the variant in its title
  const Variant* variant_ = nullptr;
};

}  // namespace

bool ReadFields(Reader& reader, const Section& section, const Fields& fields, void* record) {
  return TableReader(reader, section, fields).Read(record);
}

void MergeUnder(const Section& section, const Fields& under, Fields& fields) {
  std::set<std::string_view> given;
  for (const Node::Entry& entry : fields.entries) given.insert(entry.name);
  const auto anyGiven = [&](const std::vector<std::string>& side) {
    return std::any_of(side.begin(), side.end(),
                       [&](const auto& name) { return given.contains(name); });
  };
  const auto excluded = [&](std::string_view name) {
    for (const Either& either : section.eithers) {
      const auto holds = [&](const auto& side) {
        return std::find(side.begin(), side.end(), name) != side.end();
      };
      if (std::none_of(either.sides.begin(), either.sides.end(), holds)) continue;
      for (const auto& side : either.sides)
        if (!holds(side) && anyGiven(side)) return true;
    }
    return false;
  };
  for (const Node::Entry& entry : under.entries)
    if (!given.contains(entry.name) && !excluded(entry.name)) fields.entries.push_back(entry);
}

std::string DefaultOf(const Section& section, const Variant* variant, const Key& key) {
  if (!key.write) return "";
  const std::shared_ptr<void> record = section.make();
  if (variant && variant->begin) variant->begin(record.get());
  return key.write(record.get());
}

}  // namespace snell::io
