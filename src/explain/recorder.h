// SPDX-License-Identifier: Apache-2.0
//
// Listens to a sample while the kernel makes it: the functions here are what TELL(…) calls in src/kernel, where each stands
// beside what it tells. Nothing that is told changes the sample.
#pragma once

#include <array>

#include "bvh/bvh.h"
#include "explain/explanation.h"
#include "explain/names.h"
#include "kernel/values.h"

namespace snell::explain {

class Recorder {
 public:
  // Writes into `explanation`, which must be new; all must outlive the recorder.
  Recorder(const Names& names, const cpu::FlatScene& flat, const bvh::Bvh& bvh,
           Explanation& explanation)
      : names_(names), flat_(flat), bvh_(bvh), out_(explanation) {}

  // Rays
  void Begins(const kernel::Ray& ray, kernel::Spectrum weight);
  void Follows(const kernel::Ray& ray, const kernel::Hit& hit, const kernel::SurfaceInteraction& it,
               const kernel::MediumStack& media);
  void Leaves(const kernel::Ray& ray, kernel::Spectrum weight);
  void Flies(std::uint32_t flight, float t, kernel::Spectrum weight);
  void ScattersInMedium(const kernel::Ray& ray);
  void PassesOpening(float opacity);
  void PassesBoundary();

  // Surfaces
  void Meets(const kernel::SurfaceInteraction& it, kernel::vec3 wo, float nearIor, float eta,
             bool hasInside);
  void Reads(std::uint32_t texture, kernel::vec2 uv, kernel::vec4 texel);
  void MayScatter(bool deepest, bool hasScattering);
  void Scatters(const kernel::PathVertex& v, std::uint32_t lobes);
  void Samples(const kernel::PathVertex& v, const kernel::BsdfSample& way, float lobe);
  void SamplesWrongSide();
  void Survives(float chance, bool survives);

  // The branches of a tree
  void Divides(const kernel::Shares& shares, float fresnel);
  void MayBranch(bool deeper, kernel::Spectrum reflected, kernel::Spectrum refracted, float least);
  void Branches(std::uint32_t kind, const kernel::Ray& ray, kernel::Spectrum weight);
  void SetsAside(std::uint32_t kind) { aside_ = branches_[kind]; }
  void Takes(std::uint32_t kind) { next_ = branches_[kind]; }
  void Waits(std::uint32_t slot) { waiting_[slot] = aside_; }
  void Resumes(std::uint32_t slot) { next_ = waiting_[slot]; }
  void Drops();

  // Lights that are looked for
  void Tries(std::uint32_t source);
  void TriesBackground();
  void SeesLight(const kernel::LightLiSample& li, float pick);
  void FacesLight(bool faces);
  void SendsBack(kernel::Spectrum f, float pdf);
  void Lights(kernel::vec3 start, const kernel::LightLiSample& li, kernel::Spectrum passed,
              float weight);

  // Light that is found, and what it adds
  void FindsBackground(float bsdfPdf, float lightPdf);
  void FindsAmbient() { source_ = "the ambient light"; }
  void FindsLight(std::uint32_t light, float weight);
  void FindsGlow(float weight);
  void FindsMediumGlow() { source_ = "a glowing medium"; }
  void Shines(kernel::Spectrum own);
  void Adds(kernel::Spectrum kept, kernel::Spectrum L);

 private:
  Segment& Current() { return out_.rays[std::size_t(current_)]; }
  void Note(std::string note) { Current().notes.push_back(std::move(note)); }
  void BeginRay(const kernel::Ray& ray);
  LightTry& NewTry(std::string light);
  std::string BlockerOf(kernel::vec3 start, kernel::vec3 wi, float distance) const;

  const Names& names_;
  const cpu::FlatScene& flat_;
  const bvh::Bvh& bvh_;
  Explanation& out_;

  int current_ = -1;      // the ray that is being followed
  int next_ = -1;         // one that has been made and is to be followed next; −1: a new one
  std::string nextKind_;  // of a new one
  float time_ = 0;
  std::string source_;                       // of what is added next
  std::array<int, 3> branches_{-1, -1, -1};  // the newest by kind
  int aside_ = -1;
  std::array<int, kernel::WhittedStackSize> waiting_{};
};

}  // namespace snell::explain
