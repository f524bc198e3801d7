// SPDX-License-Identifier: Apache-2.0
//
// A window of GLFW with Dear ImGui in it, and one picture as a texture of OpenGL. One in the life of the program.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

struct GLFWwindow;

namespace snell::viewer {

// A key that was pressed, by GLFW's number, which is that of its place; or what it has typed, whatever its place.
struct KeyPress {
  int key = 0;
  char32_t character = 0;
  bool shift = false;
  bool control = false;
};

class Window {
 public:
  // Throws Error without a display, or without OpenGL.
  Window(int width, int height, const std::string& title);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  bool ShouldClose() const;
  void Close();
  // Wait for keys and so on, at most that long.
  void Wait(double seconds);
  void BeginFrame();
  void EndFrame(bool dark);
  void SetTitle(const std::string& title);

  // Three bytes a pixel, rows from the top.
  void SetPicture(const std::vector<std::uint8_t>& rgb, int width, int height);
  std::uintptr_t texture() const { return texture_; }

  // What came since the last time.
  std::vector<KeyPress> TakeKeys();
  std::vector<std::string> TakeDrops();  // files
  bool IsHeld(int key) const;
  int width() const;
  int height() const;
  float scale() const { return scale_; }  // of texts, for displays with small pixels
  float pixelsPerUnit() const;            // of the mouse's places

  void Take(const KeyPress& press) { keys_.push_back(press); }
  void Take(const std::string& file) { drops_.push_back(file); }

 private:
  GLFWwindow* window_ = nullptr;
  unsigned texture_ = 0;
  float scale_ = 1;
  std::vector<KeyPress> keys_;
  std::vector<std::string> drops_;
};

}  // namespace snell::viewer
