// SPDX-License-Identifier: Apache-2.0
//
// All parts of the kernel that are functions of values. In C++ this comes before the struct that holds the
// buffers' pointers and includes the scene_*.h headers and the integrators.
#ifndef SNELL_KERNEL_VALUES_H
#define SNELL_KERNEL_VALUES_H

#include "kernel/albedo.h"
#include "kernel/aov.h"
#include "kernel/bsdf.h"
#include "kernel/camera.h"
#include "kernel/classic.h"
#include "kernel/environment.h"
#include "kernel/flight.h"
#include "kernel/fresnel.h"
#include "kernel/image.h"
#include "kernel/interface.h"
#include "kernel/light.h"
#include "kernel/light_tree.h"
#include "kernel/medium.h"
#include "kernel/motion.h"
#include "kernel/path_state.h"
#include "kernel/path_vertex.h"
#include "kernel/pattern.h"
#include "kernel/phase.h"
#include "kernel/physical.h"
#include "kernel/ray.h"
#include "kernel/sampling.h"
#include "kernel/shape.h"
#include "kernel/sobol.h"
#include "kernel/subsurface.h"
#include "kernel/thin_film.h"
#include "kernel/triangle.h"
#include "kernel/whitted_state.h"

#endif
