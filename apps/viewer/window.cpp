// SPDX-License-Identifier: Apache-2.0
#include "viewer/window.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl3.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "util/error.h"

namespace snell::viewer {

namespace {

// Explanations hold signs that ImGui's own font has not.
constexpr const char* Fonts[] = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                 "/usr/share/fonts/TTF/DejaVuSans.ttf",
                                 "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
                                 "/System/Library/Fonts/Supplemental/Arial Unicode.ttf"};
constexpr float FontSize = 15;

std::string lastFault;  // GLFW tells faults to a function without a place for data

Window& WindowOf(GLFWwindow* window) {
  return *static_cast<Window*>(glfwGetWindowUserPointer(window));
}

void LoadFont(float size) {
  static const ImWchar ranges[] = {0x20, 0x24f, 0x370, 0x3ff, 0x2010, 0x22ff, 0};
  for (const char* path : Fonts) {
    if (!std::filesystem::exists(path)) continue;
    ImGui::GetIO().Fonts->AddFontFromFileTTF(path, size, nullptr, ranges);
    return;
  }
}

void SetCallbacks(GLFWwindow* window) {
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int modifiers) {
    if (action != GLFW_RELEASE)
      WindowOf(w).Take(
          KeyPress{key, 0, (modifiers & GLFW_MOD_SHIFT) != 0, (modifiers & GLFW_MOD_CONTROL) != 0});
  });
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned character) {
    WindowOf(w).Take(KeyPress{0, character, false, false});
  });
  glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** files) {
    for (int i = 0; i < count; ++i) WindowOf(w).Take(std::string(files[i]));
  });
}

}  // namespace

Window::Window(int width, int height, const std::string& title) {
  glfwSetErrorCallback([](int, const char* text) { lastFault = text; });
  const char* hint = "the viewer needs a display with OpenGL 3.0; 'snell render' needs none";
  if (!glfwInit()) throw Error("no window can be opened: " + lastFault, {}, hint);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
#if defined(__APPLE__)
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 2);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
#else
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
#endif
  window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (!window_) {
    glfwTerminate();
    throw Error("no window can be opened: " + lastFault, {}, hint);
  }
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(window_, this);
  SetCallbacks(window_);  // before ImGui's, which call these
  glfwGetWindowContentScale(window_, &scale_, nullptr);

  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  LoadFont(FontSize * scale_);
  ImGui_ImplGlfw_InitForOpenGL(window_, true);
  ImGui_ImplOpenGL3_Init(nullptr);
  ImGui::GetStyle().ScaleAllSizes(scale_);

  glGenTextures(1, &texture_);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

Window::~Window() {
  glDeleteTextures(1, &texture_);
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  glfwDestroyWindow(window_);
  glfwTerminate();
}

bool Window::ShouldClose() const { return glfwWindowShouldClose(window_); }
void Window::Close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }
void Window::Wait(double seconds) { glfwWaitEventsTimeout(seconds); }

void Window::BeginFrame() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void Window::EndFrame(bool dark) {
  ImGui::Render();
  int pixelsWide = 0, pixelsHigh = 0;
  glfwGetFramebufferSize(window_, &pixelsWide, &pixelsHigh);
  glViewport(0, 0, pixelsWide, pixelsHigh);
  const float grey = dark ? 0.1f : 0.8f;
  glClearColor(grey, grey, grey, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  glfwSwapBuffers(window_);
}

void Window::SetTitle(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

void Window::SetPicture(const std::vector<std::uint8_t>& rgb, int width, int height) {
  glBindTexture(GL_TEXTURE_2D, texture_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, width, height, 0, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
}

std::vector<KeyPress> Window::TakeKeys() { return std::exchange(keys_, {}); }
std::vector<std::string> Window::TakeDrops() { return std::exchange(drops_, {}); }
bool Window::IsHeld(int key) const { return glfwGetKey(window_, key) == GLFW_PRESS; }

int Window::width() const {
  int width = 0, height = 0;
  glfwGetWindowSize(window_, &width, &height);
  return width;
}

int Window::height() const {
  int width = 0, height = 0;
  glfwGetWindowSize(window_, &width, &height);
  return height;
}

float Window::pixelsPerUnit() const {
  int pixelsWide = 0, pixelsHigh = 0;
  glfwGetFramebufferSize(window_, &pixelsWide, &pixelsHigh);
  return float(pixelsWide) / float(std::max(1, width()));
}

}  // namespace snell::viewer
