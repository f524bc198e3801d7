// SPDX-License-Identifier: Apache-2.0
//
// The header of a PLY file: which elements follow, and what each record of them is made of. Format: Greg
// Turk 1994, "The PLY polygon file format".
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "io/mesh/readers.h"

namespace snell::io {

enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

// In bytes, in the binary encodings.
std::size_t SizeOf(PlyType type);
inline bool IsInteger(PlyType type) { return type < PlyType::Float32; }

enum class PlyEncoding { Ascii, LittleEndian, BigEndian };

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float32;  // of the number, or of each in the list
  bool isList = false;
  PlyType countType = PlyType::Uint8;  // of a list's length; an integer
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
  int line = 0;  // of the header

  // The number of the first property that has one of these names, or -1.
  int Find(std::initializer_list<std::string_view> names) const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::vector<PlyElement> elements;  // in the order in which they follow
  std::size_t size = 0;              // in bytes; the body follows

  const PlyElement* Find(std::string_view element) const;
};

// Throws Error, with the line, if the header is malformed or if it promises more elements than the bytes
// after it can hold. Warns of lines that it does not understand.
PlyHeader ReadPlyHeader(const MeshFile& file);

}  // namespace snell::io
