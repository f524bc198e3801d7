// SPDX-License-Identifier: Apache-2.0
//
// What a file leaves open: a camera that shows everything, and a small studio for a bare mesh.
#pragma once

#include "scene/scene.h"

namespace snell::scene {

// A camera that shows all objects from the front, a little from the right and from above, and as large as
// a picture of this width divided by height allows.
Camera DefaultCamera(const Scene& scene, double aspect);

// Set a scene that has only objects into a studio: an endless neutral ground under the lowest point, a key
// light, a fill light and a rim light, all soft.
void AddStudio(Scene& scene);

// The grey, slightly glossy material of things that bring none.
Material DefaultMaterial();

// The same for meshes with colours, which it shows: physical, and white by itself.
Material ColoredMaterial();

}  // namespace snell::scene
