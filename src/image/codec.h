// SPDX-License-Identifier: Apache-2.0
//
// What read.cpp and write.cpp know of each format: one function that decodes and one that encodes, each
// in its own file, between pictures and bytes in memory.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "image/read.h"
#include "image/write.h"
#include "util/error.h"

namespace snell::image {

// What a decoder is given. `metadata` is never null.
struct Source {
  std::string_view bytes;
  std::string name;
  ReadOptions options;
  Metadata* metadata;

  // An Error about this file, at a byte if `offset` is not negative.
  Error Fault(std::string message, std::int64_t offset = -1, std::string hint = {}) const;

  // Throws unless 1×1 ≤ width × height ≤ the limits.
  void CheckSize(std::int64_t width, std::int64_t height) const;

  // Throws if even the best case of the format's compression, `ratio` to 1, cannot pack `rawBytes` into
  // this file. Keeps small damaged files from asking for large memory.
  void CheckPlausible(std::uint64_t rawBytes, std::uint64_t ratio) const;
};

Image DecodePng(const Source& source);
Image DecodeJpeg(const Source& source);
Image DecodeHdr(const Source& source);
Image DecodeExr(const Source& source);
Image DecodeWebp(const Source& source);

// The complete file. `place` is the file's name for errors; options have been checked.
std::string EncodePng(const Image& image, const WriteOptions& options, const Place& place);
std::string EncodeJpeg(const Image& image, const WriteOptions& options, const Place& place);
std::string EncodeHdr(const Image& image, const WriteOptions& options, const Place& place);
std::string EncodeExr(const Image& image, const WriteOptions& options, const Place& place);

// Text from a file, fit for a message: at most 60 characters, '?' for those that are not printable ASCII.
std::string Printable(std::string_view text);

// The colour of a pixel as an 8- or 16-bit sRGB file stores it, before rounding: without what is not
// finite, exposed, seen through the view.
vec3 DisplayColor(const vec3& linear, const WriteOptions& options);

}  // namespace snell::image
