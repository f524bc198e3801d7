// SPDX-License-Identifier: Apache-2.0
//
// What is UTF-8 and what only looks like it (RFC 3629, section 4): names of files may be any bytes.
#pragma once

#include <cstddef>
#include <string_view>

namespace snell {

// Bytes of the character at the start of `text`, which is not empty; 0 if it is not UTF-8.
std::size_t Utf8Length(std::string_view text);

}  // namespace snell
