// SPDX-License-Identifier: Apache-2.0
//
// Snell's public interface: a scene to look around in. Installed as <snell/api/session.h>.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "picture.h"
#include "render.h"
#include "scene.h"

namespace snell {

// What a session shows at a moment.
struct SessionPicture {
  Picture picture;         // without layers
  int samples = 0;         // of each pixel; 0: a coarse picture, smaller than the session's
  std::uint64_t view = 0;  // the view that it shows, as RenderSession::SetView has counted it
  bool finished = false;   // it has all samples that were asked for
};

// Renders a scene in the background, over and over as its view changes: first coarse pictures, then one of full size that
// gets a sample of each pixel in each pass, until it has those that the options ask for. It is then, bit for bit, what
// Render gives with the same options. The scene is prepared only once; surfaces that are cut finer for the eye are cut
// for the first view. It always works on the processor, and takes no notice of the options' films, noise, seconds,
// samples, crop, AOVs and denoiser. All functions may be called from any thread.
class SNELL_EXPORT RenderSession {
 public:
  // Prepares the scene, and begins. Throws Error.
  explicit RenderSession(const Scene& scene, const RenderOptions& options = {});
  ~RenderSession();  // stops within milliseconds
  RenderSession(const RenderSession&) = delete;
  RenderSession& operator=(const RenderSession&) = delete;

  // Where the camera stands; at first the chosen one of the scene.
  CameraView view() const;
  // Begin anew from another place. Returns the view's number, the first one is 0; sizes count, too. Throws Error if no
  // camera can look like that.
  std::uint64_t SetView(const CameraView& view);
  // Begin anew in another size. Throws Error if it is none.
  void SetSize(int width, int height);
  // Rest, or go on where it was.
  void SetPaused(bool paused);

  // The newest picture, if there is one that was not handed out before.
  std::optional<SessionPicture> Snapshot();
  // What ended the session's work: a fault of memory, say; "" as long as nothing did.
  std::string fault() const;

  // What the eye meets at a point of the picture, from (0, 0) at the top left to (1, 1): the place in metres, none if
  // that is the background.
  std::optional<std::array<double, 3>> PointAt(double x, double y) const;

  // What the pictures are made with, with what the scene says for the rest.
  int width() const;
  int height() const;
  int spp() const;
  std::string integrator() const;

 private:
  class Worker;
  std::unique_ptr<Worker> worker_;
};

}  // namespace snell
