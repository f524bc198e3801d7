// SPDX-License-Identifier: Apache-2.0
//
// The bridge between the kernel's two languages: the only file in src/kernel that knows whether a C++
// or a GLSL compiler reads it. What the macros stand for:
//
//   FN              a free function of values
//   RARE_FN         the same, seldom called: kept out of its callers' code
//   SCENE_FN        a function that reads the scene's buffers: in C++ a member of the struct that holds
//                   the pointers (src/cpu/kernel.h), in GLSL a function at global scope
//   IN OUT INOUT(T) parameters; OUT and INOUT are copied in and out in GLSL: never alias them
//   LET(T)          a local name for an element of a buffer, read only
//   CONST           a constant of the file
//   TELL(x)         a call of whoever listens to a sample, for the compilation that explains it (src/explain); in all
//                   others nothing
//
// GLSL types are used in both (vec3, uint, uvec3 …); vectors are GLM's in C++. Products and quotients of
// constants alone need care: GLSL's compiler folds them in double precision, C++ in single, and the last bit
// may differ (tests/agree/constants_test.cpp lists the ones that are in use).
#ifndef SNELL_KERNEL_DIALECT_H
#define SNELL_KERNEL_DIALECT_H

#ifndef TELL
#define TELL(x)
#endif

#ifdef __cplusplus

#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#define KERNEL_BEGIN namespace snell::kernel {
#define KERNEL_END }
#define FN [[maybe_unused]] static inline __attribute__((always_inline))
#define RARE_FN [[maybe_unused]] static __attribute__((noinline))
#define SCENE_FN inline
#define IN(T) const T&
#define OUT(T) T&
#define INOUT(T) T&
#define LET(T) const T&
#define CONST inline constexpr

namespace snell::kernel {

using glm::uvec2;
using glm::uvec3;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = std::uint32_t;

// Radiance, reflectance, transmittance: linear Rec.709 for now. Code that is not about colour spaces
// treats it as an opaque set of channels, so that sampled wavelengths can take its place.
using Spectrum = vec3;

FN uint floatBitsToUint(float f) { return std::bit_cast<uint>(f); }
FN float uintBitsToFloat(uint u) { return std::bit_cast<float>(u); }
FN uint bitfieldReverse(uint x) {
  x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
  x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
  x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
  return __builtin_bswap32(x);
}
FN float floor(float x) { return std::floor(x); }
FN float abs(float x) { return std::fabs(x); }
FN float sqrt(float x) { return std::sqrt(x); }

}  // namespace snell::kernel

#else

#define KERNEL_BEGIN
#define KERNEL_END
#define FN
#define RARE_FN
#define SCENE_FN
#define IN(T) in T
#define OUT(T) out T
#define INOUT(T) inout T
#define LET(T) T
#define CONST const
#define Spectrum vec3

#endif

#endif
