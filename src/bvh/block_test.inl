// SPDX-License-Identifier: Apache-2.0
//
// Part of traverse.inl: rays against the triangles of blocks.
//
// The tests do the operations of kernel/triangle.h lane by lane and leave the rare doubtful cases to that
// function, so every instruction set finds the same t to the bit.

namespace snell::bvh::SNELL_ISA {

// A ray prepared for triangles: what kernel::Shear computes.
struct BlockRay {
  std::size_t kx;
  std::size_t ky;
  std::size_t kz;
  const float* direction;
  // The origin along kx, ky and kz
  Float16 x;
  Float16 y;
  Float16 z;
  float shear[4];  // the direction over its component kz, and that component's reciprocal times −1
};

// kx, ky and kz of kernel::Shear: row 8·s + c is for directions (x, y, z) whose signs are the bits of s and
// with |x| > |y|, |x| > |z|, |y| > |z| as the bits of c say.
struct ShearAxes {
  std::uint8_t row[64][4];
};
constexpr ShearAxes MakeShearAxes() {
  ShearAxes axes{};
  for (unsigned i = 0; i < 64; ++i) {
    const unsigned kz = (i & 1) != 0 ? ((i & 2) != 0 ? 0 : 2) : ((i & 4) != 0 ? 1 : 2);
    const unsigned next = (kz + 1) % 3, last = (kz + 2) % 3;
    const bool swapped = (i >> (3 + kz) & 1) != 0;
    axes.row[i][0] = std::uint8_t(swapped ? last : next);
    axes.row[i][1] = std::uint8_t(swapped ? next : last);
    axes.row[i][2] = std::uint8_t(kz);
  }
  return axes;
}
static constexpr ShearAxes Axes = MakeShearAxes();

// `d` is that of the ray. Without branches, which random directions would make unpredictable.
SIMD_FN BlockRay PrepareForBlocks(const Ray& ray, Float4 d) {
  const Float4 size = Abs(d);
  const std::uint32_t larger = MaskLess(Shuffle<1, 2, 2>(size), Shuffle<0, 0, 1>(size));
  const std::uint8_t* row = Axes.row[SignMask(d) * 8 + larger];
  BlockRay prepared;
  prepared.kx = row[0];
  prepared.ky = row[1];
  prepared.kz = row[2];
  prepared.direction = &ray.d.x;
  Store4(prepared.shear, WithLast(d, -1.0f) / Set4(prepared.direction[prepared.kz]));
  const float* origin = &ray.o.x;
  prepared.x = Set16(origin[prepared.kx]);
  prepared.y = Set16(origin[prepared.ky]);
  prepared.z = Set16(origin[prepared.kz]);
  return prepared;
}

// Which of a block's eight triangles the ray hits at 0 < t ≤ tMax, those of the lanes' first triangles before
// those of the second ones; a few more may be among them that are not `certain`. Sets `t` and `certain` if there
// are any.
SIMD_FN std::uint32_t IntersectBlock(const PairBlock& block, const BlockRay& ray, float tMax,
                                     Float8& t, std::uint32_t& certain) {
  // Shear the corners; x, y and cz come out times −1, which no product of two of them feels
  const Float16 cx = ray.x - Load16(block.corner[ray.kx]);
  const Float16 cy = ray.y - Load16(block.corner[ray.ky]);
  const Float16 cz = ray.z - Load16(block.corner[ray.kz]);
  const Float16 x = cx - Set16(ray.shear[ray.kx]) * cz;
  const Float16 y = cy - Set16(ray.shear[ray.ky]) * cz;

  // Edge functions of p0 p1, p1 p2, p2 p3, p3 p0, and of p2 p0
  const Float16 around = NextQuarters(x) * y - NextQuarters(y) * x;
  const Float4 diagonal = Quarter0(x) * Quarter2(y) - Quarter0(y) * Quarter2(x);
  const Float8 u = Quarters12(around);
  const Float8 v = Join(diagonal, Quarter3(around));
  const Float8 w = Join(Quarter0(around), Negate(diagonal));
  const Float8 least = Min(u, Min(v, w));
  const Float8 most = Max(u, Max(v, w));
  // All of one sign, or some zero; a product that vanishes only makes for doubt
  const Float8 zero = Set8(0.0f), product = least * most;
  const std::uint32_t inside = MaskLessEqual(zero, product);
  if (inside == 0) return 0;

  // Interpolate the distances. The kernel sums up in the order of a triangle's own vertices, so what belongs
  // to its last one comes last.
  const Float16 z = Set16(ray.shear[3]) * cz;
  const Float8 uz = u * Join(Quarter0(z), Quarter0(z));
  const Float8 vz = v * Quarters12(z);
  const Float8 wz = w * HighHalf(z);
  const Turns turns = LoadTurns(block.id);
  const auto sum = [&](Float8 a, Float8 b, Float8 c) {
    return (Where(turns.once, c, a) + Where(turns.twice, c, b)) +
           Where(turns.once, a, Where(turns.twice, b, c));
  };
  t = sum(uz, vz, wz) / sum(u, v, w);
  const std::uint32_t candidates = inside & MaskLess(zero, t) & MaskLessEqual(t, Set8(tMax));
  if (candidates == 0) return 0;

  // Certain: no edge function is zero, and the ray does not start on the plane, be it that the hit is farther
  // than the triangle's size or that the volume between the triangle and the ray's origin exceeds the error
  // that kernel::StartsOnPlane allows for: at most 24 Γ₆ m³ if no coordinate differs from the origin's by more
  // than m.
  const Float4 sizes = Load4(block.size);
  const Float8 reached = t * Abs(Set8(ray.direction[ray.kz]));
  certain = candidates & MaskLess(zero, product);
  const std::uint32_t isFar = MaskLess(Join(sizes, sizes), reached);
  if ((certain & ~isFar) != 0) {
    const Float16 reach = Max(Abs(x), Abs(y)) + Abs(cz);
    const Float4 m4 =
        Max(Max(Quarter0(reach), Quarter1(reach)), Max(Quarter2(reach), Quarter3(reach)));
    const Float8 m = Join(m4, m4);
    const Float8 volume = Abs((u + v) + w) * reached;
    certain &= isFar | MaskLess((m * m) * (m * Set8(24.0f * kernel::Gamma(9.0f))), volume);
  }
  return candidates;
}

// Whether a triangle of a block is really hit at t, by the kernel's own test.
SIMD_COLD bool Confirm(const PairBlock& block, std::uint32_t lane, const Ray& ray) {
  static constexpr std::uint8_t Corners[2][5] = {{0, 1, 2, 0, 1}, {0, 2, 3, 0, 2}};
  if (block.id[lane] == None) return false;
  const std::uint32_t turn = TurnOf(block.id[lane]);
  vec3 v[3];
  for (std::uint32_t i = 0; i < 3; ++i) {
    const std::uint32_t place =
        Corners[lane / BlockWidth][turn + i] * BlockWidth + lane % BlockWidth;
    v[i] = vec3(block.corner[0][place], block.corner[1][place], block.corner[2][place]);
  }
  return kernel::IntersectTriangle(kernel::Shear(ray.o, ray.d), v[0], v[1], v[2]).t > 0.0f;
}

}  // namespace snell::bvh::SNELL_ISA
