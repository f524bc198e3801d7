// SPDX-License-Identifier: Apache-2.0
#include "agree/spirv.h"

#include <gtest/gtest.h>

#include "util/error.h"
#include "util/file.h"

namespace snell::agree {

namespace {

// A module by hand: a float type, a function's worth of arithmetic. Only what the functions look at.
constexpr std::uint32_t Op(std::uint32_t words, std::uint32_t opcode) {
  return words << 16 | opcode;
}

const SpirvModule Small = {
    0x07230203, 0x00010500, 0,   10,         0,  // header
    Op(3, 5),   1,          'f',                 // OpName %1 "f"
    Op(3, 22),  2,          32,                  // %2 = OpTypeFloat 32
    Op(4, 43),  2,          3,   0x3f000000,     // %3 = OpConstant %2 0.5
    Op(5, 129), 2,          4,   3,          3,  // %4 = OpFAdd %2 %3 %3
    Op(4, 127), 2,          5,   4,              // %5 = OpFNegate %2 %4
    Op(5, 128), 2,          6,   3,          3,  // %6 = OpIAdd, which is left alone
    Op(5, 148), 2,          7,   4,          5,  // %7 = OpDot
};

TEST(Spirv, NoContractionIsPutOnEveryResultOfFloatArithmetic) {
  const SpirvModule decorated = gpu::WithNoContraction(Small);
  const SpirvModule decorations = {Op(3, 71), 4, 42, Op(3, 71), 5, 42, Op(3, 71), 7, 42};
  SpirvModule expected = Small;
  expected.insert(expected.begin() + 8, decorations.begin(), decorations.end());
  EXPECT_EQ(decorated, expected);
}

TEST(Spirv, ConstantsAreRead) { EXPECT_EQ(FloatConstants(Small), std::vector<float>{0.5f}); }

TEST(Spirv, ModulesThatAreCutOffAreErrors) {
  SpirvModule cut = Small;
  cut.pop_back();
  EXPECT_THROW(ReadLayouts(cut), Error);
  SpirvModule endless = Small;
  endless.push_back(Op(0, 129));
  EXPECT_THROW(FloatConstants(endless), Error);
}

TEST(Spirv, OtherFilesAreErrors) {
  EXPECT_THROW(ReadSpirv(SNELL_SOURCE_DIR "/LICENSE"), Error);
  EXPECT_THROW(ReadSpirv(SNELL_SOURCE_DIR "/no-such-file"), Error);
}

}  // namespace

}  // namespace snell::agree
