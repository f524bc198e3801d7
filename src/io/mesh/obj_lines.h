// SPDX-License-Identifier: Apache-2.0
//
// The lines of an OBJ file as tinyobjloader gets to see them: one statement at a time, and only vertices,
// normals, texture coordinates and faces. tinyobjloader reads what is no number as 0, lets large indices
// wrap around, knows no continued lines and tells no line numbers; so every statement is checked here
// before it is handed on, and line() says where it stands. Syntax: Wavefront's Advanced Visualizer manual,
// appendix B1.
#pragma once

#include <array>
#include <cstdint>
#include <streambuf>
#include <string>
#include <string_view>

#include "io/mesh/readers.h"
#include "io/obj/parts.h"

namespace snell::io {

// What a file may hold that does not become part of the mesh.
enum class ObjExtra { Points, Lines, FreeForm, ShortFaces, Unknown, Count };

// What can be wrong with a face's corner.
enum class IndexFault { None, Syntax, Zero, TooLarge };

class ObjLines : public std::streambuf {
 public:
  // Reads the file's bytes in place and changes blanks and line ends in them. Words that hold for the faces
  // that follow go to `parts`.
  ObjLines(MeshFile& file, ObjParts& parts);

  // The line that the current statement begins on.
  int line() const { return line_; }
  // Whether number 0, 1 or 2 of the current statement is infinite or undefined.
  bool IsUndefined(int number) const { return undefined_[std::size_t(number)]; }
  // Whether the current statement is a vertex with a color, and the color as it stands in the file.
  bool HasColor() const { return hasColor_; }
  const scene::vec3& color() const { return color_; }

  // How many statements, and the first one's line and keyword.
  struct Tally {
    std::uint64_t count = 0;
    int line = 0;
    std::string keyword;
  };
  const Tally& Of(ObjExtra extra) const { return tallies_[std::size_t(extra)]; }

 protected:
  // Make the next statement readable. Throws Error if it is malformed.
  int_type underflow() override;

 private:
  char* TakeLine(char* begin);
  bool Accept(char* begin, char* end);
  int CheckNumbers(char* begin, char* end);
  bool CheckFace(char* begin, char* end);
  void NoteState(std::string_view keyword, std::string_view rest);
  void NoteSmoothing(std::string_view word);
  bool Skip(ObjExtra extra, std::string_view keyword);
  [[noreturn]] void FailCorner(IndexFault fault, std::string_view word) const;
  [[noreturn]] void Fail(std::string message, std::string hint = "") const;

  const MeshFile& file_;
  ObjParts& parts_;
  char* next_;  // where the next line begins
  char* end_;
  int line_ = 0;
  int nextLine_ = 1;
  std::array<bool, 3> undefined_ = {};
  bool hasColor_ = false;
  scene::vec3 color_{0.0f};
  std::array<Tally, std::size_t(ObjExtra::Count)> tallies_;
};

}  // namespace snell::io
