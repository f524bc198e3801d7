// SPDX-License-Identifier: Apache-2.0
#include "render/film_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
#include <optional>
#include <sstream>

#include "util/error.h"
#include "util/file.h"
#include "util/hash.h"

namespace snell::render {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little && sizeof(Film::Pixel) == 128,
              "films are written as they lie in memory");

namespace {

constexpr char Magic[9] = "snelfilm";
constexpr std::uint32_t FormatVersion = 2;
constexpr std::uint32_t WithoutAovs = 1;
constexpr std::uint32_t LargestHeader = 1 << 20;
constexpr int LargestSide = 65536;
constexpr std::uint64_t LargestAovs = std::uint64_t(1) << 60;
constexpr std::size_t ChunkPixels = 8192;

struct Start {
  char magic[8];
  std::uint32_t version;
  std::uint32_t headerSize;
};

// --- The header's text --------------------------------------------------------------------------------------

// One line: what files are called may contain anything.
std::string OneLine(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, '?');
  return text;
}

// How many bytes the film's AOVs take in the file.
std::uint64_t AovBytes(const Film& film) {
  std::uint64_t bytes = 0;
  if (film.aovs()) film.aovs()->Save([&](const void*, std::size_t size) { bytes += size; });
  return bytes;
}

std::string HeaderText(const Film& film) {
  const PixelRect& r = film.rect();
  std::string text =
      fmt::format("rect {} {} {} {}\nfirst {}\n", r.x0, r.y0, r.x1, r.y1, film.firstSample());
  if (film.aovs()) text += fmt::format("aovs {}\n", AovBytes(film));
  for (const SampleBlock& b : film.merged()) {
    text += fmt::format("merged {} {} {} {} {} {}\n", b.rect.x0, b.rect.y0, b.rect.x1, b.rect.y1,
                        b.first, b.last);
  }
  for (const auto& [name, value] : film.origin().samples)
    text += OneLine(fmt::format("sample.{}={}", name, value)) + "\n";
  for (const auto& [name, value] : film.origin().notes)
    text += OneLine(fmt::format("note.{}={}", name, value)) + "\n";
  return text;
}

struct Header {
  PixelRect rect;
  std::uint32_t first = 0;
  std::uint64_t aovBytes = 0;  // 0: there are none
  std::vector<SampleBlock> merged;
  FilmOrigin origin;
};

bool IsRect(const PixelRect& r) {
  return !r.Empty() && r.x0 >= 0 && r.y0 >= 0 && r.x1 <= LargestSide && r.y1 <= LargestSide;
}

bool ReadRect(std::istream& in, PixelRect& r) {
  return in >> r.x0 >> r.y0 >> r.x1 >> r.y1 && IsRect(r);
}

// One line "prefix.name=value", if it is one.
bool ReadProperty(const std::string& line, const std::string& prefix, Properties& properties) {
  const std::size_t equals = line.find('=');
  if (!line.starts_with(prefix) || equals == line.npos) return false;
  properties.emplace_back(line.substr(prefix.size(), equals - prefix.size()),
                          line.substr(equals + 1));
  return true;
}

// Nothing if the text makes no sense.
std::optional<Header> ParseHeader(const std::string& text) {
  Header header;
  bool hasRect = false;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (ReadProperty(line, "sample.", header.origin.samples) ||
        ReadProperty(line, "note.", header.origin.notes))
      continue;
    std::istringstream words(line);
    std::string name;
    words >> name;
    if (name == "rect") {
      if (hasRect || !ReadRect(words, header.rect)) return {};
      hasRect = true;
    } else if (name == "first") {
      if (!(words >> header.first)) return {};
    } else if (name == "aovs") {
      if (!(words >> header.aovBytes) || header.aovBytes > LargestAovs) return {};
    } else if (name == "merged") {
      SampleBlock block;
      if (!ReadRect(words, block.rect) || !(words >> block.first >> block.last)) return {};
      header.merged.push_back(block);
    } else {
      return {};
    }
  }
  if (!hasRect) return {};
  return header;
}

// --- Reading ------------------------------------------------------------------------------------------------

class Reader {
 public:
  explicit Reader(const fs::path& path) : path_(path) {
    std::error_code fault;
    if (fs::exists(path, fault) && !fs::is_regular_file(path, fault)) Fail("not a regular file");
    stream_.open(path, std::ios::binary);
    if (!stream_) Fail(fmt::format("cannot read the file: {}", std::strerror(errno)));
    size_ = fs::file_size(path, fault);
    if (fault) Fail(fmt::format("cannot read the file: {}", fault.message()));
  }

  [[noreturn]] void Fail(std::string message, std::string hint = {}) const {
    throw Error(std::move(message), {path_.string()}, std::move(hint));
  }
  [[noreturn]] void FailTruncated(std::uint64_t expected) const {
    Fail(fmt::format("the film file is incomplete: it has {} of {} bytes", size_, expected));
  }

  void Read(void* bytes, std::size_t size, Hasher* hasher) {
    if (!stream_.read(static_cast<char*>(bytes), std::streamsize(size)))
      Fail(fmt::format("the film file ends too early, after {} bytes", size_));
    if (hasher) hasher->Add(bytes, size);
  }
  void CheckSum(const Hasher& hasher, const char* what) {
    std::uint64_t sum = 0;
    Read(&sum, sizeof sum, nullptr);
    if (sum != hasher.Value())
      Fail(fmt::format("the film file is damaged: the checksum of its {} is wrong", what));
  }
  std::uint64_t size() const { return size_; }

 private:
  fs::path path_;
  std::ifstream stream_;
  std::uint64_t size_ = 0;
};

Header ReadHeader(Reader& reader) {
  Start start = {};
  if (reader.size() < sizeof start) reader.FailTruncated(sizeof start);
  Hasher hasher;
  reader.Read(&start, sizeof start, &hasher);
  if (std::memcmp(start.magic, Magic, sizeof start.magic) != 0) reader.Fail("not a film file");
  if (start.version != FormatVersion && start.version != WithoutAovs)
    reader.Fail(fmt::format("the film file has version {} of its format; this program knows {}",
                            start.version, FormatVersion));
  const std::uint64_t end = sizeof start + std::uint64_t(start.headerSize) + sizeof(std::uint64_t);
  if (start.headerSize > LargestHeader)
    reader.Fail("the film file is damaged: its header is too large");
  if (reader.size() < end) reader.FailTruncated(end);
  std::string text(start.headerSize, '\0');
  reader.Read(text.data(), text.size(), &hasher);
  reader.CheckSum(hasher, "header");
  std::optional<Header> header = ParseHeader(text);
  if (!header) reader.Fail("the film file's header makes no sense");

  const std::uint64_t pixels =
      std::uint64_t(header->rect.Width()) * std::uint64_t(header->rect.Height());
  std::uint64_t expected = end + pixels * sizeof(Film::Pixel) + sizeof(std::uint64_t);
  if (header->aovBytes > 0) expected += header->aovBytes + sizeof(std::uint64_t);
  if (reader.size() < expected) reader.FailTruncated(expected);
  if (reader.size() > expected)
    reader.Fail(fmt::format("the film file has {} bytes too many", reader.size() - expected));
  return *header;
}

bool IsSound(const Film::Pixel& pixel, std::uint32_t first) {
  for (int i = 0; i < 3; ++i) {
    if (!pixel.sum[i].MayHave(pixel.count) || !pixel.firstHalf[i].MayHave(pixel.halfCount))
      return false;
  }
  return pixel.squares.MayHave(pixel.count) && pixel.squares.Value() >= 0 &&
         pixel.halfCount <= pixel.count && pixel.goal >= pixel.count && first + pixel.goal >= first;
}

void ReadAovs(Reader& reader, std::uint64_t bytes, Film& film) {
  Hasher hasher;
  try {
    film.aovs() = AovFilm::Load(
        film.rect(), bytes, [&](void* to, std::size_t size) { reader.Read(to, size, &hasher); });
  } catch (const Error& error) {
    reader.Fail(error.diagnostics()[0].message);
  }
  reader.CheckSum(hasher, "layers");
  const PixelRect& rect = film.rect();
  for (int y = rect.y0; y < rect.y1; ++y) {
    for (int x = rect.x0; x < rect.x1; ++x)
      if (film.aovs()->SampleCount(x, y) != film.SampleCount(x, y))
        reader.Fail("the film file's layers are of other samples than its pixels");
  }
}

}  // namespace

void SaveFilm(const Film& film, const fs::path& path) {
  const std::string text = HeaderText(film);
  Start start = {};
  std::memcpy(start.magic, Magic, sizeof start.magic);
  start.version = film.aovs() ? FormatVersion : WithoutAovs;
  start.headerSize = std::uint32_t(text.size());

  AtomicFile file(path);
  const auto write = [&](const void* bytes, std::size_t size, Hasher& hasher) {
    file.Write(bytes, size);
    hasher.Add(bytes, size);
  };
  const auto writeSum = [&](const Hasher& hasher) {
    const std::uint64_t sum = hasher.Value();
    file.Write(&sum, sizeof sum);
  };
  Hasher header;
  write(&start, sizeof start, header);
  write(text.data(), text.size(), header);
  writeSum(header);
  Hasher pixels;
  for (std::size_t i = 0; i < film.pixels().size(); i += ChunkPixels) {
    const std::size_t count = std::min(ChunkPixels, film.pixels().size() - i);
    write(&film.pixels()[i], count * sizeof(Film::Pixel), pixels);
  }
  writeSum(pixels);
  if (film.aovs()) {
    Hasher aovs;
    film.aovs()->Save([&](const void* bytes, std::size_t size) { write(bytes, size, aovs); });
    writeSum(aovs);
  }
  file.Commit();
}

Film LoadFilm(const fs::path& path) {
  Reader reader(path);
  Header header = ReadHeader(reader);
  Film film(header.rect, header.first);
  film.merged() = std::move(header.merged);
  film.origin() = std::move(header.origin);
  Hasher hasher;
  for (std::size_t i = 0; i < film.pixels().size(); i += ChunkPixels) {
    const std::size_t count = std::min(ChunkPixels, film.pixels().size() - i);
    reader.Read(&film.pixels()[i], count * sizeof(Film::Pixel), &hasher);
  }
  reader.CheckSum(hasher, "pixels");
  for (const Film::Pixel& pixel : film.pixels())
    if (!IsSound(pixel, header.first)) reader.Fail("the film file's pixels make no sense");
  if (header.aovBytes > 0) ReadAovs(reader, header.aovBytes, film);
  return film;
}

std::string AovDifference(const std::optional<AovFilm>& a, const std::optional<AovFilm>& b) {
  if (a && b) return a->Difference(*b);
  if (a) return fmt::format("layers {}, not none", a->KindText());
  return b ? fmt::format("no layers, but {}", b->KindText()) : "";
}

std::string Difference(const FilmOrigin& a, const FilmOrigin& b) {
  const auto find = [](const Properties& properties, const std::string& name) {
    const auto at = std::find_if(properties.begin(), properties.end(),
                                 [&](const auto& property) { return property.first == name; });
    return at == properties.end() ? std::string("none") : at->second;
  };
  std::vector<std::string> differences;
  const auto compare = [&](const std::string& name) {
    const std::string left = find(a.samples, name), right = find(b.samples, name);
    if (left == right) return;
    // What stands for much is a checksum, which tells people nothing
    const bool isSum = left.starts_with('#') || right.starts_with('#');
    differences.push_back(isSum ? fmt::format("another {}", name)
                                : fmt::format("{} {}, not {}", name, left, right));
  };
  for (const auto& [name, value] : a.samples) compare(name);
  for (const auto& [name, value] : b.samples)
    if (find(a.samples, name) == "none") compare(name);
  return fmt::format("{}", fmt::join(differences, "; "));
}

}  // namespace snell::render
