// SPDX-License-Identifier: Apache-2.0
//
// Textures outside of a render: the kernel's own evaluation, for displacement (src/tessellate).
#pragma once

#include "cpu/flatten.h"
#include "tessellate/tessellate.h"

namespace snell::cpu {

// Looks up in the textures of `flat`, which must not move meanwhile.
tessellate::TextureLookup LookupIn(const FlatScene& flat);

}  // namespace snell::cpu
