// SPDX-License-Identifier: Apache-2.0
//
// One door to all readers, for libFuzzer (fuzz.cpp) and for the test that replays the corpus.
#pragma once

#include <string>
#include <string_view>

namespace snell::fuzz {

// Read `bytes` as the reader called `target` would read a file: the extension of the format of a picture, a
// grid, a lamp or a scene, or "mtl". Scene files find what lies in fuzz/beside next to them. Fails a CHECK if the result is
// not what the reader promises. Throws Error, and whatever else a reader throws by mistake.
void ReadAs(const std::string& target, std::string_view bytes);

}  // namespace snell::fuzz
