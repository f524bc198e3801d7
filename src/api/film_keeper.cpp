// SPDX-License-Identifier: Apache-2.0
#include "api/film_keeper.h"

#include <fmt/format.h>

#include <charconv>

#include "api/film_picture.h"
#include "render/film_file.h"
#include "util/file.h"

namespace snell {

namespace fs = std::filesystem;

static std::string Text(const render::PixelRect& r) {
  return fmt::format("{},{},{},{}", r.x0, r.y0, r.x1, r.y1);
}

render::Film FilmKeeper::Begin(const render::PixelRect& rect, std::uint32_t firstSample,
                               scene::RenderSettings& settings) const {
  if (options_.resume) RemoveAbandoned(options_.checkpoint);
  std::error_code ignored;
  if (!options_.resume || !fs::exists(options_.checkpoint, ignored))
    return render::Film(rect, firstSample);
  render::Film film = render::LoadFilm(options_.checkpoint);
  const auto fail = [&](const std::string& message) {
    throw Error(message, {options_.checkpoint.string()}, "to begin anew, leave out --resume");
  };
  if (film.rect() != rect)
    fail(fmt::format("the film holds the pixels {}, not {}", Text(film.rect()), Text(rect)));
  if (film.firstSample() != firstSample)
    fail(fmt::format("the film's samples begin at {}, not {}", film.firstSample(), firstSample));
  if (!film.merged().empty())
    fail("the film was merged from parts that leave gaps; a render cannot go on with it");
  const std::string spp = NoteOf(film, "spp");
  int value = 0;
  std::from_chars(spp.data(), spp.data() + spp.size(), value);
  if (value > 0) settings.spp = value;
  return film;
}

void FilmKeeper::SetAovs(std::optional<render::AovFilm> aovs, render::Film& film) const {
  if (film.Empty()) {
    film.aovs() = std::move(aovs);
    return;
  }
  const std::string difference = render::AovDifference(aovs, film.aovs());
  if (!difference.empty())
    throw Error(fmt::format("the film is of another render: now there are {}", difference),
                {options_.checkpoint.string()}, "to begin anew, leave out --resume");
}

void FilmKeeper::Save(const render::Film& film) {
  // What an earlier render has left is not lost because somebody forgot to resume
  const fs::path& path = options_.checkpoint;
  std::error_code ignored;
  if (!options_.resume && !saved_ && path != options_.output && fs::is_regular_file(path, ignored))
    fs::rename(path, fs::path(path) += "~", ignored);
  try {
    render::SaveFilm(film, path);
    saved_ = true;
  } catch (const Error& error) {
    const std::string text = fmt::format("the checkpoint could not be saved: {}", error.what());
    if (warnings_.empty() || warnings_.back() != text) warnings_.push_back(text);
  }
}

render::SavePlan FilmKeeper::Plan() {
  if (options_.checkpoint.empty()) return {};
  return {[this](const render::Film& film) { Save(film); }, options_.interval};
}

void FilmKeeper::Finish(const render::Film& film, bool stopped) {
  if (film.Empty()) return;
  if (stopped && !options_.checkpoint.empty()) Save(film);
  if (options_.output.empty()) return;
  try {
    render::SaveFilm(film, options_.output);
  } catch (const Error& error) {
    outputFault_ = error.what();
  }
}

}  // namespace snell
