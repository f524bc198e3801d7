// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <filesystem>

#include "util/text.h"
#include "viewer/input.h"

namespace snell::viewer {

namespace {

constexpr float PanelWidth = 400;
constexpr ImGuiWindowFlags Fixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;

void Text(const std::string& text) { ImGui::TextUnformatted(text.c_str()); }

void WrappedText(const std::string& text) {
  ImGui::PushTextWrapPos(0);
  Text(text);
  ImGui::PopTextWrapPos();
}

void DrawProgress(Viewer& viewer) {
  const FinalRender& render = viewer.finalRender();
  const double left = render.Left();
  ImGui::ProgressBar(float(render.Share()), ImVec2(-1, 0));
  Text(left < 0 ? Duration(render.Seconds())
                : fmt::format("{}, about {} left", Duration(render.Seconds()), Duration(left)));
  if (ImGui::Button("Stop  (Esc)")) viewer.StopRender();
}

void DrawResult(Viewer& viewer) {
  const FinalRender& render = viewer.finalRender();
  switch (render.state()) {
    case FinalRender::State::Done: Text("Done in " + Duration(render.Seconds())); break;
    case FinalRender::State::Stopped: Text("Stopped after " + Duration(render.Seconds())); break;
    case FinalRender::State::Failed: WrappedText("Failed: " + render.fault()); break;
    default: return;
  }
  if (render.result()) {
    const RenderReport& report = render.result()->report;
    WrappedText(fmt::format("{:.4g} samples a pixel, {}", report.samplesPerPixel, report.device));
    for (const std::string& warning : report.warnings) WrappedText("Warning: " + warning);
    if (ImGui::Button("Back to the preview  (Esc)")) viewer.LeaveResult();
  }
}

void DrawRenderSection(Viewer& viewer) {
  Text(fmt::format("{} × {} pixels, {} samples a pixel", viewer.finalWidth(), viewer.finalHeight(),
                   viewer.spp()));
  if (viewer.finalRender().rendering()) {
    DrawProgress(viewer);
  } else {
    if (ImGui::Button("Render  (R)")) viewer.StartRender();
    DrawResult(viewer);
  }
  ImGui::SetNextItemWidth(-90);
  ImGui::InputText("##name", &viewer.saveName);
  ImGui::SameLine();
  if (ImGui::Button("Save")) viewer.Save();
  std::error_code fault;
  if (std::filesystem::exists(viewer.saveName, fault)) Text("replaces a file of this name");
}

// A choice that has the scene prepared anew.
void DrawQuality(Viewer& viewer) {
  RenderOptions options = viewer.options();
  int chosen = viewer.integrator() == "path" ? 1 : 0;
  if (ImGui::Combo("Integrator", &chosen, "whitted\0path\0")) {
    options.integrator = chosen == 1 ? "path" : "whitted";
    viewer.SetOptions(options);
  }
  static int spp = 0;  // while it is typed
  if (!ImGui::IsAnyItemActive()) spp = viewer.spp();
  ImGui::InputInt("Samples", &spp, 0);
  if (ImGui::IsItemDeactivatedAfterEdit() && spp != viewer.spp()) {
    options.spp = std::clamp(spp, 1, 1 << 20);
    viewer.SetOptions(options);
  }
}

void DrawViewSection(Viewer& viewer) {
  float exposure = viewer.exposure();
  if (ImGui::SliderFloat("Exposure", &exposure, -8, 8, "%.2f stops")) viewer.SetExposure(exposure);
  if (ImGui::BeginCombo("View", viewer.displayView().c_str())) {
    for (const std::string& view : KnownViews())
      if (ImGui::Selectable(view.c_str(), view == viewer.displayView()))
        viewer.SetDisplayView(view);
    ImGui::EndCombo();
  }
}

void DrawCameraSection(Viewer& viewer) {
  const std::vector<std::string> cameras = viewer.cameras();
  RenderOptions options = viewer.options();
  if (!cameras.empty() &&
      ImGui::BeginCombo("Camera", options.camera.value_or("the first").c_str())) {
    for (const std::string& name : cameras) {
      if (!ImGui::Selectable(name.c_str(), options.camera == name)) continue;
      options.camera = name;
      options.cameraView.reset();
      viewer.SetOptions(options);
    }
    ImGui::EndCombo();
  }
  const CameraView view = viewer.view();
  const auto point = [](const std::array<double, 3>& p) {
    return fmt::format("[{:.4g}, {:.4g}, {:.4g}]", p[0], p[1], p[2]);
  };
  // As a scene's file says it
  const std::string text = fmt::format("position = {}\nlook_at = {}\nfov = {:.4g}",
                                       point(view.position), point(view.lookAt), view.fovDegrees);
  Text(text);
  if (ImGui::Button("Copy")) ImGui::SetClipboardText(text.c_str());
  ImGui::SameLine();
  if (ImGui::Button("Camera of the file  (Home)")) viewer.ResetView();
}

void DrawPixelSection(Viewer& viewer) {
  if (viewer.asking()) Text("Following its rays ...");
  if (viewer.answer())
    DrawExplanation(*viewer.answer());
  else if (!viewer.asking())
    WrappedText("Click a pixel to see which rays made it.");
}

void DrawPanel(Viewer& viewer, const Area& area) {
  ImGui::SetNextWindowPos(ImVec2(area.x, area.y));
  ImGui::SetNextWindowSize(ImVec2(area.width, area.height));
  ImGui::Begin("Panel", nullptr, Fixed);
  if (viewer.isOpen()) {
    constexpr ImGuiTreeNodeFlags Open = ImGuiTreeNodeFlags_DefaultOpen;
    if (ImGui::CollapsingHeader("Render", Open)) {
      DrawRenderSection(viewer);
      DrawQuality(viewer);
    }
    if (ImGui::CollapsingHeader("View", Open)) DrawViewSection(viewer);
    if (ImGui::CollapsingHeader("Camera", Open)) DrawCameraSection(viewer);
    if (!viewer.warnings().empty() && ImGui::CollapsingHeader("Warnings of the file")) {
      for (const std::string& warning : viewer.warnings()) WrappedText(warning);
    }
    if (ImGui::CollapsingHeader("Pixel", Open)) DrawPixelSection(viewer);
  } else {
    WrappedText("Drop a scene or a mesh onto this window.");
    WrappedText(KnownSceneExtensions());
  }
  ImGui::End();
}

void DrawErrors(const Viewer& viewer, const Area& area) {
  if (viewer.errors().empty()) return;
  ImGui::SetNextWindowPos(ImVec2(area.x + 10, area.y + 10));
  ImGui::SetNextWindowSize(ImVec2(std::max(100.0f, area.width - 20), 0));
  ImGui::Begin("Errors", nullptr, Fixed | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0.9f, 0.3f, 0.25f, 1));
  for (const std::string& line : viewer.errors()) WrappedText(line);
  ImGui::PopStyleColor();
  if (viewer.isOpen()) WrappedText("The picture is of the scene as it was before.");
  ImGui::End();
}

void DrawStatus(const Viewer& viewer, const Area& area) {
  ImGui::SetNextWindowPos(ImVec2(area.x, area.y));
  ImGui::SetNextWindowSize(ImVec2(area.width, area.height));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(8, 3));
  ImGui::Begin("Status", nullptr, Fixed | ImGuiWindowFlags_NoScrollbar);
  std::string text = viewer.path().filename().string();
  if (viewer.isOpen()) {
    text += fmt::format("   {}   {}", viewer.integrator(),
                        viewer.showsResult()    ? "rendered picture"
                        : viewer.samples() == 0 ? std::string("coarse")
                        : viewer.finished()
                            ? fmt::format("{} samples, at rest", viewer.samples())
                            : fmt::format("{} of {} samples", viewer.samples(), viewer.spp()));
  }
  if (!viewer.note().empty()) text += "   " + viewer.note();
  Text(text + "   F1: help");
  ImGui::End();
  ImGui::PopStyleVar();
}

void DrawHelp(Interface& interface) {
  if (!interface.showsHelp) return;
  ImGui::SetNextWindowPos(ImVec2(interface.free.x + 20, interface.free.y + 20),
                          ImGuiCond_Appearing);
  ImGui::Begin("Keys and mouse", &interface.showsHelp,
               ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings);
  if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
    for (const KeyHelp& key : AllKeys()) {
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      Text(key.keys);
      ImGui::TableNextColumn();
      Text(key.text);
    }
    ImGui::EndTable();
  }
  ImGui::End();
}

}  // namespace

void ApplyTheme(bool dark) {
  if (dark)
    ImGui::StyleColorsDark();
  else
    ImGui::StyleColorsLight();
}

void DrawPanels(Viewer& viewer, Interface& interface, float scale) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const float line = ImGui::GetTextLineHeight() + 10;
  const float panel =
      interface.preferences.showsPanel ? std::min(PanelWidth * scale, size.x / 2) : 0;
  interface.free = {0, 0, size.x - panel, size.y - line};
  DrawErrors(viewer, interface.free);
  if (panel > 0) DrawPanel(viewer, {size.x - panel, 0, panel, size.y - line});
  DrawStatus(viewer, {0, size.y - line, size.x, line});
  DrawHelp(interface);
}

}  // namespace snell::viewer
