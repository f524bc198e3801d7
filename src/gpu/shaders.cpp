// SPDX-License-Identifier: Apache-2.0
//
// The shaders as words (program.h), and how they are made strict. A module is a header of five words and then
// instructions, each with its length and opcode in the first word (The Khronos Group, "SPIR-V Specification",
// version 1.5, sections 2.3, 3.20 and 3.37). Only modules that our build made and spirv-val accepted are read.
#include "gpu/program.h"
#include "util/check.h"

namespace snell::gpu {

namespace {

constexpr std::uint32_t PathWords[] = {
#include "path.comp.inc"
};
constexpr std::uint32_t WhittedWords[] = {
#include "whitted.comp.inc"
};

constexpr std::size_t HeaderWords = 5;
constexpr std::uint32_t NoContraction = 42;

enum Opcode : std::uint32_t {
  OpTypeVoid = 19,
  OpTypeForwardPointer = 39,
  OpDecorate = 71,
  OpFNegate = 127,
  OpFAdd = 129,
  OpFSub = 131,
  OpFMul = 133,
  OpFDiv = 136,
  OpFRem = 140,
  OpFMod = 141,
  OpVectorTimesScalar = 142,
  OpDot = 148,
};

// What NoContraction applies to; the opcodes from OpVectorTimesScalar to OpDot are products of vectors and
// matrices.
bool IsFloatArithmetic(std::uint32_t opcode) {
  switch (opcode) {
    case OpFNegate:
    case OpFAdd:
    case OpFSub:
    case OpFMul:
    case OpFDiv:
    case OpFRem:
    case OpFMod: return true;
    default: return opcode >= OpVectorTimesScalar && opcode <= OpDot;
  }
}

}  // namespace

std::span<const std::uint32_t> ShaderOf(scene::Integrator integrator) {
  if (integrator == scene::Integrator::Path) return PathWords;
  return WhittedWords;
}

SpirvModule WithNoContraction(std::span<const std::uint32_t> module) {
  // Find the results, and the end of the annotations: the first declaration of a type
  std::vector<std::uint32_t> results;
  std::size_t annotationsEnd = 0;
  for (std::size_t i = HeaderWords; i < module.size(); i += module[i] >> 16) {
    CHECK(module[i] >> 16 > 0);
    const std::uint32_t opcode = module[i] & 0xffffu;
    const bool type = opcode >= OpTypeVoid && opcode <= OpTypeForwardPointer;
    if (type && annotationsEnd == 0) annotationsEnd = i;
    if (IsFloatArithmetic(opcode)) results.push_back(module[i + 2]);
  }

  // Put a decoration for each there
  SpirvModule decorated(module.begin(), module.begin() + std::ptrdiff_t(annotationsEnd));
  for (const std::uint32_t result : results)
    decorated.insert(decorated.end(), {3u << 16 | OpDecorate, result, NoContraction});
  decorated.insert(decorated.end(), module.begin() + std::ptrdiff_t(annotationsEnd), module.end());
  return decorated;
}

}  // namespace snell::gpu
