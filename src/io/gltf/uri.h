// SPDX-License-Identifier: Apache-2.0
//
// The URIs of glTF's buffers and images (RFC 3986, RFC 2397): data in the file itself, or a file in its
// folder. Nothing else is opened.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/read_limits.h"

namespace snell::io {

// "a%20b" → "a b". Percent signs that no two hexadecimal digits follow stay as they are.
std::string DecodePercent(std::string_view text);

bool IsDataUri(std::string_view uri);

// The bytes of a data URI. Throws Error (without a place) if it is malformed.
std::string DecodeDataUri(std::string_view uri);

// The bytes that a URI stands for. Throws Error if the file is missing, larger than allowed, or lies
// outside of the folders; names are relative to the first one.
std::string ReadGltfUri(const std::vector<std::filesystem::path>& folders, std::string_view uri,
                        const ReadLimits& limits);

// For messages: the URI, or what it is if it holds the data itself.
std::string ShortUri(std::string_view uri);

}  // namespace snell::io
