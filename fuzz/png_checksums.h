// SPDX-License-Identifier: Apache-2.0
//
// PNG pictures guard every chunk by a checksum, so that nearly all damage ends there. A fuzzer has to make
// them right to get further.
#pragma once

#include <string>
#include <string_view>

namespace snell::fuzz {

// The file with the checksum that each of its chunks should have, as far as it consists of chunks.
std::string WithPngChecksums(std::string_view file);

}  // namespace snell::fuzz
