// SPDX-License-Identifier: Apache-2.0
//
// The accumulating AOVs beside the film: sums per pixel of what is averaged, the nearest surface of what is not, counts of
// objects and materials. All of it is exact (exact_sum.h), so that like the film it is saved, gone on with and merged to
// the bit, whatever the order of the samples.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "image/layer.h"
#include "kernel/aov.h"
#include "render/cryptomatte.h"
#include "render/denoise.h"
#include "render/exact_sum.h"
#include "render/pixel_rect.h"
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

  // An empty one of the same kind.
  AovFilm Like(PixelRect rect) const;

  // Before the first sample. False if what was loaded has other names.
  bool SetNames(const AovNames& names);

  // Add one sample. `L` is finite; what is not finite of the rest counts as 0.
  void Add(int x, int y, std::uint32_t number, kernel::Spectrum L, const kernel::AovSample& sample);
  // Add other samples, of pixels that are all here.
  void Add(const AovFilm& other);

  // All that was asked for, in the order of scene::AovNames.
  image::Layers ToLayers() const;

  // For denoisers, if they were announced.
  DenoiseInput ToDenoiseInput() const;

  // All of it as bytes, handed out in pieces (aov_file.cpp).
  using Sink = std::function<void(const void* bytes, std::size_t size)>;
  void Save(const Sink& write) const;
  // And back, from so many bytes, which `read` hands out. Takes no more memory than they. Throws Error if they are not
  // those of a film of the rectangle, or of pixels that no render makes.
  using Source = std::function<void(void* bytes, std::size_t size)>;
  static AovFilm Load(PixelRect rect, std::uint64_t size, const Source& read);

  scene::AovSet wanted() const { return wanted_; }
  bool denoises() const { return halves_ == 2; }
  std::uint32_t SampleCount(int x, int y) const { return Count(rect_.Index(x, y)); }
  std::uint64_t MemoryBytes() const;

  // How `other` differs from this in kind, in words: "layers albedo, not normal"; "" if not at all. Names
  // that have not been set yet do not count.
  std::string Difference(const AovFilm& other) const;
  // "albedo, normal, denoising"
  std::string KindText() const;

 private:
  // What pixels have sums of; those of light groups follow.
  enum Sum { Radiance, Square, Albedo, Normal, Nearness, Direct, SumCount };
  static constexpr std::size_t Unwanted = std::size_t(-1);
  using Sum3 = std::array<ExactSum, 3>;

  // Of the sample whose surface is nearest, the first of them.
  struct Nearest {
    float depth;
    std::uint32_t number;
    kernel::vec3 position{0.0f};
    kernel::vec2 uv{0.0f};

    bool operator<(const Nearest& other) const {
      return std::tie(depth, number) < std::tie(other.depth, other.number);
    }
  };

  // Where each Sum lies among a half's, and how many there are without light groups.
  static std::size_t PlaceSums(scene::AovSet wanted, bool denoise,
                               std::array<std::size_t, SumCount>& places);

  std::size_t Pixels() const { return counts_.size() / halves_; }
  // The mean of one half of a pixel's samples, or of all of them; `place` as in places_.
  glm::dvec3 HalfMean(std::size_t pixel, std::size_t half, std::size_t place) const;
  glm::dvec3 Mean(std::size_t pixel, std::size_t place) const;
  std::uint32_t Count(std::size_t pixel) const;
  glm::dvec3 VarianceOf(std::size_t pixel) const;
  bool IsSound() const;
  void AddColors(const std::string& name, std::size_t place, image::Layers& layers) const;
  template <class Values>
  void AddLayer(std::string name, std::vector<std::string> channels, bool isColor, Values values,
                image::Layers& layers) const;

  PixelRect rect_;
  scene::AovSet wanted_;
  std::vector<std::string> lightGroups_;
  std::size_t halves_;  // 1: all samples are together
  std::array<std::size_t, SumCount> places_;
  std::size_t firstGroup_;
  std::size_t stride_;
  std::vector<std::string> objectNames_;    // each once, sorted
  std::vector<std::string> materialNames_;  // the same
  std::vector<std::uint32_t> objectIds_;    // by the kernel's object
  std::vector<std::uint32_t> materialIds_;  // the same
  std::vector<std::uint32_t> counts_;       // by pixel and half
  std::vector<Sum3> sums_;                  // by pixel, half and place
  std::vector<Nearest> nearest_;
  std::vector<Coverage> objects_;
  std::vector<Coverage> materials_;
};

}  // namespace snell::render
