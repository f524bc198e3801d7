// SPDX-License-Identifier: Apache-2.0
//
// The frame in which a surface scatters: z along its shading normal on the viewer's side, x along the direction in which
// its microfacets are stretched; and the normal of its coat, which a map of its own may turn. Reads the materials.
#ifndef SNELL_KERNEL_SCENE_FRAME_H
#define SNELL_KERNEL_SCENE_FRAME_H

// A unit normal that wo sees from above.
SCENE_FN vec3 NormalSeenFrom(vec3 ns, vec3 wo) {
  float cosine = Dot(ns, wo);
  if (cosine > 1e-3f) return ns;
  return Normalize(ns + wo * (2e-3f - cosine));
}

// The direction of anisotropy: the tangent, turned by the material's angle and its texture.
SCENE_FN vec3 StretchDirection(IN(Physical) physical, IN(RoleTexels) shown,
                               IN(SurfaceInteraction) it) {
  vec2 axis = physical.anisotropyAxis;
  if (physical.anisotropyMapped == 1u) {
    vec4 texel = shown.at[ROLE_ANISOTROPY];
    vec2 d = vec2(2.0f * texel.x - 1.0f, 2.0f * texel.y - 1.0f);
    axis = vec2(d.x * axis.x - d.y * axis.y, d.x * axis.y + d.y * axis.x);
  }
  if (axis.y == 0.0f && axis.x > 0.0f) return it.tangent;
  vec3 tangent = it.tangent - it.ns * Dot(it.tangent, it.ns);
  vec3 bitangent = Cross(it.ns, tangent) * it.handedness;
  vec3 turned = tangent * axis.x + bitangent * axis.y;
  return LengthSquared(turned) > 0.0f ? turned : it.tangent;
}

// Axes x and y to the normal z.
SCENE_FN void ScatteringFrame(IN(Material) material, IN(RoleTexels) shown,
                              IN(SurfaceInteraction) it, vec3 z, OUT(vec3) x, OUT(vec3) y) {
  vec3 along = StretchDirection(physicals[material.closure], shown, it);
  x = along - z * Dot(along, z);
  if (LengthSquared(x) > 1e-12f * LengthSquared(along)) {
    x = Normalize(x);
    y = Cross(z, x);
  } else {
    CoordinateSystem(z, x, y);
  }
}

// The coat's normal on the side of n, where the base's is z. Without a map it is that of the surface below all maps.
SCENE_FN vec3 CoatNormal(IN(Material) material, IN(RoleTexels) shown, IN(SurfaceInteraction) it,
                         vec3 n, vec3 wo) {
  LET(Physical) physical = physicals[material.closure];
  vec3 ns = it.ns;
  if (material.textures[ROLE_COAT_NORMAL] != None)
    ns = NormalOfTexel(it, ns, shown.at[ROLE_COAT_NORMAL], physical.coatNormalScale);
  return NormalSeenFrom(FaceForward(ns, n), wo);
}

#endif
