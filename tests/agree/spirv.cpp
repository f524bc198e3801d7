// SPDX-License-Identifier: Apache-2.0
#include "agree/spirv.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <map>

#include "util/error.h"
#include "util/file.h"

namespace snell::agree {

namespace {

// Numbers from the specification, sections 3.20 and 3.37
constexpr std::uint32_t Magic = 0x07230203;
constexpr std::size_t HeaderWords = 5;

enum Decoration : std::uint32_t { Block = 2, ArrayStride = 6, Offset = 35 };

enum Opcode : std::uint32_t {
  OpName = 5,
  OpMemberName = 6,
  OpTypeVoid = 19,
  OpTypeInt = 21,
  OpTypeFloat = 22,
  OpTypeVector = 23,
  OpTypeArray = 28,
  OpTypeRuntimeArray = 29,
  OpTypeStruct = 30,
  OpTypeForwardPointer = 39,
  OpConstant = 43,
  OpDecorate = 71,
  OpMemberDecorate = 72,
};

struct Instruction {
  std::uint32_t opcode;
  std::span<const std::uint32_t> operands;
  std::size_t position;  // in the module, in words
};

// Call `visit` for each instruction in turn.
template <class Visit>
void ForEachInstruction(std::span<const std::uint32_t> module, Visit visit) {
  for (std::size_t i = HeaderWords; i < module.size();) {
    const std::size_t length = module[i] >> 16;
    if (length == 0 || length > module.size() - i)
      throw Error(fmt::format("the SPIR-V module is cut off at word {}", i));
    visit(Instruction{module[i] & 0xffffu, module.subspan(i + 1, length - 1), i});
    i += length;
  }
}

// A string that fills the operands from `first` on, ended by a zero byte.
std::string Text(const Instruction& instruction, std::size_t first) {
  const auto bytes = std::as_bytes(instruction.operands.subspan(first));
  const char* text = reinterpret_cast<const char*>(bytes.data());
  return std::string(text, ::strnlen(text, bytes.size()));
}

// "vec3" for three floats, "uvec2" for two unsigned integers.
std::string VectorName(const std::string& component, std::uint32_t count) {
  const char* prefix = component == "float" ? "" : component == "int" ? "i" : "u";
  return fmt::format("{}vec{}", prefix, count);
}

}  // namespace

SpirvModule ReadSpirv(const std::filesystem::path& path) {
  const std::string bytes = ReadFile(path);
  SpirvModule module(bytes.size() / sizeof(std::uint32_t));
  std::memcpy(module.data(), bytes.data(), module.size() * sizeof(std::uint32_t));
  if (bytes.size() % sizeof(std::uint32_t) != 0 || module.size() < HeaderWords ||
      module[0] != Magic)
    throw Error("this is no SPIR-V module", {path.string()});
  return module;
}

SpirvLayouts ReadLayouts(std::span<const std::uint32_t> module) {
  using Member = std::pair<std::uint32_t, std::uint32_t>;  // struct, index
  std::map<std::uint32_t, std::string> names;              // of structs at first, then of all types
  std::map<Member, std::string> memberNames;
  std::map<Member, std::uint32_t> offsets;
  std::map<std::uint32_t, std::uint32_t> strides;
  std::map<std::uint32_t, bool> blocks;
  std::map<std::uint32_t, std::uint32_t> integers;  // constants, as lengths of arrays are
  SpirvLayouts layouts;

  // Names and decorations come before the types, and types before those that are made of them
  ForEachInstruction(module, [&](const Instruction& instruction) {
    const auto& operands = instruction.operands;
    switch (instruction.opcode) {
      case OpName: names[operands[0]] = Text(instruction, 1); break;
      case OpMemberName: memberNames[{operands[0], operands[1]}] = Text(instruction, 2); break;
      case OpDecorate:
        if (operands[1] == Block) blocks[operands[0]] = true;
        if (operands[1] == ArrayStride) strides[operands[0]] = operands[2];
        break;
      case OpMemberDecorate:
        if (operands[2] == Offset) offsets[{operands[0], operands[1]}] = operands[3];
        break;
      case OpTypeInt: names[operands[0]] = operands[2] == 1 ? "int" : "uint"; break;
      case OpTypeFloat: names[operands[0]] = "float"; break;
      case OpTypeVector: names[operands[0]] = VectorName(names[operands[1]], operands[2]); break;
      case OpConstant: integers[operands[1]] = operands[2]; break;
      case OpTypeArray:
        names[operands[0]] = fmt::format("{}[{}]", names[operands[1]], integers[operands[2]]);
        break;
      case OpTypeRuntimeArray:
        names[operands[0]] = names[operands[1]] + "[]";
        layouts.arrays.push_back({names[operands[1]], strides[operands[0]]});
        break;
      case OpTypeStruct: {
        // Structs of local variables have no offsets
        if (!offsets.contains({operands[0], 0})) break;
        SpirvStruct record{names[operands[0]], blocks[operands[0]], {}};
        for (std::uint32_t i = 0; i + 1 < operands.size(); ++i) {
          record.members.push_back(
              {memberNames[{operands[0], i}], names[operands[i + 1]], offsets[{operands[0], i}]});
        }
        layouts.structs.push_back(record);
        break;
      }
    }
  });
  return layouts;
}

std::vector<float> FloatConstants(std::span<const std::uint32_t> module) {
  std::vector<float> constants;
  std::uint32_t floatType = 0;
  ForEachInstruction(module, [&](const Instruction& instruction) {
    const auto& operands = instruction.operands;
    if (instruction.opcode == OpTypeFloat && operands[1] == 32) floatType = operands[0];
    if (instruction.opcode == OpConstant && operands[0] == floatType)
      constants.push_back(std::bit_cast<float>(operands[2]));
  });
  return constants;
}

}  // namespace snell::agree
