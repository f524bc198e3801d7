// SPDX-License-Identifier: Apache-2.0
//
// Constant expressions in both languages. glslang folds them in double precision and rounds the result once,
// C++ rounds after every operation; a last bit that differs is enough to lose bit equality in some pixel of
// some scene. So every constant in the SPIR-V must be a literal of the sources, or the value of one of the
// expressions below as C++ computes it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "agree/spirv.h"
#include "kernel/math.h"
#include "util/file.h"

namespace snell::agree {

namespace {

using namespace kernel;

// The expressions of constants alone that the kernel uses, beyond literals.
const float Expressions[] = {
    1.0f / 3.0f, 1.0f / 4096.0f, 2.0f * Pi, 4.0f * Pi, 2.0f * UnitRoundoff,
};

// Bits of the absolute values of all float literals ("0.5f", "1e-3f") in a source text.
void CollectLiterals(const std::string& text, std::set<std::uint32_t>& bits) {
  const char* at = text.c_str();
  while (*at != '\0') {
    const bool inWord = at != text.c_str() && (std::isalnum(at[-1]) || at[-1] == '_');
    if (!std::isdigit(*at) || inWord) {
      ++at;
      continue;
    }
    char* end = nullptr;
    const float value = std::strtof(at, &end);
    if (*end == 'f') bits.insert(std::bit_cast<std::uint32_t>(value));
    at = end;
  }
}

std::set<std::uint32_t> LiteralsOfTheKernel() {
  std::set<std::uint32_t> bits;
  for (const char* folder : {"src/kernel", "src/gpu/shaders"}) {
    const std::filesystem::path path = std::filesystem::path(SNELL_SOURCE_DIR) / folder;
    for (const auto& entry : std::filesystem::directory_iterator(path)) {
      const std::string extension = LowerExtension(entry.path());
      if (extension == "h" || extension == "glsl" || extension == "comp")
        CollectLiterals(ReadFile(entry.path()), bits);
    }
  }
  return bits;
}

TEST(Constants, AreLiteralsOrRoundTheSameInBothLanguages) {
  std::set<std::uint32_t> known = LiteralsOfTheKernel();
  EXPECT_GT(known.size(), 50u) << "literals are not found";
  for (const float value : Expressions) known.insert(std::bit_cast<std::uint32_t>(value));
  for (const float constant : FloatConstants(ReadSpirv(SNELL_WHITTED_SPIRV))) {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(constant);
    EXPECT_TRUE(known.contains(bits & 0x7fffffffu))
        << fmt::format("{} ({:08x}) is no literal: glslang folded an expression to it. Write the ",
                       constant, bits)
        << "expression so that both languages round it alike, then list it in this test.";
  }
}

}  // namespace

}  // namespace snell::agree
