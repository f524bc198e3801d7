// SPDX-License-Identifier: Apache-2.0
//
// Mouse and keys: what they do to the view and to the viewer. docs/viewer.md lists them, and so does the help sheet.
#pragma once

#include <string>
#include <vector>

#include "viewer/interface.h"
#include "viewer/viewer.h"
#include "viewer/window.h"

namespace snell::viewer {

class Input {
 public:
  // Within a frame of ImGui. `seconds` since the last one.
  void Handle(Window& window, Viewer& viewer, Interface& interface, double seconds);

 private:
  void HandleMouse(Viewer& viewer, const Interface& interface);
  void Fly(const Window& window, Viewer& viewer, double seconds);
  void Press(const KeyPress& press, Window& window, Viewer& viewer, Interface& interface);
  void Type(char32_t character, Viewer& viewer, Interface& interface);
  void AskOrFocus(Viewer& viewer, const Interface& interface, bool focuses) const;

  std::vector<int> flying_;  // keys
  bool dragging_ = false;    // began on the picture
  float way_ = 0;            // that the mouse went since the button went down
};

// Keys and what they do, for the help sheet.
struct KeyHelp {
  const char* keys;
  const char* text;
};
const std::vector<KeyHelp>& AllKeys();

// The view that comes after this one, and the one before it.
std::string NextDisplayView(const std::string& view, int step);

}  // namespace snell::viewer
