// SPDX-License-Identifier: Apache-2.0
#include "viewer/input.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "viewer/view_control.h"

namespace snell::viewer {

namespace {

constexpr float ClickReach = 4;      // pixels; what goes further is a drag
constexpr double TurnPerWindow = 3;  // radians for a drag over the picture's height
constexpr double WheelStep = 0.9;    // of the distance
constexpr double KeyTurn = 0.1;      // radians
constexpr double FlySpeed = 0.8;     // distances in a second
constexpr float ExposureStep = 0.25f;

// The camera of the file with this number, from 1.
void ChooseCamera(Viewer& viewer, std::size_t number) {
  const std::vector<std::string> cameras = viewer.cameras();
  if (number > cameras.size()) return;
  RenderOptions options = viewer.options();
  options.camera = cameras[number - 1];
  options.cameraView.reset();
  viewer.LeaveResult();
  viewer.SetOptions(options);
}

void SwitchIntegrator(Viewer& viewer) {
  RenderOptions options = viewer.options();
  options.integrator = viewer.integrator() == "path" ? "whitted" : "path";
  viewer.LeaveResult();
  viewer.SetOptions(options);
}

// Arrows turn, or pan with shift.
void PressArrow(const KeyPress& press, Viewer& viewer) {
  double right = 0, up = 0;
  if (press.key == GLFW_KEY_LEFT) right = -1;
  if (press.key == GLFW_KEY_RIGHT) right = 1;
  if (press.key == GLFW_KEY_UP) up = 1;
  if (press.key == GLFW_KEY_DOWN) up = -1;
  const CameraView view = viewer.view();
  viewer.SetView(press.shift ? Pan(view, right * KeyTurn, up * KeyTurn)
                             : Orbit(view, right * KeyTurn, up * KeyTurn));
}

}  // namespace

const std::vector<KeyHelp>& AllKeys() {
  static const std::vector<KeyHelp> keys = {
      {"left drag, arrows", "turn around what is looked at"},
      {"middle drag, Shift + left drag, Shift + arrows", "move sideways"},
      {"wheel, Ctrl + left drag, + and -", "go nearer or away"},
      {"right drag", "look around"},
      {"W A S D, Q E", "fly: forward, left, back, right, down, up; Shift: faster"},
      {"F, double click", "turn around the point under the mouse from now on"},
      {"Home", "back to the camera of the file"},
      {"1 ... 9", "the cameras of the file that have a name"},
      {"click, X", "explain the pixel under the mouse"},
      {"R", "render with the final settings"},
      {"Esc", "stop the render; leave its picture; close the help"},
      {"Ctrl + S", "save the picture"},
      {"[ and ]", "exposure: a quarter of a stop"},
      {"V, Shift + V", "next view transform, or the one before"},
      {"I", "other integrator: whitted or path"},
      {"F5", "read the file again (happens by itself when it changes)"},
      {"T", "dark or light"},
      {"P", "panel: show or hide"},
      {"F1, ?", "this sheet"},
      {"Ctrl + Q", "quit"}};
  return keys;
}

std::string NextDisplayView(const std::string& view, int step) {
  const std::vector<std::string> views = KnownViews();
  const auto count = std::ptrdiff_t(views.size());
  const std::ptrdiff_t at = std::ranges::find(views, view) - views.begin();
  return views[std::size_t((at + step + count) % count)];
}

void Input::Handle(Window& window, Viewer& viewer, Interface& interface, double seconds) {
  for (const std::string& file : window.TakeDrops()) viewer.Open(file);
  const std::vector<KeyPress> keys = window.TakeKeys();
  if (!ImGui::GetIO().WantTextInput) {
    for (const KeyPress& press : keys) Press(press, window, viewer, interface);
    Fly(window, viewer, seconds);
  }
  HandleMouse(viewer, interface);
}

void Input::HandleMouse(Viewer& viewer, const Interface& interface) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool isOver = !io.WantCaptureMouse && interface.picture.Holds(io.MousePos.x, io.MousePos.y);
  if (isOver && io.MouseWheel != 0)
    viewer.SetView(Dolly(viewer.view(), std::pow(WheelStep, double(io.MouseWheel))));
  if (isOver && ImGui::IsMouseDoubleClicked(0)) AskOrFocus(viewer, interface, true);

  // A drag begins on the picture and may go beyond it
  const bool isDown = io.MouseDown[0] || io.MouseDown[1] || io.MouseDown[2];
  if (isOver && (io.MouseClicked[0] || io.MouseClicked[1] || io.MouseClicked[2])) {
    dragging_ = true;
    way_ = 0;
    return;
  }
  if (!dragging_) return;
  const ImVec2 step = io.MouseDelta;
  way_ += std::abs(step.x) + std::abs(step.y);
  if (!isDown) {
    dragging_ = false;
    if (way_ < ClickReach && io.MouseReleased[0]) AskOrFocus(viewer, interface, false);
    return;
  }
  if (way_ < ClickReach || (step.x == 0 && step.y == 0)) return;
  const double right = double(step.x) / double(interface.picture.height);
  const double up = -double(step.y) / double(interface.picture.height);
  const CameraView view = viewer.view();
  if (io.MouseDown[2] || (io.MouseDown[0] && io.KeyShift))
    viewer.SetView(Pan(view, -right, -up));
  else if (io.MouseDown[0] && io.KeyCtrl)
    viewer.SetView(Dolly(view, std::exp(-2 * up)));
  else if (io.MouseDown[0])
    viewer.SetView(Orbit(view, -right * TurnPerWindow, -up * TurnPerWindow));
  else
    viewer.SetView(Look(view, right * TurnPerWindow / 2, up * TurnPerWindow / 2));
}

// With the keys that are still held, unless they went down for something else.
void Input::Fly(const Window& window, Viewer& viewer, double seconds) {
  std::erase_if(flying_, [&](int key) { return !window.IsHeld(key); });
  const auto axis = [&](int plus, int minus) {
    return double(std::ranges::count(flying_, plus)) - double(std::ranges::count(flying_, minus));
  };
  const double right = std::clamp(axis(GLFW_KEY_D, GLFW_KEY_A), -1.0, 1.0);
  const double up = std::clamp(axis(GLFW_KEY_E, GLFW_KEY_Q), -1.0, 1.0);
  const double forward = std::clamp(axis(GLFW_KEY_W, GLFW_KEY_S), -1.0, 1.0);
  if (right == 0 && up == 0 && forward == 0) return;
  const bool isFast = window.IsHeld(GLFW_KEY_LEFT_SHIFT) || window.IsHeld(GLFW_KEY_RIGHT_SHIFT);
  const double way = FlySpeed * (isFast ? 4 : 1) * std::min(seconds, 0.1);
  viewer.SetView(viewer::Fly(viewer.view(), right * way, up * way, forward * way));
}

// At the mouse, or in the middle if that is elsewhere.
void Input::AskOrFocus(Viewer& viewer, const Interface& interface, bool focuses) const {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const Area& area = interface.picture;
  const bool isOver = area.Holds(mouse.x, mouse.y);
  const double x = isOver ? double((mouse.x - area.x) / area.width) : 0.5;
  const double y = isOver ? double((mouse.y - area.y) / area.height) : 0.5;
  if (focuses)
    viewer.FocusAt(x, y);
  else
    viewer.Ask(x, y);
}

void Input::Press(const KeyPress& press, Window& window, Viewer& viewer, Interface& interface) {
  if (press.character != 0) return Type(press.character, viewer, interface);
  if (press.control) {
    if (press.key == GLFW_KEY_S) viewer.Save();
    if (press.key == GLFW_KEY_Q) window.Close();
    return;
  }
  switch (press.key) {
    case GLFW_KEY_LEFT:
    case GLFW_KEY_RIGHT:
    case GLFW_KEY_UP:
    case GLFW_KEY_DOWN: return PressArrow(press, viewer);
    case GLFW_KEY_W:
    case GLFW_KEY_A:
    case GLFW_KEY_S:
    case GLFW_KEY_D:
    case GLFW_KEY_Q:
    case GLFW_KEY_E:
      if (std::ranges::count(flying_, press.key) == 0) flying_.push_back(press.key);
      return;
    case GLFW_KEY_HOME: return viewer.ResetView();
    case GLFW_KEY_F5: return viewer.Reload();
    case GLFW_KEY_F1: interface.showsHelp = !interface.showsHelp; return;
    case GLFW_KEY_ESCAPE:
      if (interface.showsHelp)
        interface.showsHelp = false;
      else if (viewer.finalRender().rendering())
        viewer.StopRender();
      else
        viewer.LeaveResult();
      return;
    default: return;
  }
}

void Input::Type(char32_t character, Viewer& viewer, Interface& interface) {
  Preferences& preferences = interface.preferences;
  if (character >= '1' && character <= '9') return ChooseCamera(viewer, character - '0');
  switch (character) {
    case '+':
    case '=': return viewer.SetView(Dolly(viewer.view(), WheelStep));
    case '-': return viewer.SetView(Dolly(viewer.view(), 1 / WheelStep));
    case 'f': return AskOrFocus(viewer, interface, true);
    case 'x': return AskOrFocus(viewer, interface, false);
    case 'r': return viewer.StartRender();
    case '[': return viewer.SetExposure(viewer.exposure() - ExposureStep);
    case ']': return viewer.SetExposure(viewer.exposure() + ExposureStep);
    case 'v': return viewer.SetDisplayView(NextDisplayView(viewer.displayView(), 1));
    case 'V': return viewer.SetDisplayView(NextDisplayView(viewer.displayView(), -1));
    case 'i': return SwitchIntegrator(viewer);
    case 't': preferences.dark = !preferences.dark; return;
    case 'p': preferences.showsPanel = !preferences.showsPanel; return;
    case '?': interface.showsHelp = !interface.showsHelp; return;
    default: return;
  }
}

}  // namespace snell::viewer
