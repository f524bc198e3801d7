// SPDX-License-Identifier: Apache-2.0
//
// Where the numbers of a PLY file's body come from: bytes or words. Both have the same functions, and
// ply.cpp is written once for either of them. Every number is a double, which holds all of the
// format's types exactly. Faults throw Error with the byte or the line.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>

#include "io/mesh/ply_header.h"
#include "io/mesh/readers.h"
#include "io/mesh/text.h"

namespace snell::io {

// Numbers in binary; `Swapped` if their bytes are not in this machine's order.
template <bool Swapped>
class PlyBytes {
 public:
  PlyBytes(const MeshFile& file, std::size_t begin) : file_(file), at_(begin) {}

  double Number(PlyType type) {
    switch (type) {
      case PlyType::Int8: return double(Take<std::int8_t>());
      case PlyType::Uint8: return double(Take<std::uint8_t>());
      case PlyType::Int16: return double(Take<std::int16_t>());
      case PlyType::Uint16: return double(Take<std::uint16_t>());
      case PlyType::Int32: return double(Take<std::int32_t>());
      case PlyType::Uint32: return double(Take<std::uint32_t>());
      case PlyType::Float32: return double(Take<float>());
      case PlyType::Float64: break;
    }
    return Take<double>();
  }

  void Skip(PlyType type, std::uint64_t count) {
    Need(count * SizeOf(type));
    at_ += count * SizeOf(type);
  }

  void EndRecord() {}
  // Fail unless `count` numbers may follow.
  void ExpectNumbers(PlyType type, std::uint64_t count) const { Need(count * SizeOf(type)); }
  std::size_t left() const { return file_.bytes.size() - at_; }

  [[noreturn]] void Fail(std::string message, std::string hint = "") const {
    throw Error(std::move(message), file_.AtByte(at_), std::move(hint));
  }

 private:
  void Need(std::uint64_t bytes) const {
    if (bytes > left()) Fail("the file ends within its data", "it may be cut short");
  }

  template <class T>
  T Take() {
    Need(sizeof(T));
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), file_.bytes.data() + at_, sizeof(T));
    at_ += sizeof(T);
    if constexpr (Swapped) std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<T>(bytes);
  }

  const MeshFile& file_;
  std::size_t at_;
};

// Numbers as words. A record ends with a line; it may take several.
class PlyWords {
 public:
  PlyWords(const MeshFile& file, std::size_t begin) : file_(file), scanner_(file.bytes, begin) {}

  double Number(PlyType) {
    const std::string_view word = Word();
    double value = 0;
    if (!ParseNumber(word, value)) Fail(Quoted(word) + " is not a number");
    return value;
  }

  void Skip(PlyType, std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) Word();
  }

  void EndRecord() {
    if (const std::string_view more = scanner_.WordOnLine(); !more.empty())
      Fail(Quoted(more) + " is more than the line should hold");
  }

  void ExpectNumbers(PlyType, std::uint64_t count) const {
    if (count > (left() + 1) / 2) Fail("the file ends within its data", "it may be cut short");
  }
  std::size_t left() const { return scanner_.left(); }

  [[noreturn]] void Fail(std::string message, std::string hint = "") const {
    throw Error(std::move(message), file_.AtLine(scanner_.Line()), std::move(hint));
  }

 private:
  std::string_view Word() {
    const std::string_view word = scanner_.Word();
    if (word.empty()) Fail("the file ends within its data", "it may be cut short");
    return word;
  }

  const MeshFile& file_;
  TextScanner scanner_;
};

}  // namespace snell::io
