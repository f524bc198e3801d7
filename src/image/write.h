// SPDX-License-Identifier: Apache-2.0
//
// Pictures to files; the extension names the format. A file is encoded in memory and appears under its
// name only when it is complete (util/file.h), so that no fault leaves half a picture.
//
//   png        sRGB, 8 or 16 bits, alpha                jpg, jpeg  sRGB, 8 bits, no alpha
//   exr        linear, half or float, alpha             hdr        linear, shared exponent, no alpha
//
// Where a format has no alpha, colours are written multiplied by it, as seen against black.
#pragma once

#include <filesystem>
#include <string>

#include "image/image.h"
#include "image/layer.h"
#include "image/view.h"

namespace snell::image {

struct WriteOptions {
  int bits = 8;            // per channel of PNG: 8 or 16; JPEG has 8; EXR and HDR do not ask
  bool exrFloat = false;   // EXR: 32-bit float instead of half
  float exposure = 0;      // stops, for PNG and JPEG; EXR and HDR stay as they are
  View view = View::Srgb;  // of the same
  int jpegQuality = 95;    // 1 to 100; colour is stored at full resolution from 90 on
  Metadata metadata = {};
  const Layers* layers = nullptr;  // EXR: what it holds besides; others leave it out
};

// Write a picture. Values that are not finite become 0 in PNG and JPEG, and are clamped to what the
// format can hold in HDR and half EXR (NaN: 0 in HDR, kept in EXR). Throws Error for what CheckWritable
// finds and for faults of the disk; a file that was there before is then untouched.
void WriteImage(const std::filesystem::path& path, const Image& image,
                const WriteOptions& options = {});

// Throws the Error that WriteImage would throw for this name and these options, before a long render:
// unknown extension, options without meaning, a missing or unwritable folder, a folder of that name.
void CheckWritable(const std::filesystem::path& path, const WriteOptions& options = {});

// "png, jpg, jpeg, hdr, exr", for messages.
std::string KnownWriteExtensions();

}  // namespace snell::image
