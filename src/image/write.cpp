// SPDX-License-Identifier: Apache-2.0
#include "image/write.h"

#include <fmt/format.h>

#include <cmath>
#include <new>
#include <system_error>
#include <vector>

#include "image/codec.h"
#include "image/metadata.h"
#include "util/check.h"
#include "util/file.h"
#include "util/text.h"

namespace snell::image {

namespace fs = std::filesystem;

namespace {

struct Writer {
  const char* extension;
  std::string (*encode)(const Image&, const WriteOptions&, const Place&);
  bool only8Bits;
};

constexpr Writer Writers[] = {
    {"png", EncodePng, false}, {"jpg", EncodeJpeg, true}, {"jpeg", EncodeJpeg, true},
    {"hdr", EncodeHdr, false}, {"exr", EncodeExr, false},
};

const Writer& WriterFor(const fs::path& path) {
  const std::string extension = LowerExtension(path);
  std::vector<std::string> known;
  for (const Writer& writer : Writers) {
    if (extension == writer.extension) return writer;
    known.push_back(writer.extension);
  }
  const std::string guess = DidYouMean(extension, known);
  throw Error(extension.empty()
                  ? "the name of the picture has no extension that says its format"
                  : fmt::format("pictures of the type '.{}' cannot be written", extension),
              {path.string()},
              (guess.empty() ? "" : guess + " ") + "known extensions: " + KnownWriteExtensions());
}

void CheckOptions(const Writer& writer, const WriteOptions& options, const Place& place) {
  if (options.bits != 8 && options.bits != 16)
    throw Error(fmt::format("{} bits per channel cannot be written", options.bits), place,
                "PNG has 8 or 16");
  if (options.bits == 16 && writer.only8Bits)
    throw Error("JPEG has no 16 bits per channel", place, "write a .png or an .exr instead");
  if (options.jpegQuality < 1 || options.jpegQuality > 100)
    throw Error(fmt::format("{} is no JPEG quality", options.jpegQuality), place,
                "it ranges from 1 to 100");
  if (!std::isfinite(options.exposure))
    throw Error("the exposure must be a finite number of stops", place);
  CheckMetadata(options.metadata);
}

}  // namespace

std::string KnownWriteExtensions() {
  std::string list;
  for (const Writer& writer : Writers)
    list += (list.empty() ? "" : ", ") + std::string(writer.extension);
  return list;
}

void CheckWritable(const fs::path& path, const WriteOptions& options) {
  CheckOptions(WriterFor(path), options, {path.string()});

  std::error_code ignored;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::exists(folder, ignored))
    throw Error(fmt::format("the folder '{}' does not exist", folder.string()), {path.string()},
                "create it first");
  if (!fs::is_directory(folder, ignored))
    throw Error(fmt::format("'{}' is not a folder", folder.string()), {path.string()});
  if (fs::is_directory(path, ignored))
    throw Error("there is a folder of this name", {path.string()});

  CheckFileWritable(path);
}

void WriteImage(const fs::path& path, const Image& image, const WriteOptions& options) {
  const Writer& writer = WriterFor(path);
  const Place place{path.string()};
  CheckOptions(writer, options, place);

  const std::size_t pixels = std::size_t(image.width) * std::size_t(image.height);
  CHECK(image.width > 0 && image.height > 0 && image.pixels.size() == pixels);
  CHECK(image.alpha.empty() || image.alpha.size() == pixels);

  std::string bytes;
  try {
    bytes = writer.encode(image, options, place);
  } catch (const std::bad_alloc&) {
    throw Error("there is not enough memory to write the picture", place);
  }
  WriteFile(path, bytes);
}

}  // namespace snell::image
