// SPDX-License-Identifier: Apache-2.0
#include "io/mesh/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include "io/mesh/text.h"
#include "util/text.h"

namespace snell::io {
namespace {

std::optional<PlyType> TypeOf(std::string_view name) {
  static constexpr std::pair<std::string_view, PlyType> Types[] = {
      {"char", PlyType::Int8},      {"int8", PlyType::Int8},       {"uchar", PlyType::Uint8},
      {"uint8", PlyType::Uint8},    {"short", PlyType::Int16},     {"int16", PlyType::Int16},
      {"ushort", PlyType::Uint16},  {"uint16", PlyType::Uint16},   {"int", PlyType::Int32},
      {"int32", PlyType::Int32},    {"uint", PlyType::Uint32},     {"uint32", PlyType::Uint32},
      {"float", PlyType::Float32},  {"float32", PlyType::Float32}, {"double", PlyType::Float64},
      {"float64", PlyType::Float64}};
  for (const auto& [word, type] : Types)
    if (word == name) return type;
  return std::nullopt;
}

// More is no mesh: elements, properties of one, and lines that are none of the format.
constexpr std::size_t MaxEntries = 1000;
constexpr int MaxUnknownLines = 16;

// Takes the header's lines one by one.
class HeaderReader {
 public:
  explicit HeaderReader(const MeshFile& file) : file_(file), scanner_(file.bytes) {}

  PlyHeader Read() {
    if (scanner_.RestOfLine() != "ply") Fail("not a PLY file: it does not begin with 'ply'");
    bool hasFormat = false;
    for (;;) {
      ++line_;
      if (scanner_.left() == 0) Fail("the header ends without 'end_header'");
      const std::string_view keyword = scanner_.WordOnLine();
      if (keyword == "end_header") break;
      if (keyword == "format") {
        ReadFormat();
        hasFormat = true;
      } else if (keyword == "element") {
        ReadElement();
      } else if (keyword == "property") {
        ReadProperty();
      } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
        SkipUnknown(keyword);
      }
      scanner_.RestOfLine();
    }
    if (!hasFormat) Fail("the header has no 'format' line");
    EndHeader();
    return std::move(header_);
  }

 private:
  void ReadFormat() {
    const std::string_view format = scanner_.WordOnLine();
    if (format == "ascii") {
      header_.encoding = PlyEncoding::Ascii;
    } else if (format == "binary_little_endian") {
      header_.encoding = PlyEncoding::LittleEndian;
    } else if (format == "binary_big_endian") {
      header_.encoding = PlyEncoding::BigEndian;
    } else {
      Fail("unknown format " + Quoted(format),
           "ascii, binary_little_endian and binary_big_endian are known");
    }
    if (const std::string_view version = scanner_.WordOnLine(); version != "1.0")
      Fail(fmt::format("unknown version {} of the format; 1.0 is known", Quoted(version)));
  }

  void ReadElement() {
    const std::string_view name = scanner_.WordOnLine();
    const std::string_view count = scanner_.WordOnLine();
    if (name.empty()) Fail("an element needs a name and a count");
    if (header_.elements.size() == MaxEntries) Fail("too many elements");
    if (header_.Find(name)) Fail("a second element " + Quoted(name));
    PlyElement element;
    element.name = name;
    element.line = line_;
    const char* end = count.data() + count.size();
    const auto [stop, fault] = std::from_chars(count.data(), end, element.count);
    if (fault != std::errc() || stop != end) Fail(Quoted(count) + " is no count of elements");
    header_.elements.push_back(std::move(element));
    FailAtMore();
  }

  void ReadProperty() {
    if (header_.elements.empty()) Fail("a property without an element before it");
    if (header_.elements.back().properties.size() == MaxEntries) Fail("too many properties");
    PlyProperty property;
    std::string_view type = scanner_.WordOnLine();
    if (type == "list") {
      property.isList = true;
      property.countType = ReadType(scanner_.WordOnLine());
      if (!IsInteger(property.countType)) Fail("the length of a list must have an integer type");
      type = scanner_.WordOnLine();
    }
    property.type = ReadType(type);
    property.name = scanner_.WordOnLine();
    if (property.name.empty()) Fail("a property needs a name");
    header_.elements.back().properties.push_back(std::move(property));
    FailAtMore();
  }

  void SkipUnknown(std::string_view keyword) {
    if (++unknownLines_ > MaxUnknownLines)
      Fail(fmt::format("unknown header line {}, and many others before", Quoted(keyword)));
    file_.Warn(fmt::format("unknown header line {} ignored", Quoted(keyword)), file_.AtLine(line_));
  }

  PlyType ReadType(std::string_view name) const {
    const std::optional<PlyType> type = TypeOf(name);
    if (!type) Fail("unknown type " + Quoted(name));
    return *type;
  }

  void FailAtMore() {
    if (const std::string_view more = scanner_.WordOnLine(); !more.empty())
      Fail(Quoted(more) + " is one word too many");
  }

  // Find where the body begins. Only a file whose lines end with carriage returns alone may have a first
  // byte that looks like the rest of a line end.
  void EndHeader() {
    scanner_.WordOnLine();
    const std::string_view bytes = file_.bytes;
    header_.size = scanner_.at();
    const bool oldMac = bytes.size() > 4 && bytes[3] == '\r' && bytes[4] != '\n';
    const std::string_view end = bytes.substr(header_.size, oldMac ? 1 : 2);
    if (!end.empty()) header_.size += end == "\r\n" ? 2 : 1;
    CheckCounts();
  }

  // Compare counts with the bytes that are left: each record takes some.
  void CheckCounts() const {
    const bool ascii = header_.encoding == PlyEncoding::Ascii;
    std::uint64_t left = file_.bytes.size() - header_.size + (ascii ? 1 : 0);
    for (const PlyElement& element : header_.elements) {
      std::uint64_t record = 0;
      for (const PlyProperty& property : element.properties)
        record += ascii ? 2 : SizeOf(property.isList ? property.countType : property.type);
      if (record == 0) continue;
      if (element.count > left / record)
        throw Error(fmt::format("the header promises {} elements {}, but there are only {} of data",
                                WithCommas(element.count), Quoted(element.name),
                                ByteSize(file_.bytes.size() - header_.size)),
                    file_.AtLine(element.line), "the file may be cut short");
      left -= element.count * record;
    }
  }

  [[noreturn]] void Fail(std::string message, std::string hint = "") const {
    throw Error(std::move(message), file_.AtLine(line_), std::move(hint));
  }

  const MeshFile& file_;
  TextScanner scanner_;
  PlyHeader header_;
  int line_ = 1;
  int unknownLines_ = 0;
};

}  // namespace

std::size_t SizeOf(PlyType type) {
  switch (type) {
    case PlyType::Int8:
    case PlyType::Uint8: return 1;
    case PlyType::Int16:
    case PlyType::Uint16: return 2;
    case PlyType::Int32:
    case PlyType::Uint32:
    case PlyType::Float32: return 4;
    case PlyType::Float64: break;
  }
  return 8;
}

int PlyElement::Find(std::initializer_list<std::string_view> names) const {
  for (std::size_t i = 0; i < properties.size(); ++i)
    if (std::find(names.begin(), names.end(), properties[i].name) != names.end()) return int(i);
  return -1;
}

const PlyElement* PlyHeader::Find(std::string_view element) const {
  for (const PlyElement& candidate : elements)
    if (candidate.name == element) return &candidate;
  return nullptr;
}

PlyHeader ReadPlyHeader(const MeshFile& file) { return HeaderReader(file).Read(); }

}  // namespace snell::io
