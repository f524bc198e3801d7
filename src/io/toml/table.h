// SPDX-License-Identifier: Apache-2.0
//
// The vocabulary in which the scene language is written down, once: a Section says what a TOML table may
// hold, a Variant what it holds when `shape`, `type` or a telling key has chosen one, a Key what a value
// means. The parser (ReadTable), the reference page and the JSON Schema are all made from these records;
// the toml_section_*.cpp files hold them.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/toml/reader.h"
#include "io/toml/types.h"

namespace snell::io {

// One key of a table: what people and editors are told, and how its value gets into the record.
struct Key {
  std::string name;
  std::string expected;  // "a number > 0"
  std::string unit;
  std::string schema;   // JSON Schema of the values
  std::string text;     // one sentence
  std::string example;  // a value in TOML, never the default's text alone if that tells nothing
  std::string
      standard;  // in words, where the record's default does not tell what happens without the key
  bool required = false;
  bool tells = false;                 // its presence chooses its variant where no selector does
  std::vector<std::string> mistakes;  // what people write who mean this key

  // Read a value into the record; false: reported. Null for keys that the table's reader takes itself.
  std::function<bool(Reader&, const Node&, void*)> read;
  // The record's value as TOML, "" for none: shows the default.
  std::function<std::string(const void*)> write;
};

// Keys of which only one side may be given.
struct Either {
  std::vector<std::vector<std::string>> sides;
  bool required = false;  // and one must
};

// A table as the files give it: its keys, in order, and what messages call it.
struct Fields {
  std::string title;  // "[[object]] (sphere)"
  Place place;
  std::vector<Node::Entry> entries;

  Fields() = default;
  Fields(std::string tableTitle, const Node& table);

  const Node::Entry* Find(std::string_view name) const;

  // Where the value of `name` stands, or the table if it has none.
  Place PlaceOf(std::string_view name) const;
};

using Check = std::function<void(Reader&, const Fields&, void*)>;

// One kind of a table, chosen by the value of its selector key, or by that key's presence if `name` is "".
struct Variant {
  std::string selector;  // "shape"
  std::string name;      // "sphere"
  std::string text;
  std::vector<Key> keys;
  std::function<void(void*)> begin;  // sets the record's defaults
  Check check;                       // of the record, when all values are good

  const std::string& Title() const { return name.empty() ? selector : name; }
};

struct Section {
  std::string name;   // "object": of its definition in the schema
  std::string title;  // "[[object]]"
  std::string text;
  std::vector<Key> keys;  // of all variants
  std::vector<Variant> variants;
  std::string standard;  // the variant without a selector; "": one must be chosen
  std::string base;      // a key that brings further keys, also the selector: "preset"
  std::vector<Either> eithers;
  Check check;
  std::function<std::shared_ptr<void>()> make;  // a record with its defaults
};

// Read a table into a record by its section. False: something is wrong and has been reported.
bool ReadFields(Reader& reader, const Section& section, const Fields& fields, void* record);

// Add those entries of `under` that `fields` does not have and does not exclude.
void MergeUnder(const Section& section, const Fields& under, Fields& fields);

// The default of a key as TOML, in the record that a variant (or null) begins with; "" for none.
std::string DefaultOf(const Section& section, const Variant* variant, const Key& key);

// --- Writing sections down: the same records with the type of what they fill --------------------------------

template <class Record>
struct KeyOf : Key {
  KeyOf Required() && { return required = true, std::move(*this); }
  KeyOf Tells() && { return tells = true, std::move(*this); }
  KeyOf Example(std::string toml) && { return example = std::move(toml), std::move(*this); }
  KeyOf Standard(std::string words) && { return standard = std::move(words), std::move(*this); }
  KeyOf Not(std::vector<std::string> words) && {
    return mistakes = std::move(words), std::move(*this);
  }
};

template <class Record>
using Keys = std::vector<KeyOf<Record>>;

// A key whose value goes where `at` points to in the record. `At` maps a Record& to a T&.
template <class Record, class T, class At>
KeyOf<Record> FieldAt(std::string name, At at, Type<T> type, std::string text) {
  KeyOf<Record> key;
  key.name = std::move(name);
  key.expected = type.expected;
  key.unit = type.unit;
  key.schema = type.schema;
  key.text = std::move(text);
  key.example = type.example;
  key.read = [at, read = type.read](Reader& reader, const Node& value, void* record) {
    return read(reader, value, at(*static_cast<Record*>(record)));
  };
  key.write = [at, write = type.write](const void* record) {
    return write ? write(at(*static_cast<Record*>(const_cast<void*>(record)))) : "";
  };
  return key;
}

template <class Record, class T>
KeyOf<Record> Field(std::string name, T Record::*member, Type<T> type, std::string text) {
  const auto at = [member](Record& record) -> T& { return record.*member; };
  return FieldAt<Record, T>(std::move(name), at, std::move(type), std::move(text));
}

// A key without which the member stays empty.
template <class Record, class T>
KeyOf<Record> Field(std::string name, std::optional<T> Record::*member, Type<T> type,
                    std::string text) {
  const auto at = [member](Record& record) -> T& {
    return record.*member ? *(record.*member) : (record.*member).emplace();
  };
  KeyOf<Record> key = FieldAt<Record, T>(std::move(name), at, std::move(type), std::move(text));
  key.write = nullptr;
  return key;
}

// The keys of an inner record as keys of the record that it is part of. `At` maps an Outer& to an Inner&.
template <class Outer, class Inner, class At>
Keys<Outer> Within(At at, const Keys<Inner>& inner) {
  Keys<Outer> keys;
  for (const KeyOf<Inner>& key : inner) {
    KeyOf<Outer> outer;
    static_cast<Key&>(outer) = key;
    outer.read = [at, read = key.read](Reader& reader, const Node& value, void* record) {
      return read(reader, value, &at(*static_cast<Outer*>(record)));
    };
    if (key.write)
      outer.write = [at, write = key.write](const void* record) {
        return write(&at(*static_cast<Outer*>(const_cast<void*>(record))));
      };
    keys.push_back(std::move(outer));
  }
  return keys;
}

template <class Outer, class Inner>
Keys<Outer> Within(Inner Outer::*member, const Keys<Inner>& inner) {
  return Within<Outer, Inner>([member](Outer& outer) -> Inner& { return outer.*member; }, inner);
}

// One list of keys from several.
template <class Record>
Keys<Record> Join(std::initializer_list<Keys<Record>> lists) {
  Keys<Record> keys;
  for (const Keys<Record>& list : lists) keys.insert(keys.end(), list.begin(), list.end());
  return keys;
}

template <class Record>
Check CheckOf(void (*check)(Reader&, const Fields&, Record&)) {
  if (!check) return nullptr;
  return [check](Reader& reader, const Fields& fields, void* record) {
    check(reader, fields, *static_cast<Record*>(record));
  };
}

template <class Record>
struct VariantOf : Variant {
  VariantOf(std::string variantName, std::string variantText, const Keys<Record>& variantKeys) {
    name = std::move(variantName);
    text = std::move(variantText);
    keys.assign(variantKeys.begin(), variantKeys.end());
  }
  VariantOf Begin(void (*set)(Record&)) && {
    begin = [set](void* record) { set(*static_cast<Record*>(record)); };
    return std::move(*this);
  }
  VariantOf Checked(void (*function)(Reader&, const Fields&, Record&)) && {
    check = CheckOf<Record>(function);
    return std::move(*this);
  }
  // Chosen by the presence of the key `name`.
  VariantOf ByPresence() && {
    selector = std::exchange(name, "");
    return std::move(*this);
  }
};

template <class Record>
struct SectionOf : Section {
  SectionOf(std::string sectionName, std::string sectionTitle, std::string sectionText,
            const Keys<Record>& sectionKeys) {
    name = std::move(sectionName);
    title = std::move(sectionTitle);
    text = std::move(sectionText);
    keys.assign(sectionKeys.begin(), sectionKeys.end());
    make = [] { return std::static_pointer_cast<void>(std::make_shared<Record>()); };
  }

  // The variants, chosen by the key `selector`; `standardName` is the one without it.
  SectionOf Variants(const std::string& selector, std::vector<VariantOf<Record>> list,
                     std::string standardName = "") && {
    for (VariantOf<Record>& variant : list) {
      if (variant.selector.empty()) variant.selector = selector;
      variants.push_back(std::move(variant));
    }
    standard = std::move(standardName);
    return std::move(*this);
  }
  SectionOf OnlyOne(std::vector<std::vector<std::string>> sides, bool oneRequired = false) && {
    eithers.push_back({std::move(sides), oneRequired});
    return std::move(*this);
  }
  SectionOf Base(std::string key) && { return base = std::move(key), std::move(*this); }
  SectionOf Checked(void (*function)(Reader&, const Fields&, Record&)) && {
    check = CheckOf<Record>(function);
    return std::move(*this);
  }
};

template <class Record>
bool ReadTable(Reader& reader, const SectionOf<Record>& section, const Fields& fields,
               Record& record) {
  return ReadFields(reader, section, fields, &record);
}

// A value that is a table of its own.
template <class Record>
Type<Record> TableOf(const SectionOf<Record>& (*section)(), std::string expected) {
  Type<Record> type;
  type.expected = expected;
  type.schema = "{\"$ref\": \"#/definitions/" + section().name + "\"}";
  type.read = [section, expected](Reader& reader, const Node& value, Record& record) {
    if (!value.IsTable()) return reader.Refuse(value, expected);
    return ReadTable(reader, section(), Fields(section().title, value), record);
  };
  return type;
}

}  // namespace snell::io
