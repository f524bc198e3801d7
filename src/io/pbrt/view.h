// SPDX-License-Identifier: Apache-2.0
//
// What stands before WorldBegin: camera, film, sampler, filter and integrator. pbrt is left-handed: by
// cross products alone, right is up × forward. Where the camera's transform does not mirror, the world is
// mirrored at z = 0, so that right-handed cross products give the same picture.
#pragma once

#include <optional>
#include <string>

#include "io/pbrt/context.h"
#include "io/pbrt/parameters.h"

namespace snell::io {

class PbrtView {
 public:
  explicit PbrtView(PbrtContext& context) : context_(context) {}

  // `cameraFromWorld` is the transform that stands before the camera, and `motion` how it moves.
  void ReadCamera(const std::string& type, const PbrtParameters& parameters,
                  const scene::Affine& cameraFromWorld, const scene::Motion& motion);
  void ReadFilm(const PbrtParameters& parameters);
  void ReadSampler(const std::string& type, const PbrtParameters& parameters);
  void ReadFilter(const std::string& type, const PbrtParameters& parameters);
  void ReadIntegrator(const std::string& type, const PbrtParameters& parameters);

  // From pbrt's world to ours.
  scene::Affine FromPbrt() const;
  // Writes the camera and the settings into the scene.
  void Finish();

 private:
  struct Camera {
    bool isOrthographic = false;
    bool isPanorama = false;
    scene::Affine worldFromCamera{1.0};
    float fov = 90;  // degrees, across the shorter side of a picture
    float frameAspectRatio = 0;
    std::vector<double> screenWindow;
    float lensRadius = 0;  // as the next: in the camera's space
    float focalDistance = 1e6f;
    scene::Motion motion;  // from the world
    double shutterOpen = 0;
    double shutterClose = 1;
    Place place;
  };
  double ScreenHeight() const;

  PbrtContext& context_;
  std::optional<Camera> camera_;
  int width_ = 1280;
  int height_ = 720;
  double exposureTime_ = 1;
  double iso_ = 100;
  int maxDepth_ = 5;
};

}  // namespace snell::io
