// SPDX-License-Identifier: Apache-2.0
#include "io/mesh/obj_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <system_error>
#include <utility>

#include "io/mesh/text.h"

namespace snell::io {
namespace {

bool IsOneOf(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

const char* SkipDigits(const char* at, const char* end) {
  while (at < end && *at >= '0' && *at <= '9') ++at;
  return at;
}

// Whether tinyobjloader reads the word as the number that it is: [±] digits [. digits] [e [±] digits].
bool IsPlainNumber(std::string_view word) {
  const char *at = word.data(), *end = at + word.size();
  if (at < end && (*at == '-' || *at == '+')) ++at;
  const char* whole = at;
  at = SkipDigits(at, end);
  std::ptrdiff_t digits = at - whole;
  if (at < end && *at == '.') {
    const char* fraction = ++at;
    at = SkipDigits(at, end);
    digits += at - fraction;
  }
  if (digits == 0) return false;
  if (at == end || (*at != 'e' && *at != 'E')) return at == end;

  ++at;
  if (at < end && (*at == '-' || *at == '+')) ++at;
  const char* exponent = at;
  at = SkipDigits(at, end);
  return at == end && at > exponent && at - exponent <= 8;
}

// Check one index at `at`, which may be absent if it is not the first, and step over it.
IndexFault CheckIndex(const char*& at, const char* end, bool optional) {
  const char* begin = at;
  if (at < end && *at == '-') ++at;
  const char* digits = at;
  std::int64_t value = 0;
  for (; at < end && *at >= '0' && *at <= '9'; ++at)
    value = std::min<std::int64_t>(value * 10 + (*at - '0'), std::int64_t(1) << 40);
  if (at == digits) return optional && at == begin ? IndexFault::None : IndexFault::Syntax;
  if (value == 0) return IndexFault::Zero;
  return value > std::numeric_limits<int>::max() ? IndexFault::TooLarge : IndexFault::None;
}

// Check a corner: position[/[uv][/[normal]]].
IndexFault CheckCorner(std::string_view word) {
  const char *at = word.data(), *end = at + word.size();
  IndexFault fault = CheckIndex(at, end, false);
  for (int i = 0; i < 2 && fault == IndexFault::None && at < end && *at == '/'; ++i)
    fault = CheckIndex(++at, end, true);
  return fault == IndexFault::None && at != end ? IndexFault::Syntax : fault;
}

}  // namespace

ObjLines::ObjLines(MeshFile& file, ObjParts& parts) : file_(file), parts_(parts) {
  MakeUtf8(file.bytes, file.name);
  next_ = file.bytes.data();
  end_ = next_ + file.bytes.size();
  if (std::string_view(file.bytes).starts_with("\xef\xbb\xbf")) next_ += 3;

  // Carriage returns alone were the line ends of old Macs
  for (char* at = next_; (at = static_cast<char*>(std::memchr(at, '\r', std::size_t(end_ - at))));
       ++at)
    if (at + 1 == end_ || at[1] != '\n') *at = '\n';
}

ObjLines::int_type ObjLines::underflow() {
  while (next_ < end_) {
    char* begin = next_;
    char* end = TakeLine(begin);
    while (begin < end && IsBlank(*begin)) ++begin;
    if (begin == end || *begin == '#' || !Accept(begin, end)) continue;
    setg(begin, begin, next_);
    return traits_type::to_int_type(*begin);
  }
  return traits_type::eof();
}

// The end of the line that begins here, without its line end, which is stepped over. Lines continued by a
// backslash are joined, except for comments, where it is more likely the end of a Windows path.
char* ObjLines::TakeLine(char* begin) {
  line_ = nextLine_;
  const bool comment = *std::find_if_not(begin, end_ - 1, IsBlank) == '#';
  for (char* from = begin;;) {
    char* newline = static_cast<char*>(std::memchr(from, '\n', std::size_t(end_ - from)));
    char* end = newline ? newline : end_;
    next_ = newline ? newline + 1 : end_;
    ++nextLine_;
    if (end > begin && end[-1] == '\r') --end;
    if (comment || !newline || end == begin || end[-1] != '\\') return end;
    std::fill(end - 1, next_, ' ');
    from = next_;
  }
}

// Whether tinyobjloader is to read the statement.
bool ObjLines::Accept(char* begin, char* end) {
  TextScanner scanner(std::string_view(begin, std::size_t(end - begin)));
  const std::string_view keyword = scanner.WordOnLine();
  char* rest = begin + keyword.size();

  if (keyword == "v" || keyword == "vn") {
    const int count = CheckNumbers(rest, end);
    if (count < 3)
      Fail(fmt::format("'{}' needs three numbers, not {}", keyword, count),
           "the file may be cut short");
    return true;
  }
  if (keyword == "vt") {
    if (CheckNumbers(rest, end) < 1) Fail("'vt' needs at least one number");
    return true;
  }
  if (keyword == "f") return CheckFace(rest, end);

  if (IsOneOf(keyword, {"o", "g", "s", "usemtl", "mtllib"})) {
    NoteState(keyword, scanner.RestOfLine());
    return false;
  }
  if (keyword == "p") return Skip(ObjExtra::Points, keyword);
  if (keyword == "l") return Skip(ObjExtra::Lines, keyword);
  if (IsOneOf(keyword, {"vp",   "cstype", "deg",  "bmat", "step",  "curv", "curv2", "surf",
                        "parm", "trim",   "hole", "scrv", "sp",    "end",  "con",   "bzp",
                        "bsp",  "cdc",    "cdp",  "res",  "ctech", "stech"}))
    return Skip(ObjExtra::FreeForm, keyword);
  // Settings of display
  if (IsOneOf(keyword, {"mg", "bevel", "c_interp", "d_interp", "lod", "maplib", "usemap",
                        "shadow_obj", "trace_obj", "call", "csh"}))
    return false;
  return Skip(ObjExtra::Unknown, keyword);
}

// How many words follow. The first three must be numbers, the next three may be a color; a comment at the end
// is blanked out.
int ObjLines::CheckNumbers(char* begin, char* end) {
  undefined_ = {};
  TextScanner scanner(std::string_view(begin, std::size_t(end - begin)));
  int count = 0, intensities = 0;
  for (std::string_view word; !(word = scanner.WordOnLine()).empty(); ++count) {
    if (word[0] == '#') {
      std::fill(begin + (word.data() - begin), end, ' ');
      break;
    }
    double value = 0;
    if (count >= 3) {
      if (count < 6 && ParseNumber(word, value)) color_[intensities++] = float(value);
      continue;
    }
    if (IsPlainNumber(word)) continue;
    if (!ParseNumber(word, value) || std::isfinite(value)) Fail(Quoted(word) + " is not a number");
    undefined_[std::size_t(count)] = true;
  }
  hasColor_ = intensities == 3;
  return count;
}

// Whether the face has at least three corners. A comment at the end is blanked out, and so are slashes
// that no index follows: tinyobjloader would take the next corner's position for it.
bool ObjLines::CheckFace(char* begin, char* end) {
  TextScanner scanner(std::string_view(begin, std::size_t(end - begin)));
  int count = 0;
  for (std::string_view word; !(word = scanner.WordOnLine()).empty(); ++count) {
    char* corner = begin + (word.data() - begin);
    if (word[0] == '#') {
      std::fill(corner, end, ' ');
      break;
    }
    const std::size_t used = word.find_last_not_of('/') + 1;
    const bool slashes = word.size() - used > 2;
    const IndexFault fault = slashes ? IndexFault::Syntax : CheckCorner(word.substr(0, used));
    if (fault != IndexFault::None) FailCorner(fault, word);
    std::fill(corner + used, corner + word.size(), ' ');
  }
  return count >= 3 || Skip(ObjExtra::ShortFaces, "f");
}

void ObjLines::FailCorner(IndexFault fault, std::string_view word) const {
  if (fault == IndexFault::Zero)
    Fail(fmt::format("index 0 in {}: OBJ counts from 1", Quoted(word)));
  if (fault == IndexFault::TooLarge)
    Fail(fmt::format("the index in {} is too large", Quoted(word)));
  Fail(fmt::format("{} is no corner of a face", Quoted(word)),
       "corners are written 'position', 'position/uv', 'position//normal' or 'position/uv/normal'");
}

// Note what holds for the faces that follow.
void ObjLines::NoteState(std::string_view keyword, std::string_view rest) {
  if (keyword == "o") parts_.SetObject(rest);
  if (keyword == "g") parts_.SetGroup(rest);
  if (keyword == "s") NoteSmoothing(rest);
  if (keyword == "usemtl") parts_.SetMaterial(rest, line_);
  if (keyword == "mtllib") parts_.AddLibraries(rest, line_);
}

void ObjLines::NoteSmoothing(std::string_view word) {
  std::uint32_t group = SmoothNever;
  const char* end = word.data() + word.size();
  const auto [stop, fault] = std::from_chars(word.data(), end, group);
  const bool isNumber = fault == std::errc() && stop == end && group != SmoothByAngle;
  if (word == "on") group = 1;
  if (isNumber || word == "on" || word == "off")
    parts_.SetSmoothing(group);
  else
    Skip(ObjExtra::Unknown, "s");
}

bool ObjLines::Skip(ObjExtra extra, std::string_view keyword) {
  Tally& tally = tallies_[std::size_t(extra)];
  if (tally.count++ == 0) {
    tally.line = line_;
    tally.keyword = keyword;
  }
  return false;
}

void ObjLines::Fail(std::string message, std::string hint) const {
  throw Error(std::move(message), file_.AtLine(line_), std::move(hint));
}

}  // namespace snell::io
