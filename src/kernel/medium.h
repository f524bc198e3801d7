// SPDX-License-Identifier: Apache-2.0
//
// Which refractive objects a point is inside of. Objects may be nested (an air bubble in glass) and may
// overlap (water in a tumbler): where several overlap, the one of the highest priority fills the space, and
// among equals the one that was entered last (Schmidt and Budge 2002, "Simple nested dielectrics in ray
// traced images").
#ifndef SNELL_KERNEL_MEDIUM_H
#define SNELL_KERNEL_MEDIUM_H

#include "kernel/math.h"
#include "kernel/types.h"

KERNEL_BEGIN

FN MediumStack NoMedia() {
  MediumStack media;
  media.count = 0u;
  for (uint i = 0u; i < MaxNestedMedia; ++i) media.object[i] = None;
  return media;
}

FN bool IsInside(IN(MediumStack) media, uint object) {
  for (uint i = 0u; i < media.count; ++i) {
    if (media.object[i] == object) return true;
  }
  return false;
}

// Once inside, entering again changes nothing; beyond the limit the outermost object is forgotten.
FN MediumStack EnterMedium(IN(MediumStack) before, uint object) {
  MediumStack media = before;
  if (IsInside(media, object)) return media;
  if (media.count == MaxNestedMedia) {
    for (uint i = 1u; i < MaxNestedMedia; ++i) media.object[i - 1u] = media.object[i];
    media.count -= 1u;
  }
  media.object[media.count] = object;
  media.count += 1u;
  return media;
}

FN MediumStack LeaveMedium(IN(MediumStack) before, uint object) {
  MediumStack media = before;
  uint kept = 0u;
  for (uint i = 0u; i < before.count; ++i) {
    if (before.object[i] != object) {
      media.object[kept] = before.object[i];
      kept += 1u;
    }
  }
  media.count = kept;
  return media;
}

KERNEL_END

#endif
