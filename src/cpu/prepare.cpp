// SPDX-License-Identifier: Apache-2.0
#include "cpu/prepare.h"

#include <fmt/format.h>

#include "cpu/aov_names.h"
#include "cpu/flatten_camera.h"
#include "cpu/origin.h"
#include "render/film_file.h"
#include "util/error.h"
#include "util/timer.h"

namespace snell::cpu {

namespace {

// A better tree costs a fraction of a second per million triangles. The choice depends on the scene alone, so
// that a part of a picture is made as the whole.
bvh::BuildQuality QualityFor(const FlatScene& flat) {
  return flat.triangles.size() < 4000000 ? bvh::BuildQuality::High : bvh::BuildQuality::Fast;
}

// Samples of another picture must not be added to the film's.
void CheckOrigin(const FlatScene& flat, const render::RenderRequest& request, render::Film& film) {
  const render::FilmOrigin origin{SamplesDependOn(flat, request.settings, request.program), {}};
  if (film.origin().samples.empty()) {
    film.origin().samples = origin.samples;
    return;
  }
  const std::string difference = render::Difference(origin, film.origin());
  if (!difference.empty())
    throw Error(fmt::format("the film is of another render: now there is {}", difference),
                {request.filmFile}, "to begin anew, leave out --resume");
}

FlatScene FlattenFor(const scene::Scene& scene, const render::RenderRequest& request,
                     render::Film& film, Progress* progress, render::Statistics& statistics) {
  if (progress) progress->Begin("building", 0);
  const Timer timer;
  FlatScene flat = Flatten(scene, request.settings, request.camera);
  statistics.flattenSeconds = timer.Seconds();
  statistics.warnings = flat.warnings;
  if (request.wantsOrigin) CheckOrigin(flat, request, film);
  return flat;
}

}  // namespace

PreparedScene::PreparedScene(const scene::Scene& scene, const render::RenderRequest& request,
                             render::Film& film, Progress* progress, render::Statistics& statistics)
    : flat_(FlattenFor(scene, request, film, progress, statistics)),
      geometry_(flat_.Geometry()),
      bvh_(geometry_, QualityFor(flat_)) {
  statistics.buildSeconds = sinceFlattened_.Seconds();
  if (film.aovs() && !film.aovs()->SetNames(AovNamesOf(scene, flat_)))
    throw Error("the film is of another render: objects or materials have other names",
                {request.filmFile}, "to begin anew, leave out --resume");
  statistics.droppedPrimitives = bvh_.droppedPrimitives();
  statistics.sceneBytes = flat_.MemoryBytes();
  statistics.bvhBytes = bvh_.MemoryBytes();
  if (progress) progress->End();
}

void PreparedScene::SetCamera(const scene::Camera& camera, const scene::RenderSettings& settings) {
  ReplaceCamera(camera, settings, flat_);
}

}  // namespace snell::cpu
