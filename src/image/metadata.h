// SPDX-License-Identifier: Apache-2.0
//
// Text entries as the formats without proper fields for them keep them (JPEG comments, Radiance
// headers): one line "key: value" each.
#pragma once

#include <string>
#include <string_view>

#include "image/image.h"

namespace snell::image {

// Throws Error unless every key can be written in every format (image.h says what a key is).
void CheckMetadata(const Metadata& metadata);

// "key: value" without line breaks.
std::string MetadataLine(const std::string& key, const std::string& value);

// Undo MetadataLine; text of another form becomes an entry "Comment".
void AddMetadataLine(std::string_view line, Metadata& metadata);

}  // namespace snell::image
