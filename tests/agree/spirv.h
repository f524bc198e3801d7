// SPDX-License-Identifier: Apache-2.0
//
// SPIR-V modules as words: what the tests of agreement need of them. A module is a header of five words and
// then instructions, each with its length and opcode in the first word (The Khronos Group, "SPIR-V
// Specification", version 1.5, section 2.3). Only modules that our build made and spirv-val accepted are
// read here.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "gpu/program.h"

namespace snell::agree {

using gpu::SpirvModule;

// The words of a file. Throws Error if it cannot be read or does not begin as a module does.
SpirvModule ReadSpirv(const std::filesystem::path& path);

struct SpirvMember {
  std::string name;
  std::string type;  // as GLSL writes it: "uint", "vec3", "Transform"
  std::uint32_t offset = 0;
};

// A struct with an explicit layout, as buffers have.
struct SpirvStruct {
  std::string name;
  bool block = false;  // the interface of a whole buffer
  std::vector<SpirvMember> members;
};

// An array without a fixed length in a buffer.
struct SpirvRuntimeArray {
  std::string element;
  std::uint32_t stride = 0;
};

struct SpirvLayouts {
  std::vector<SpirvStruct> structs;
  std::vector<SpirvRuntimeArray> arrays;
};

// All explicit layouts in a module that still has its names.
SpirvLayouts ReadLayouts(std::span<const std::uint32_t> module);

// The values of all 32-bit float constants in a module.
std::vector<float> FloatConstants(std::span<const std::uint32_t> module);

}  // namespace snell::agree
