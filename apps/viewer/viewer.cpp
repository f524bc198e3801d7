// SPDX-License-Identifier: Apache-2.0
#include "viewer/viewer.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "util/timer.h"
#include "viewer/view_control.h"

namespace snell::viewer {

namespace fs = std::filesystem;

namespace {

constexpr double LookEvery = 0.2;  // seconds, at the files

Timer sinceStart;

// A name for a picture that takes the place of none.
std::string FreeName(const fs::path& scene) {
  const std::string stem = scene.stem().string();
  std::string name = stem + ".png";
  std::error_code fault;
  for (int i = 2; fs::exists(name, fault); ++i) name = fmt::format("{}-{}.png", stem, i);
  return name;
}

Opened Prepare(Scene scene, const RenderOptions& options, std::vector<std::string> warnings) {
  auto session = std::make_shared<RenderSession>(scene, options);
  const int width = session->width(), height = session->height();
  return {std::move(scene), std::move(session), std::move(warnings), width, height};
}

Opened ReadAndPrepare(const fs::path& path, const RenderOptions& options) {
  std::vector<std::string> warnings;
  LoadOptions load;
  load.warn = [&](const Diagnostic& warning) { warnings.push_back(ToString(warning)); };
  Scene scene = LoadScene(path, load);
  return Prepare(std::move(scene), options, std::move(warnings));
}

std::vector<std::string> LinesOf(const std::exception& fault) {
  const auto* error = dynamic_cast<const Error*>(&fault);
  if (!error) return {fault.what()};
  std::vector<std::string> lines;
  for (const Diagnostic& diagnostic : error->diagnostics()) lines.push_back(ToString(diagnostic));
  return lines;
}

}  // namespace

Viewer::Viewer(const RenderOptions& options, StateLog& log) : log_(log), options_(options) {}

bool Viewer::Busy() const {
  return opening() || asking() || isStale_ || final_.rendering() ||
         (session_ && !shown_.finished && session_->fault().empty());
}

void Viewer::Open(const fs::path& path) {
  if (!path_.empty()) options_.camera.reset();  // of another file
  path_ = path;
  options_.cameraView.reset();
  exposure_.reset();
  viewIsChosen_ = false;
  saveName = FreeName(path);
  answer_.reset();
  LeaveResult();
  watch_.Watch(path);
  Begin(false);
}

void Viewer::Reload() {
  if (path_.empty()) return;
  watch_.Watch(path_);
  Begin(false);
}

void Viewer::SetOptions(const RenderOptions& options) {
  options_ = options;
  if (scene_) Begin(true);
}

// The picture that is shown stays until there is another one.
void Viewer::Begin(bool keepsScene) {
  if (opening_.Busy()) {
    isStale_ = true;
    readsAgain_ = readsAgain_ || !keepsScene;
    return;
  }
  isStale_ = readsAgain_ = false;
  note_ = keepsScene ? "Preparing ..." : fmt::format("Opening {} ...", path_.filename().string());
  if (keepsScene && scene_) {
    opening_.Start([scene = *scene_, options = options_] { return Prepare(scene, options, {}); });
  } else {
    opening_.Start([path = path_, options = options_] { return ReadAndPrepare(path, options); });
  }
}

void Viewer::SetSize(int width, int height) {
  if (width == previewWidth_ && height == previewHeight_) return;
  previewWidth_ = width;
  previewHeight_ = height;
  if (!session_) return;
  session_->SetSize(width, height);
  shown_.finished = false;
}

CameraView Viewer::view() const { return session_ ? session_->view() : CameraView{}; }

void Viewer::SetView(const CameraView& view) {
  if (!session_ || final_.rendering()) return;
  try {
    session_->SetView(view);
    options_.cameraView = view;
    shown_.finished = false;
    if (answer_) answer_->isOld = true;
    LeaveResult();
    log_.Say("view");
  } catch (const Error&) {  // it cannot go any further that way
  }
}

void Viewer::ResetView() {
  if (final_.rendering()) return;
  RenderOptions options = options_;
  options.cameraView.reset();
  LeaveResult();
  SetOptions(options);
}

void Viewer::FocusAt(double x, double y) {
  if (!session_) return;
  if (const auto point = session_->PointAt(x, y)) SetView(Focus(view(), *point));
}

void Viewer::Ask(double x, double y) {
  if (!session_ || asking_.Busy()) return;
  RenderOptions options = options_;
  options.width = showsResult() ? finalWidth_ : session_->width();
  options.height = showsResult() ? finalHeight_ : session_->height();
  const int column = std::clamp(int(x * *options.width), 0, *options.width - 1);
  const int row = std::clamp(int(y * *options.height), 0, *options.height - 1);
  asking_.Start([scene = *scene_, options, column, row] {
    const PixelExplainer explainer(scene, options);
    return PixelAnswer{
        column, row, explainer.width(), explainer.height(), explainer.Explain(column, row, 0),
        false};
  });
}

void Viewer::StartRender() {
  if (!scene_ || final_.rendering()) return;
  session_->SetPaused(true);
  RenderOptions options = options_;
  options.width = finalWidth_;
  options.height = finalHeight_;
  final_.Start(*scene_, options);
  note_.clear();
  log_.Say("render started");
}

void Viewer::LeaveResult() { final_.Clear(); }

void Viewer::Save() {
  if (picture().width == 0) return;
  PictureOptions options;
  try {
    const bool isLinear = saveName.ends_with(".exr") || saveName.ends_with(".hdr");
    if (!isLinear) {
      options.exposure = exposure();
      options.view = displayView_;
    }
    WritePicture(saveName, picture(), options);
    note_ = "Saved " + saveName;
    log_.Say("saved " + saveName);
  } catch (const std::exception& error) {
    note_ = fmt::format("Not saved: {}", error.what());
    log_.Say("not saved");
  }
}

bool Viewer::showsResult() const { return final_.result().has_value(); }

const Picture& Viewer::picture() const {
  return showsResult() ? final_.result()->picture : shown_.picture;
}

bool Viewer::Update() {
  const std::uint64_t samplesBefore = std::uint64_t(shown_.samples);
  const bool wasBusy = Busy();
  if (!path_.empty() && sinceStart.Seconds() > nextLook_) {
    nextLook_ = sinceStart.Seconds() + LookEvery;
    if (watch_.Changed()) Begin(false);
  }
  TakeOpened();
  TakeAnswer();
  if (final_.Update()) {
    session_->SetPaused(false);
    const FinalRender::State state = final_.state();
    log_.Say(state == FinalRender::State::Done      ? "render done"
             : state == FinalRender::State::Stopped ? "render stopped"
                                                    : "render failed");
  }
  TakePicture();
  return wasBusy || samplesBefore != std::uint64_t(shown_.samples);
}

void Viewer::TakeOpened() {
  try {
    std::optional<Opened> opened = opening_.Take();
    if (opened) {
      scene_ = opened->scene;
      session_ = opened->session;
      warnings_ = opened->warnings;
      finalWidth_ = opened->width;
      finalHeight_ = opened->height;
      sceneExposure_ = scene_->exposure();
      if (!viewIsChosen_) displayView_ = scene_->view();
      errors_.clear();
      note_.clear();
      shown_.finished = false;
      if (answer_) answer_->isOld = true;
      if (previewWidth_ > 0) session_->SetSize(previewWidth_, previewHeight_);
      if (options_.cameraView) SetView(*options_.cameraView);
      if (final_.rendering()) session_->SetPaused(true);
      log_.Say("ready");
    }
  } catch (const std::exception& error) {
    Fail("error", error);
  }
  if (isStale_ && !opening_.Busy()) Begin(!readsAgain_);
}

void Viewer::TakePicture() {
  if (!session_) return;
  if (std::optional<SessionPicture> picture = session_->Snapshot()) {
    shown_ = *std::move(picture);
    log_.Say(shown_.samples > 0 ? fmt::format("samples {}", shown_.samples) : "coarse");
    if (shown_.finished) log_.Say("finished");
  }
  if (const std::string fault = session_->fault(); !fault.empty() && errors_.empty())
    errors_ = {fault};
}

void Viewer::TakeAnswer() {
  try {
    if (std::optional<PixelAnswer> answer = asking_.Take()) {
      answer_ = std::move(answer);
      log_.Say(fmt::format("explained {} {}", answer_->x, answer_->y));
    }
  } catch (const std::exception& error) {
    Fail("question failed", error);
  }
}

void Viewer::Fail(const std::string& what, const std::exception& error) {
  errors_ = LinesOf(error);
  note_.clear();
  for (const std::string& line : errors_) log_.Say(what + " " + line);
}

}  // namespace snell::viewer
