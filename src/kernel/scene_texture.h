// SPDX-License-Identifier: Apache-2.0
//
// Colours that may be textures. Reads the textures and the objects' placement.
#ifndef SNELL_KERNEL_SCENE_TEXTURE_H
#define SNELL_KERNEL_SCENE_TEXTURE_H

SCENE_FN Spectrum EvalTexture(uint index, IN(SurfaceInteraction) it) {
  LET(Texture) texture = textures[index];
  vec3 p = vec3(it.uv.x, it.uv.y, 0.0f);
  if (texture.space == SPACE_OBJECT) p = ToLocalPoint(objects[it.object].toWorld, it.p);
  if (texture.space == SPACE_WORLD) p = it.p;
  return EvalPattern(texture, ToLocalPoint(texture.toSpace, p));
}

SCENE_FN Spectrum EvalColor(IN(ColorSource) source, IN(SurfaceInteraction) it) {
  if (source.texture == None) return source.value;
  return source.value * EvalTexture(source.texture, it);
}

#endif
