// SPDX-License-Identifier: Apache-2.0
//
// What libFuzzer calls. It is built once for each target; scripts/fuzz.sh runs them.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/read_as.h"
#include "util/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    snell::fuzz::ReadAs(SNELL_FUZZ_TARGET, {reinterpret_cast<const char*>(bytes), size});
  } catch (const snell::Error&) {
    // The answer to a damaged file; any other exception ends the run
  }
  return 0;
}

// What Assimp forgets to free when it refuses a file is its own affair.
extern "C" const char* __lsan_default_suppressions() { return "leak:libassimp\n"; }
