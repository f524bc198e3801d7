// SPDX-License-Identifier: Apache-2.0
#include "api/merge.h"

#include <algorithm>
#include <cstdlib>

#include "api/film_picture.h"
#include "render/film_file.h"
#include "render/merge.h"

namespace snell {

MergeResult MergeFilms(const std::vector<std::filesystem::path>& films,
                       const std::filesystem::path& output, Denoiser denoiser) {
  if (films.empty()) throw Error("there are no films to merge");
  std::vector<render::Film> loaded;
  std::vector<std::string> names;
  for (const std::filesystem::path& path : films) {
    loaded.push_back(render::LoadFilm(path));
    names.push_back(path.string());
  }
  const render::Film film = render::MergeFilms(std::move(loaded), names);
  if (denoiser != Denoiser::None && !(film.aovs() && film.aovs()->denoises()))
    throw Error("the films hold nothing that denoising needs", {names[0]},
                "render them with --denoise");
  if (!output.empty()) render::SaveFilm(film, output);

  MergeResult result;
  result.picture = PictureOf(film);
  if (denoiser != Denoiser::None) {
    Denoised denoised = DenoisedOf(film, denoiser);
    result.denoised = std::move(denoised.picture);
    result.denoiser = denoised.by;
  }
  result.scene = NoteOf(film, "scene");
  result.exposure = std::strtof(NoteOf(film, "exposure").c_str(), nullptr);
  result.view = NoteOf(film, "view");
  result.samplesPerPixel = SamplesPerPixel(film);
  for (const render::Film::Pixel& pixel : film.pixels()) {
    result.emptyPixels += pixel.count == 0 ? 1 : 0;
    result.uneven = result.uneven || pixel.count != film.pixels()[0].count;
  }
  return result;
}

}  // namespace snell
