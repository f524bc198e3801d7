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
  float speed;  // along kz
  float slack;  // how far a distance may be off by rounding
  float origin[4];
  float shear[4];  // the direction over its component kz, and that component's reciprocal
};

// Without branches, which random directions would make unpredictable.
SIMD_FN BlockRay PrepareForBlocks(Float4 o, Float4 d, const Tree& tree) {
  alignas(16) float direction[4], size[4];
  Store4(direction, d);
  Store4(size, Abs(d));
  const std::uint32_t yOverX = size[0] > size[1] ? 0u : 1u;
  const std::uint32_t isZ = kernel::Max(size[0], size[1]) > size[2] ? 0u : ~0u;
  const std::uint32_t kz = (yOverX & ~isZ) | (2u & isZ);
  // By axis, and by whether the direction along it is negative, which swaps the other two
  static constexpr std::uint8_t X[6] = {1, 2, 2, 0, 0, 1};
  static constexpr std::uint8_t Y[6] = {2, 1, 0, 2, 1, 0};
  const float dz = direction[kz];
  const std::uint32_t row = 2 * kz + (kernel::floatBitsToUint(dz) >> 31);
  BlockRay ray;
  ray.kx = X[row];
  ray.ky = Y[row];
  ray.kz = kz;
  Store4(ray.origin, o);
  Store4(ray.shear, WithLast(d, 1.0f) / Set4(dz));
  ray.speed = kernel::abs(dz);
  ray.slack = (tree.reach[kz] + kernel::abs(ray.origin[kz])) * kernel::abs(ray.shear[3]) *
              kernel::Gamma(16.0f);
  return ray;
}

// What the test of a block tells of its eight triangles, those of the lanes' first triangles before those of
// the second ones. All but `candidates` is set only if there are some.
struct BlockTest {
  std::uint32_t
      candidates;  // all that the ray hits at 0 < t ≤ tMax, and a few more for rounding's sake
  std::uint32_t certain;  // those that it hits without doubt
  // By corner of p0 p1 p2 or p0 p2 p3: edge function of the edge that faces it, and its distance along the
  // ray's axis
  Float8 edge[3];
  Float8 z[3];
};

SIMD_FN void IntersectBlock(const PairBlock& block, const BlockRay& ray, float tMax,
                            BlockTest& test) {
  // Shear the corners
  const Float16 cx = Load16(block.corner[ray.kx]) - Set16(ray.origin[ray.kx]);
  const Float16 cy = Load16(block.corner[ray.ky]) - Set16(ray.origin[ray.ky]);
  const Float16 cz = Load16(block.corner[ray.kz]) - Set16(ray.origin[ray.kz]);
  const Float16 x = cx - Set16(ray.shear[ray.kx]) * cz;
  const Float16 y = cy - Set16(ray.shear[ray.ky]) * cz;
  const Float16 z = Set16(ray.shear[3]) * cz;

  // Edge functions of p0 p1, p1 p2, p2 p3, p3 p0, and of p2 p0
  const Float16 around = NextQuarters(x) * y - NextQuarters(y) * x;
  const Float4 diagonal = Quarter0(x) * Quarter2(y) - Quarter0(y) * Quarter2(x);
  const Float8 u = Quarters12(around);
  const Float8 v = Join(diagonal, Quarter3(around));
  const Float8 w = Join(Quarter0(around), Negate(diagonal));
  const Float8 least = Min(u, Min(v, w));
  const Float8 most = Max(u, Max(v, w));
  const Float8 zero = Set8(0.0f);
  const std::uint32_t inside = MaskLessEqual(zero, least) | MaskLessEqual(most, zero);

  // Compare distances, times the determinant so that nothing is divided
  const Float4 z0 = Quarter0(z), z2 = Quarter2(z);
  const Float8 za = Join(z0, z0), zb = Quarters12(z), zc = Join(z2, Quarter3(z));
  const Float8 det = (u + v) + w;
  const Float8 area = Abs(det);
  const Float8 distance = FlipSign((u * za + v * zb) + w * zc, det);
  const std::uint32_t outside = MaskLess(distance, area * Set8(-ray.slack)) |
                                MaskLess(area * Set8(tMax + ray.slack), distance);
  test.candidates = inside & ~outside;
  if (test.candidates == 0) return;
  test.edge[0] = u;
  test.edge[1] = v;
  test.edge[2] = w;
  test.z[0] = za;
  test.z[1] = zb;
  test.z[2] = zc;

  // Certain: no edge function is zero, the limits are not near, and the ray does not start on the plane, be
  // it that the hit is farther than the triangle's size or that the volume between the triangle and the
  // ray's origin exceeds the error that kernel::StartsOnPlane allows for: at most 24 Γ₆ m³ if no coordinate
  // differs from the origin's by more than m.
  const std::uint32_t strictlyInside = MaskLess(zero, least) | MaskLess(most, zero);
  const std::uint32_t withinLimits = MaskLess(area * Set8(ray.slack), distance) &
                                     MaskLess(distance, area * Set8(tMax - ray.slack));
  const Float4 sizes = Load4(block.size);
  const Float8 volume = distance * Set8(ray.speed);
  test.certain = test.candidates & strictlyInside & withinLimits;
  const std::uint32_t isFar = MaskLess(area * Join(sizes, sizes), volume);
  if ((test.certain & ~isFar) != 0) {
    const Float16 reach = Max(Abs(x), Abs(y)) + Abs(cz);
    const Float4 m4 =
        Max(Max(Quarter0(reach), Quarter1(reach)), Max(Quarter2(reach), Quarter3(reach)));
    const Float8 m = Join(m4, m4);
    test.certain &= isFar | MaskLess((m * m) * (m * Set8(24.0f * kernel::Gamma(8.0f))), volume);
  }
}

// Whether a triangle of a block is really hit at t, by the kernel's own test.
SIMD_COLD bool Confirm(const PairBlock& block, std::uint32_t lane, std::uint32_t turn,
                       const Ray& ray) {
  static constexpr std::uint8_t Corners[2][5] = {{0, 1, 2, 0, 1}, {0, 2, 3, 0, 2}};
  vec3 v[3];
  for (std::uint32_t i = 0; i < 3; ++i) {
    const std::uint32_t place =
        Corners[lane / BlockWidth][turn + i] * BlockWidth + lane % BlockWidth;
    v[i] = vec3(block.corner[0][place], block.corner[1][place], block.corner[2][place]);
  }
  return kernel::IntersectTriangle(kernel::Shear(ray.o, ray.d), v[0], v[1], v[2]).t > 0.0f;
}

// The t of a candidate lane, or a number ≤ 0 if it is no hit at 0 < t ≤ tMax. `turn`: where the triangle's
// own first vertex is among its corners; the order of operations follows its own order.
SIMD_FN float CandidateT(const PairBlock& block, std::uint32_t lane, std::uint32_t turn,
                         const BlockTest& test, const Ray& ray, float tMax) {
  float u = Lane(test.edge[0], lane), v = Lane(test.edge[1], lane), w = Lane(test.edge[2], lane);
  float a = Lane(test.z[0], lane), b = Lane(test.z[1], lane), c = Lane(test.z[2], lane);
  while (turn > 0) {
    const float u0 = u, a0 = a;
    u = v, v = w, w = u0;
    a = b, b = c, c = a0;
    --turn;
  }
  const float det = (u + v) + w;
  const float t = ((u * a + v * b) + w * c) / det;
  if ((test.certain >> lane & 1) != 0) return t;
  if (!(t > 0.0f && t <= tMax) || det == 0.0f || block.id[lane] == None) return -1.0f;
  return Confirm(block, lane, TurnOf(block.id[lane]), ray) ? t : -1.0f;
}

}  // namespace snell::bvh::SNELL_ISA
