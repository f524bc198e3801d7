// SPDX-License-Identifier: Apache-2.0
//
// Colours, numbers and normals that may be textures. Reads the textures and the objects' placement.
#ifndef SNELL_KERNEL_SCENE_TEXTURE_H
#define SNELL_KERNEL_SCENE_TEXTURE_H

SCENE_FN vec4 EvalTextureAt(IN(Texture) texture, IN(SurfaceInteraction) it, vec2 uv) {
  vec3 p = vec3(uv.x, uv.y, 0.0f);
  if (texture.space == SPACE_OBJECT) p = ToLocalPoint(ObjectAt(it.object, it.time), it.p);
  if (texture.space == SPACE_WORLD) p = it.p;
  vec3 q = ToLocalPoint(texture.toSpace, p);
  if (texture.kind == TEXTURE_IMAGE)
    return EvalImage(texture, vec2(q.x, q.y), it.footprint * it.uvDensity);
  Spectrum color = EvalPattern(texture, q);
  return vec4(color.x, color.y, color.z, 1.0f);
}

SCENE_FN vec4 EvalTexture(uint index, IN(SurfaceInteraction) it) {
  LET(Texture) texture = textures[index];
  vec2 uv = texture.uvSet == 1u ? it.uv1 : it.uv;
  vec4 texel = EvalTextureAt(texture, it, uv);
  TELL(Reads(index, uv, texel));
  return texel;
}

SCENE_FN Spectrum EvalColor(IN(ColorSource) source, IN(SurfaceInteraction) it) {
  if (source.texture == None) return source.value;
  vec4 texel = EvalTexture(source.texture, it);
  return source.value * Spectrum(texel.x, texel.y, texel.z);
}

// What all textures of a material show at a point, 1 where there is none. In one loop, because GPUs' compilers
// copy a texture's evaluation to every place where it is called.
SCENE_FN RoleTexels TexelsAt(IN(Material) material, IN(SurfaceInteraction) it) {
  RoleTexels shown;
  for (uint role = 0u; role < RoleCount; ++role) shown.at[role] = vec4(1.0f, 1.0f, 1.0f, 1.0f);
  if (material.textured == 0u) return shown;
  for (uint role = 0u; role < RoleCount; ++role) {
    uint texture = material.textures[role];
    if (texture != None) shown.at[role] = EvalTexture(texture, it);
  }
  return shown;
}

// The normal that a texel of a normal map says, around the normal ns.
SCENE_FN vec3 NormalOfTexel(IN(SurfaceInteraction) it, vec3 ns, vec4 texel, vec2 scale) {
  float x = (2.0f * texel.x - 1.0f) * scale.x;
  float y = (2.0f * texel.y - 1.0f) * scale.y;
  float z = 2.0f * texel.z - 1.0f;
  vec3 tangent = it.tangent - ns * Dot(it.tangent, ns);
  if (LengthSquared(tangent) <= 0.0f) return ns;
  tangent = Normalize(tangent);
  vec3 n = tangent * x + Cross(ns, tangent) * (y * it.handedness) + ns * z;
  return LengthSquared(n) > 0.0f ? FaceForward(Normalize(n), it.n) : ns;
}

// The shading normal after the material's maps; on the side of it.ns.
SCENE_FN vec3 MappedNormal(IN(Material) material, IN(SurfaceInteraction) it, IN(RoleTexels) shown) {
  vec3 ns = it.ns;
  if (material.bumpMap != None) {
    // Move the surface along its normal by the height and see how its tangents turn (Blinn 1978)
    LET(Texture) texture = textures[material.bumpMap];
    vec2 uv = texture.uvSet == 1u ? it.uv1 : it.uv;
    float delta = Max(1.0f / Max(texture.texelDensity, 1e-6f), it.footprint * it.uvDensity);
    float heights[3];
    for (uint i = 0u; i < 3u; ++i) {
      vec2 offset = vec2(i == 1u ? delta : 0.0f, i == 2u ? delta : 0.0f);
      heights[i] = EvalTextureAt(texture, it, uv + offset).x;
    }
    float alongU = (heights[1] - heights[0]) / delta * material.bumpScale;
    float alongV = (heights[2] - heights[0]) / delta * material.bumpScale;
    vec3 dpdu = it.dpdu + ns * (alongU - Dot(it.dpdu, ns));
    vec3 dpdv = it.dpdv + ns * (alongV - Dot(it.dpdv, ns));
    vec3 n = Cross(dpdu, dpdv);
    if (LengthSquared(n) > 0.0f) ns = FaceForward(Normalize(n), ns);
  }
  if (material.textures[ROLE_NORMAL] != None)
    ns = NormalOfTexel(it, ns, shown.at[ROLE_NORMAL], material.normalScale);
  return ns;
}

#endif
