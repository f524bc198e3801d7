// SPDX-License-Identifier: Apache-2.0
//
// The light tree over a scene's lights and emitters (light_tree.h builds it), and the list of its directional lights,
// which lie nowhere.
#pragma once

#include "cpu/flatten.h"

namespace snell::cpu {

// Fill the tree from lights and emitters, and tell these their leaves. What has no power has none, and neither has what
// only the camera sees.
void FlattenLightTree(FlatScene& flat);

}  // namespace snell::cpu
