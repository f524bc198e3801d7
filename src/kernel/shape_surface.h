// SPDX-License-Identifier: Apache-2.0
//
// What an analytic shape knows of a point on it, in its own space.
#ifndef SNELL_KERNEL_SHAPE_SURFACE_H
#define SNELL_KERNEL_SHAPE_SURFACE_H

#include "kernel/dialect.h"

KERNEL_BEGIN

struct LocalSurface {
  vec3 p;      // put back onto the surface after rounding
  vec3 error;  // bound of p's distance from the surface, per coordinate
  vec3 n;      // to the outside; need not have unit length
  vec3 dpdu;
  vec2 uv;  // may be left 0 where nobody asks for it, since it takes an arc tangent
};

KERNEL_END

#endif
