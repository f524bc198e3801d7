// SPDX-License-Identifier: Apache-2.0
//
// The kernel's own mathematics. Only + − × ÷ √ and integer operations are used, in a pinned order, so that
// a CPU and Mesa's software Vulkan driver give the same bits (docs/decisions/002-bit-equality.md); for the
// same reason normalize, dot, cross and the transcendental functions are ours, not the languages'.
// Polynomials: Cephes (Moshier 1992) for sin, cos, asin, atan. Error bounds: Higham 2002, section 3.1;
// pbrt-v4, section 6.8.
#ifndef SNELL_KERNEL_MATH_H
#define SNELL_KERNEL_MATH_H

#include "kernel/dialect.h"

KERNEL_BEGIN

CONST float Pi = 3.14159265358979323846f;
CONST float InvPi = 0.31830988618379067154f;
CONST float Inv2Pi = 0.15915494309189533577f;
CONST float PiOver2 = 1.57079632679489661923f;
CONST float PiOver4 = 0.78539816339744830961f;

// Half the distance from 1 to the next float: the largest relative error of one operation.
CONST float UnitRoundoff = 5.9604644775390625e-8f;
// Larger than any distance in a scene; stands for "no limit" where infinity may not be used.
CONST float Infinite = 3.0e38f;
// No element, in a field that holds an index.
CONST uint None = 0xffffffffu;

// Scalars

FN float Min(float a, float b) { return b < a ? b : a; }
FN float Max(float a, float b) { return a < b ? b : a; }
FN float Clamp(float x, float lower, float upper) { return Min(Max(x, lower), upper); }
FN float Sqr(float x) { return x * x; }
FN float SafeSqrt(float x) { return sqrt(Max(x, 0.0f)); }
FN float Lerp(float t, float a, float b) { return a + t * (b - a); }
FN float CopySign(float magnitude, float sign) {
  return uintBitsToFloat((floatBitsToUint(magnitude) & 0x7fffffffu) |
                         (floatBitsToUint(sign) & 0x80000000u));
}
// 0 below `lower`, 1 above `upper`, a smooth cubic between. The two must differ.
FN float SmoothStep(float lower, float upper, float x) {
  float t = Clamp((x - lower) / (upper - lower), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

// Vectors

FN float Dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
FN vec3 Cross(vec3 a, vec3 b) {
  return vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
FN float LengthSquared(vec3 v) { return Dot(v, v); }
FN float Length(vec3 v) { return sqrt(Dot(v, v)); }
FN vec3 Normalize(vec3 v) { return v / sqrt(Dot(v, v)); }
FN vec3 Abs(vec3 v) { return vec3(abs(v.x), abs(v.y), abs(v.z)); }
FN vec3 Lerp(float t, vec3 a, vec3 b) { return a + t * (b - a); }
FN vec3 FaceForward(vec3 n, vec3 w) { return Dot(n, w) < 0.0f ? -n : n; }

// Two unit vectors that make a right-handed orthonormal frame with the unit vector n.
// Duff et al. 2017, "Building an orthonormal basis, revisited".
FN void CoordinateSystem(vec3 n, OUT(vec3) s, OUT(vec3) t) {
  float sign = CopySign(1.0f, n.z);
  float a = -1.0f / (sign + n.z);
  float b = n.x * n.y * a;
  s = vec3(1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x);
  t = vec3(b, sign + n.y * n.y * a, -n.y);
}

// Spectra: the only functions that look into a Spectrum's channels

FN float MaxChannel(Spectrum s) { return Max(s.x, Max(s.y, s.z)); }
FN float MeanChannel(Spectrum s) { return (s.x + s.y + s.z) * (1.0f / 3.0f); }
FN Spectrum Saturate(Spectrum s) {
  return Spectrum(Clamp(s.x, 0.0f, 1.0f), Clamp(s.y, 0.0f, 1.0f), Clamp(s.z, 0.0f, 1.0f));
}
FN bool IsBlack(Spectrum s) { return MaxChannel(s) <= 0.0f; }

// Rounding

// Bound of the relative error that n rounded operations accumulate.
FN float Gamma(float n) { return (n * UnitRoundoff) / (1.0f - n * UnitRoundoff); }

// The next larger and next smaller float; finite arguments only. Denormals are skipped: devices may flush
// them to zero.
FN float NextFloatUp(float x) {
  uint bits = floatBitsToUint(x);
  if (x == 0.0f) return uintBitsToFloat(0x00800000u);
  if (bits == 0x80800000u) return 0.0f;
  return uintBitsToFloat(x > 0.0f ? bits + 1u : bits - 1u);
}
FN float NextFloatDown(float x) { return -NextFloatUp(-x); }

// Sign of a·b − c·d, exact but for underflow: 1, 0 or −1. Dekker 1971: the rounding error of a product by
// splitting the factors into halves.
FN float ProductError(float a, float b, float product) {
  float aBig = a * 4097.0f;
  float aHigh = aBig - (aBig - a);
  float aLow = a - aHigh;
  float bBig = b * 4097.0f;
  float bHigh = bBig - (bBig - b);
  float bLow = b - bHigh;
  return ((aHigh * bHigh - product) + aHigh * bLow + aLow * bHigh) + aLow * bLow;
}
FN float DifferenceOfProductsSign(float a, float b, float c, float d) {
  float ab = a * b;
  float cd = c * d;
  if (ab != cd) return ab > cd ? 1.0f : -1.0f;
  float abError = ProductError(a, b, ab);
  float cdError = ProductError(c, d, cd);
  return abError > cdError ? 1.0f : (abError < cdError ? -1.0f : 0.0f);
}

// Transcendental functions, within 3 units in the last place of their result unless said otherwise

// Sine and cosine of x radians, |x| < 8000; off by less than 8e-8, which beyond |x| = π can be more than
// three units near their zeros.
FN void SinCos(float x, OUT(float) sine, OUT(float) cosine) {
  // Subtract the nearest multiple of π/2 in three parts (Cody and Waite 1980)
  float k = floor(x * 0.63661977236758134308f + 0.5f);
  float r = ((x - k * 1.5703125f) - k * 4.837512969970703125e-4f) - k * 7.54978995489188216e-8f;
  float z = r * r;
  float s = ((-1.9515295891e-4f * z + 8.3321608736e-3f) * z - 1.6666654611e-1f) * z * r + r;
  float c =
      ((2.443315711809948e-5f * z - 1.388731625493765e-3f) * z + 4.166664568298827e-2f) * z * z -
      0.5f * z + 1.0f;
  uint quadrant = uint(int(k)) & 3u;
  float first = (quadrant & 1u) == 0u ? s : c;
  float second = (quadrant & 1u) == 0u ? c : s;
  sine = quadrant >= 2u ? -first : first;
  cosine = quadrant == 1u || quadrant == 2u ? -second : second;
}
FN float Sin(float x) {
  float s;
  float c;
  SinCos(x, s, c);
  return s;
}
FN float Cos(float x) {
  float s;
  float c;
  SinCos(x, s, c);
  return c;
}

// 2 to the power of n + f, for an integer n from −126 to 127 and |f| about a half at most.
FN float Exp2Parts(float n, float f) {
  float p = 1.5252733804059840e-5f;
  p = p * f + 1.5403530393381610e-4f;
  p = p * f + 1.3333558146428443e-3f;
  p = p * f + 9.6181291076284772e-3f;
  p = p * f + 5.5504108664821580e-2f;
  p = p * f + 2.4022650695910072e-1f;
  p = p * f + 6.9314718055994531e-1f;
  p = p * f + 1.0f;
  return p * uintBitsToFloat(uint(int(n) + 127) << 23);
}
// 2 to the power of x; x is clamped to [−126, 127.49], about the range of normal floats.
FN float Exp2(float x) {
  float clamped = Clamp(x, -126.0f, 127.49f);
  float n = floor(clamped + 0.5f);
  return Exp2Parts(n, clamped - n);
}
// e to the power of x; x is clamped to [−87.33, 88.36].
FN float Exp(float x) {
  // Subtract the nearest multiple of ln 2 in two parts, so that large arguments lose no digits
  float clamped = Clamp(x, -87.33f, 88.36f);
  float n = floor(clamped * 1.44269504088896340736f + 0.5f);
  float r = (clamped - n * 0.693359375f) + n * 2.12194440e-4f;
  return Exp2Parts(n, r * 1.44269504088896340736f);
}
FN vec3 Exp(vec3 v) { return vec3(Exp(v.x), Exp(v.y), Exp(v.z)); }

// Base-2 logarithm of a positive normal float.
FN float Log2(float x) {
  uint bits =
      floatBitsToUint(x) - 0x3f3504f3u;  // the bits of √½: the mantissa will lie in [√½, √2)
  int exponent = int(bits) >> 23;
  float m = uintBitsToFloat((bits & 0x007fffffu) + 0x3f3504f3u);
  float s = (m - 1.0f) / (m + 1.0f);
  float z = s * s;
  float p = ((((0.32059889f * z + 0.41219858f) * z + 0.57707802f) * z + 0.96179669f) * z) * s +
            2.8853900817779268f * s;
  return float(exponent) + p;
}
FN float Log(float x) { return Log2(x) * 0.69314718055994530942f; }

// x to the power of y for x ≥ 0; 0 for x ≤ 0. Relative error about 1e-7 · (1 + |y log2 x|).
FN float Pow(float x, float y) {
  return x < 1.1754944e-38f ? (y == 0.0f ? 1.0f : 0.0f) : Exp2(y * Log2(x));
}

FN float AsinPolynomial(float x) {
  float z = x * x;
  return ((((4.2163199048e-2f * z + 2.4181311049e-2f) * z + 4.5470025998e-2f) * z +
           7.4953002686e-2f) *
              z +
          1.6666752422e-1f) *
             z * x +
         x;
}
// Arc cosine in radians; the argument is clamped to [−1, 1].
FN float Acos(float x) {
  float c = Clamp(x, -1.0f, 1.0f);
  if (c > 0.5f) return 2.0f * AsinPolynomial(sqrt(0.5f * (1.0f - c)));
  if (c < -0.5f) return Pi - 2.0f * AsinPolynomial(sqrt(0.5f * (1.0f + c)));
  return PiOver2 - AsinPolynomial(c);
}
// Arc sine, likewise.
FN float Asin(float x) {
  float a = abs(x);
  if (a <= 0.5f) return AsinPolynomial(x);
  return CopySign(PiOver2 - 2.0f * AsinPolynomial(SafeSqrt(0.5f * (1.0f - a))), x);
}

// Angle of (x, y) in (−π, π]; 0 for the origin.
FN float Atan2(float y, float x) {
  float ax = abs(x);
  float ay = abs(y);
  float larger = Max(ax, ay);
  if (larger == 0.0f) return 0.0f;
  float t = Min(ax, ay) / larger;
  bool upper = t > 0.41421356f;
  float r = upper ? (t - 1.0f) / (t + 1.0f) : t;
  float z = r * r;
  float a = (((8.05374449538e-2f * z - 1.38776856032e-1f) * z + 1.99777106478e-1f) * z -
             3.33329491539e-1f) *
                z * r +
            r;
  if (upper) a += PiOver4;
  if (ay > ax) a = PiOver2 - a;
  if (x < 0.0f) a = Pi - a;
  return y < 0.0f ? -a : a;
}

KERNEL_END

#endif
