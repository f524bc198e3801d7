// SPDX-License-Identifier: Apache-2.0
//
// What is drawn around the picture: the panel at the side, the status line, the help sheet, errors.
#pragma once

#include "viewer/interface.h"
#include "viewer/viewer.h"

namespace snell::viewer {

// Set the colours of all that follows.
void ApplyTheme(bool dark);

// Within a frame of ImGui; sets the area that is left for the picture. `scale` of texts.
void DrawPanels(Viewer& viewer, Interface& interface, float scale);

// The explanation of a pixel as a tree that opens and closes.
void DrawExplanation(const PixelAnswer& answer);

}  // namespace snell::viewer
