// SPDX-License-Identifier: Apache-2.0
#include "image/codec.h"

#include <fmt/format.h>

#include <utility>

#include "image/color.h"
#include "util/text.h"

namespace snell::image {

Error Source::Fault(std::string message, std::int64_t offset, std::string hint) const {
  Place place{name};
  place.offset = offset;
  return Error(std::move(message), std::move(place), std::move(hint));
}

void Source::CheckSize(std::int64_t width, std::int64_t height) const {
  constexpr std::int64_t LongestSide = 0x7fffffff;
  if (width < 1 || height < 1 || width > LongestSide || height > LongestSide)
    throw Fault(fmt::format("{}×{} is no size for a picture", width, height));
  const std::uint64_t pixels = std::uint64_t(width) * std::uint64_t(height);
  if (pixels > options.limits.pixels)
    throw Fault(fmt::format("the picture has {}×{} = {} pixels; the limit is {}", width, height,
                            WithCommas(pixels), WithCommas(options.limits.pixels)),
                -1, options.limits.pixelHint);
}

void Source::CheckPlausible(std::uint64_t rawBytes, std::uint64_t ratio) const {
  if (rawBytes / ratio > bytes.size())
    throw Fault(fmt::format("the file is damaged: its {} cannot hold the {} that it promises",
                            ByteSize(bytes.size()), ByteSize(rawBytes)));
}

std::string Printable(std::string_view text) {
  std::string printable(text.substr(0, 60));
  for (char& c : printable)
    if (c < ' ' || c > '~') c = '?';
  return text.size() > 60 ? printable + "…" : printable;
}

vec3 DisplayColor(const vec3& linear, const WriteOptions& options) {
  return ViewColor(options.view, Expose(FiniteOrZero(linear), options.exposure));
}

}  // namespace snell::image
