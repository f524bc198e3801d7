// SPDX-License-Identifier: Apache-2.0
//
// The accumulating AOVs beside the film: sums in double precision per pixel of what is averaged, the nearest surface of
// what is not, counts of objects and materials. Samples are added by whoever owns the pixel, in order of their numbers.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "image/layer.h"
#include "kernel/aov.h"
#include "render/cryptomatte.h"
#include "render/denoise.h"
#include "render/film.h"
#include "scene/aov.h"

namespace snell::render {

// What the numbers in samples stand for.
struct AovNames {
  std::vector<std::string> objects;        // by the kernel's object
  std::vector<std::string> materials;      // names of materials
  std::vector<std::uint32_t> materialsOf;  // by the kernel's object, into `materials`
};

class AovFilm {
 public:
  // For the pixels of `rect`. `lightGroups` are the names as scene::LightGroupsOf gives them; `denoise` keeps two halves of
  // the samples apart.
  AovFilm(PixelRect rect, scene::AovSet wanted, std::vector<std::string> lightGroups, bool denoise);

  // About the memory that a pixel takes, here and in what is made of it.
  static std::uint64_t BytesPerPixel(scene::AovSet wanted,
                                     const std::vector<std::string>& lightGroups, bool denoise);

  // Before the first sample.
  void SetNames(AovNames names);

  // Add one sample. `L` is finite; what is not finite of the rest counts as 0.
  void Add(int x, int y, std::uint32_t number, kernel::Spectrum L, const kernel::AovSample& sample);

  // All that was asked for, in the order of scene::AovNames.
  image::Layers ToLayers() const;

  // For denoisers, if they were announced.
  DenoiseInput ToDenoiseInput() const;

  // All sums as bytes, for going on later, and back; the names are not among them. Load throws Error if the bytes are not
  // those of such a film.
  std::string Save() const;
  void Load(std::string_view bytes);

  scene::AovSet wanted() const { return wanted_; }
  std::uint64_t MemoryBytes() const;

 private:
  // What one pixel's sums begin with; those of light groups follow.
  enum Sum { Radiance, Square, Albedo, Normal, Nearness, Direct, FirstGroup };

  // Of the sample whose surface is nearest.
  struct Nearest {
    float depth = 0;
    kernel::vec3 position{0.0f};
    kernel::vec2 uv{0.0f};
  };

  std::size_t Pixels() const { return counts_.size() / halves_; }
  std::size_t Index(int x, int y) const {
    return std::size_t(y - rect_.y0) * std::size_t(rect_.Width()) + std::size_t(x - rect_.x0);
  }
  // The mean of one half of a pixel's samples, or of all of them.
  glm::dvec3 HalfMean(std::size_t pixel, std::size_t half, std::size_t sum) const;
  glm::dvec3 Mean(std::size_t pixel, std::size_t sum) const;
  std::uint32_t Count(std::size_t pixel) const;
  glm::dvec3 VarianceOf(std::size_t pixel) const;
  void AddColors(const std::string& name, std::size_t sum, image::Layers& layers) const;
  template <class Values>
  void AddLayer(std::string name, std::vector<std::string> channels, bool isColor, Values values,
                image::Layers& layers) const;

  PixelRect rect_;
  scene::AovSet wanted_;
  std::vector<std::string> lightGroups_;
  std::size_t halves_;  // 1: all samples are together
  std::size_t stride_;
  AovNames names_;
  std::vector<std::uint32_t> objectIds_;    // by the kernel's object
  std::vector<std::uint32_t> materialIds_;  // the same
  std::vector<std::uint32_t> counts_;       // by pixel and half
  std::vector<glm::dvec3> sums_;            // by pixel, half and Sum
  std::vector<Nearest> nearest_;
  std::vector<Coverage> objects_;
  std::vector<Coverage> materials_;
};

}  // namespace snell::render
