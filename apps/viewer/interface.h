// SPDX-License-Identifier: Apache-2.0
//
// What is on the screen beside the scene: where the picture lies, which sheets are open, what is remembered.
#pragma once

#include "viewer/preferences.h"

namespace snell::viewer {

// A rectangle in the window, from its upper left corner.
struct Area {
  float x = 0;
  float y = 0;
  float width = 0;
  float height = 0;

  bool Holds(float px, float py) const {
    return px >= x && py >= y && px < x + width && py < y + height;
  }
};

struct Interface {
  Preferences preferences;
  bool showsHelp = false;
  Area free;     // what panels leave
  Area picture;  // the picture within it
};

}  // namespace snell::viewer
