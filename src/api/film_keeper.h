// SPDX-License-Identifier: Apache-2.0
//
// What becomes of a render's film: read from a checkpoint, saved now and then, and at the end.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "api/render.h"
#include "render/film.h"
#include "render/schedule.h"
#include "scene/scene.h"

namespace snell {

class FilmKeeper {
 public:
  explicit FilmKeeper(const FilmOptions& options) : options_(options) {}

  // Whether any film is read or saved.
  bool Keeps() const { return !options_.checkpoint.empty() || !options_.output.empty(); }

  // The checkpoint's film if the render is to go on with one, else an empty one. Textures stay as detailed as they
  // were: `settings` take the film's spp. Throws Error if it is of other pixels or samples.
  render::Film Begin(const render::PixelRect& rect, std::uint32_t firstSample,
                     scene::RenderSettings& settings) const;

  // Give a film without samples the AOVs that are asked for. Throws Error if one with samples has others.
  void SetAovs(std::optional<render::AovFilm> aovs, render::Film& film) const;

  // How to save while rendering; this must not move as long as that is used. A fault is a warning: the picture is
  // more than its checkpoint.
  render::SavePlan Plan();

  // At the end: the checkpoint of a stopped render, and the film that is asked for.
  void Finish(const render::Film& film, bool stopped);

  bool saved() const { return saved_; }
  const std::vector<std::string>& warnings() const { return warnings_; }
  const std::string& outputFault() const { return outputFault_; }

 private:
  void Save(const render::Film& film);

  const FilmOptions& options_;
  bool saved_ = false;  // the checkpoint, by this render
  std::vector<std::string> warnings_;
  std::string outputFault_;
};

}  // namespace snell
