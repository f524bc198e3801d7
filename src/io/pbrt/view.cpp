// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "io/mesh/text.h"

namespace snell::io {

static constexpr int MaxResolution = 65536;
static constexpr int MaxSamples = 1 << 24;
static constexpr int MaxPathDepth = 1000;

void PbrtView::ReadCamera(const std::string& type, const PbrtParameters& parameters,
                          const scene::Affine& cameraFromWorld, const scene::Motion& motion) {
  Findings& findings = context_.findings;
  Camera camera;
  camera.place = parameters.place();
  camera.isOrthographic = type == "orthographic";
  const double determinant = glm::determinant(glm::dmat3(cameraFromWorld));
  camera.worldFromCamera = glm::inverse(cameraFromWorld);
  if (!(std::abs(determinant) > 0) || !std::isfinite(1 / determinant) ||
      !std::isfinite(glm::length(camera.worldFromCamera[3])))
    throw Error("the camera's transform cannot be undone", camera.place);

  camera.fov = parameters.Number("fov", type == "realistic" ? 40.0f : 90.0f);
  if (parameters.Has("halffov")) camera.fov = 2 * parameters.Number("halffov", 45);
  if (!(camera.fov > 0 && camera.fov < 180))
    throw Error("the field of view must lie between 0 and 180 degrees", camera.place);
  camera.frameAspectRatio = parameters.Number("frameaspectratio", 0);
  camera.screenWindow = parameters.Numbers("screenwindow", PbrtType::Float);
  if (!camera.screenWindow.empty()) {
    const std::vector<double>& w = camera.screenWindow;
    if (w.size() != 4 || !(w[1] > w[0]) || !(w[3] > w[2]))
      throw Error("the screen window needs four numbers: x from and to, y from and to",
                  parameters.Peek("screenwindow")->place);
  }
  camera.shutterOpen = double(parameters.Number("shutteropen", 0));
  camera.shutterClose = double(parameters.Number("shutterclose", 1));
  camera.motion = motion;
  exposureTime_ = camera.shutterClose - camera.shutterOpen;
  if (type == "perspective" || type == "orthographic") {
    camera.lensRadius = parameters.Number("lensradius", 0);
    camera.focalDistance = parameters.Number("focaldistance", 1e6f);
    if (camera.lensRadius < 0 || !(camera.focalDistance > 0))
      throw Error("a lens needs a radius that is not negative and a positive focal distance",
                  camera.place);
  } else if (type == "spherical") {
    camera.isPanorama = true;
    parameters.Ignore({"lensradius", "focaldistance"});
    const std::string mapping = parameters.String("mapping", "equalarea");
    if (mapping == "equalarea") {
      findings.Add("equal-area camera", "approximated by an equirectangular one", "", camera.place);
    } else if (mapping != "equirectangular") {
      throw Error(fmt::format("a spherical camera has no mapping {}", Quoted(mapping)),
                  camera.place);
    }
  } else if (type == "realistic") {
    parameters.Ignore({"lensradius", "focaldistance", "lensfile", "aperturediameter", "aperture"});
    findings.Add("'realistic' camera", "approximated by a perspective one", "", camera.place);
  } else {
    throw Error(fmt::format("there is no camera of type {}", Quoted(type)), camera.place);
  }
  camera_ = camera;
}

void PbrtView::ReadFilm(const PbrtParameters& parameters) {
  width_ = parameters.Integer("xresolution", width_);
  height_ = parameters.Integer("yresolution", height_);
  if (width_ < 1 || height_ < 1 || width_ > MaxResolution || height_ > MaxResolution)
    throw Error(fmt::format("the picture's size {}×{} is not between 1 and {}", width_, height_,
                            MaxResolution),
                parameters.place());
  iso_ = double(parameters.Number("iso", 100));
  parameters.Ignore(
      {"filename", "diagonal", "savefp16", "maxcomponentvalue", "coordinatesystem", "scale"});
  parameters.Leave({"cropwindow", "pixelbounds"}, "not used: the picture is rendered whole",
                   context_.findings);
  if (parameters.String("sensor", "cie1931") != "cie1931")
    context_.findings.Add("camera sensor", "replaced by the standard observer", "",
                          parameters.place());
  parameters.Leave({"whitebalance"}, "not used", context_.findings);
}

void PbrtView::ReadSampler(const std::string& type, const PbrtParameters& parameters) {
  std::int64_t samples = 16;
  if (type == "stratified")
    samples = std::int64_t(parameters.Integer("xsamples", 4)) * parameters.Integer("ysamples", 4);
  samples = parameters.Has("pixelsamples") ? parameters.Integer("pixelsamples", 16) : samples;
  if (samples < 1 || samples > MaxSamples)
    throw Error(fmt::format("the samples per pixel must be 1 to {}", MaxSamples),
                parameters.place());
  context_.scene.settings.spp = int(samples);
  if (parameters.Has("seed"))
    context_.scene.settings.seed = std::uint32_t(parameters.Integer("seed", 0));
  parameters.Ignore({"randomization", "jitter"});
}

void PbrtView::ReadFilter(const std::string& type, const PbrtParameters& parameters) {
  scene::RenderSettings& settings = context_.scene.settings;
  float radius = 1.5f;
  if (type == "box") {
    settings.filter = scene::PixelFilter::Box;
    radius = 0.5f;
  } else if (type == "triangle") {
    settings.filter = scene::PixelFilter::Tent;
    radius = 2;
  } else if (type == "gaussian") {
    settings.filter = scene::PixelFilter::Gaussian;
  } else {
    context_.findings.Add(fmt::format("{} filter", Quoted(type)),
                          "replaced by Blackman and Harris'", "", parameters.place());
    parameters.Ignore({"xradius", "yradius", "B", "C", "tau"});
    return;
  }
  const float x = parameters.Number("xradius", radius), y = parameters.Number("yradius", radius);
  if (x != y)
    context_.findings.Add("pixel filter", "with two radii: their mean counts", "",
                          parameters.place());
  settings.filterRadius = std::clamp((x + y) / 2, 0.25f, 16.0f);
  parameters.Ignore({"sigma"});
}

void PbrtView::ReadIntegrator(const std::string& type, const PbrtParameters& parameters) {
  maxDepth_ = std::clamp(parameters.Integer("maxdepth", 5), 0, MaxPathDepth);
  parameters.Ignore({"regularize", "lightsampler", "rrthreshold", "samplelights", "samplebsdf",
                     "maxdistance", "cossample", "visualizestrategies", "visualizeweights",
                     "photonsperiteration", "iterations", "radius", "seed", "bootstrapsamples",
                     "chains", "mutationsperpixel", "largestepprobability", "sigma"});
  // Any of them that shows the scene's light is what Snell's are
  if (type == "ambientocclusion" || type == "randomwalk" || type == "function")
    context_.findings.Add(fmt::format("{} integrator", Quoted(type)), "replaced by Snell's", "",
                          parameters.place());
}

scene::Affine PbrtView::FromPbrt() const {
  const bool isMirrored = camera_ && glm::determinant(glm::dmat3(camera_->worldFromCamera)) < 0;
  scene::Affine map(1.0);
  if (!isMirrored) map[2][2] = -1;
  return map;
}

// Of the window through which the camera looks, where 1 is half of a picture's shorter side.
double PbrtView::ScreenHeight() const {
  if (!camera_->screenWindow.empty()) return camera_->screenWindow[3] - camera_->screenWindow[2];
  const double ratio = double(width_) / height_;
  const double frame = camera_->frameAspectRatio > 0 ? double(camera_->frameAspectRatio) : ratio;
  return frame > 1 ? 2 : 2 / frame;
}

void PbrtView::Finish() {
  scene::RenderSettings& settings = context_.scene.settings;
  settings.width = width_;
  settings.height = height_;
  settings.maxDepth = maxDepth_ + 1;
  const double ratio = exposureTime_ * iso_ / 100;
  if (ratio > 0 && std::isfinite(std::log2(ratio))) settings.exposure = float(std::log2(ratio));
  if (!camera_) return;

  const scene::Affine toWorld = FromPbrt() * camera_->worldFromCamera;
  const glm::dvec3 position(toWorld[3]), forward(toWorld[2]), up(toWorld[1]);
  scene::Camera camera;
  camera.name = "camera";
  camera.position = scene::vec3(position);
  const double reach = std::max(1.0, glm::length(position));
  camera.lookAt = scene::vec3(position + glm::normalize(forward) * reach);
  camera.up = scene::vec3(glm::normalize(up));
  for (const scene::MotionKey& key : camera_->motion) {
    // pbrt's cameras look along z
    scene::Affine frame = FromPbrt() * glm::inverse(key.place);
    frame[2] = -frame[2];
    camera.motion.push_back({key.time, frame});
  }
  camera.shutterOpen = camera_->shutterOpen;
  camera.shutterClose = std::max(camera_->shutterOpen, camera_->shutterClose);
  camera.lens.radius = camera_->lensRadius * float(glm::length(up));
  camera.lens.focusDistance = camera_->focalDistance * float(glm::length(forward));
  if (const std::vector<double>& w = camera_->screenWindow; !w.empty())
    camera.shift =
        scene::vec2((w[0] + w[1]) / (2 * (w[1] - w[0])), (w[2] + w[3]) / (2 * (w[3] - w[2])));
  if (camera_->isPanorama) {
    // From the right by the front to the left
    camera.kind = scene::CameraKind::Panorama;
    camera.longitude = scene::vec2(0.5, -1.5) * std::numbers::pi_v<float>;
  } else if (camera_->isOrthographic) {
    camera.kind = scene::CameraKind::Orthographic;
    camera.height = float(ScreenHeight() * glm::length(up));
  } else {
    const double half = std::tan(double(camera_->fov) * std::numbers::pi / 360);
    camera.fov = float(2 * std::atan(half * ScreenHeight() / 2));
  }
  context_.scene.cameras.push_back(camera);

  // Pixels are squares
  const std::vector<double>& w = camera_->screenWindow;
  const double window =
      w.empty() ? double(camera_->frameAspectRatio) : (w[1] - w[0]) / (w[3] - w[2]);
  if (!camera_->isPanorama && window > 0 && std::abs(window * height_ / width_ - 1) > 0.01)
    context_.findings.Add("picture", "with pixels that are no squares: the height counts", "",
                          camera_->place);
}

}  // namespace snell::io
