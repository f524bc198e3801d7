// SPDX-License-Identifier: Apache-2.0
//
// The viewer without its window: a scene that is open, the session that shows it, the render that counts, and the pixel
// that is asked about. The window's loop calls Update; keys, mouse and panels call the rest. One thread.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "api/snell.h"
#include "viewer/background.h"
#include "viewer/file_watch.h"
#include "viewer/final_render.h"
#include "viewer/state_log.h"

namespace snell::viewer {

// A scene with a session, as they come from the background.
struct Opened {
  Scene scene;
  std::shared_ptr<RenderSession> session;
  std::vector<std::string> warnings;
  int width = 0;  // of the picture that the options ask for
  int height = 0;
};

// What a pixel was found to be.
struct PixelAnswer {
  int x = 0;
  int y = 0;
  int width = 0;  // of the picture that it is in
  int height = 0;
  SampleExplanation explanation;
  bool isOld = false;  // the scene or the view is another one by now
};

class Viewer {
 public:
  Viewer(const RenderOptions& options, StateLog& log);

  // Look what the background has come to. Returns whether something was new.
  bool Update();
  // Whether something may be new within milliseconds.
  bool Busy() const;

  void Open(const std::filesystem::path& path);
  void Reload();
  // Prepare the open scene anew, for other options.
  void SetOptions(const RenderOptions& options);
  void SetSize(int width, int height);  // of the preview, in pixels
  void SetView(const CameraView& view);
  void ResetView();
  void FocusAt(double x, double y);  // a point of the picture, each from 0 to 1
  void Ask(double x, double y);

  void StartRender();
  void StopRender() { final_.Stop(); }
  void LeaveResult();  // back to the preview
  void Save();         // the result, or the preview if there is none, under `saveName`

  bool isOpen() const { return session_ != nullptr; }
  bool opening() const { return opening_.Busy(); }
  bool asking() const { return asking_.Busy(); }
  const std::filesystem::path& path() const { return path_; }
  const RenderOptions& options() const { return options_; }
  std::vector<std::string> cameras() const {
    return scene_ ? scene_->cameras() : std::vector<std::string>{};
  }
  std::string integrator() const { return session_ ? session_->integrator() : ""; }
  int spp() const { return session_ ? session_->spp() : 0; }
  int finalWidth() const { return finalWidth_; }
  int finalHeight() const { return finalHeight_; }
  CameraView view() const;
  const FinalRender& finalRender() const { return final_; }
  int samples() const { return shown_.samples; }
  bool finished() const { return shown_.finished; }
  const std::optional<PixelAnswer>& answer() const { return answer_; }
  const std::vector<std::string>& errors() const { return errors_; }
  const std::vector<std::string>& warnings() const { return warnings_; }
  const std::string& note() const { return note_; }
  void SetNote(std::string note) { note_ = std::move(note); }

  // What is to be seen: the result of a render, or the preview; empty before there is one.
  const Picture& picture() const;
  bool showsResult() const;
  // How it is to be seen.
  float exposure() const { return exposure_.value_or(sceneExposure_); }
  const std::string& displayView() const { return displayView_; }
  void SetExposure(float stops) { exposure_ = stops; }
  void SetDisplayView(const std::string& view) { displayView_ = view, viewIsChosen_ = true; }

  std::string saveName;

 private:
  void Begin(bool keepsScene);
  void TakeOpened();
  void TakePicture();
  void TakeAnswer();
  void Fail(const std::string& what, const std::exception& error);

  StateLog& log_;
  std::filesystem::path path_;
  RenderOptions options_;
  std::optional<Scene> scene_;
  std::shared_ptr<RenderSession> session_;
  int previewWidth_ = 0;  // wanted; 0: not known yet
  int previewHeight_ = 0;
  int finalWidth_ = 0;
  int finalHeight_ = 0;
  SessionPicture shown_;
  std::optional<float> exposure_;
  float sceneExposure_ = 0;
  std::string displayView_ = "srgb";
  bool viewIsChosen_ = false;
  std::vector<std::string> errors_;
  std::vector<std::string> warnings_;
  std::string note_;
  std::optional<PixelAnswer> answer_;
  FileWatch watch_;
  double nextLook_ = 0;      // at the files
  bool isStale_ = false;     // begin again as soon as the background is free
  bool readsAgain_ = false;  // the file, too
  FinalRender final_;
  Background<Opened> opening_;
  Background<PixelAnswer> asking_;
};

}  // namespace snell::viewer
