// SPDX-License-Identifier: Apache-2.0
#include "explain/recorder.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "util/text.h"

namespace snell::explain {

using namespace kernel;

namespace {

std::string Share(float x) { return fmt::format("{:.3g} %", 100 * double(x)); }

// The lobe that SampleBsdf chooses by this number.
std::string LobeAt(const Bsdf& b, const BsdfSample& way, float lobe) {
  if (lobe < b.pickCoat) return "reflection by the coat";
  lobe -= b.pickCoat;
  if (lobe < b.pickBase) {
    const std::string how = IsSmoothBase(b) ? "" : "rough ";
    if (way.transmitted == 0)
      return how + (b.metalness >= 1 ? "reflection by metal" : "reflection");
    return how + (b.thin == 1 ? "passage through a sheet" : "refraction");
  }
  lobe -= b.pickBase;
  if (lobe < b.pickDiffuse) return "diffuse reflection";
  if (lobe < b.pickDiffuse + b.pickDiffuseTransmission) return "diffuse transmission";
  lobe -= b.pickDiffuse + b.pickDiffuseTransmission;
  return lobe < b.pickSubsurface ? "entry below the surface" : "reflection by fuzz";
}

}  // namespace

void Recorder::BeginRay(const kernel::Ray& ray) {
  if (next_ < 0) {
    // A way on from the end of the current ray
    Segment made;
    made.parent = current_;
    made.kind = nextKind_;
    next_ = int(out_.rays.size());
    out_.rays.push_back(std::move(made));
  }
  current_ = next_;
  next_ = -1;
  Current().o = ray.o;
  Current().d = ray.d;
  time_ = ray.time;
}

void Recorder::Begins(const kernel::Ray& ray, Spectrum weight) {
  nextKind_ = "camera";
  BeginRay(ray);
  Current().weight = weight;
  next_ = current_;
  if (IsBlack(weight)) Note("the camera's lens lets nothing through here");
}

void Recorder::Follows(const kernel::Ray& ray, const Hit& hit, const SurfaceInteraction& it,
                       const MediumStack& media) {
  BeginRay(ray);
  Current().length = hit.primitive == None ? Infinite : it.t;
  for (std::uint32_t i = 0; i < media.count; ++i)
    Current().media.push_back(names_.Object(media.object[i]));
  if (hit.primitive == None) return;
  Surface surface;
  surface.object = names_.Object(it.object);
  surface.material = names_.Material(it.object);
  surface.place = names_.Place(it.object);
  surface.part = names_.Part(hit);
  surface.p = it.p;
  surface.n = it.n;
  surface.ns = it.ns;
  surface.uv = it.uv;
  surface.fromOutside = Dot(ray.d, it.n) < 0;
  Current().surface = std::move(surface);
  nextKind_ = "onward";
}

void Recorder::Leaves(const kernel::Ray& ray, Spectrum weight) {
  BeginRay(ray);
  Current().length = Infinite;
  Current().weight = weight;
}

void Recorder::Flies(std::uint32_t flight, float t, Spectrum weight) {
  Current().weight = weight;
  if (flight == FLIGHT_THROUGH) return;
  Current().surface.reset();
  Current().length = t;
  Current().scattered = flight == FLIGHT_SCATTERS;
  if (flight == FLIGHT_OVER) Note("ends: the medium absorbs it, or it may not scatter again");
}

void Recorder::ScattersInMedium(const kernel::Ray&) { nextKind_ = "scattered"; }

void Recorder::PassesOpening(float opacity) {
  Note(fmt::format("the surface is {} opaque here; the ray goes straight on", Share(opacity)));
  nextKind_ = "straight on";
}

void Recorder::PassesBoundary() {
  Note("this boundary is not there: the same medium lies on both sides");
  nextKind_ = "straight on";
}

void Recorder::Meets(const SurfaceInteraction& it, vec3 wo, float nearIor, float eta,
                     bool hasInside) {
  if (!Current().surface) return;
  Surface& surface = *Current().surface;
  surface.ns = it.ns;
  surface.refracts = hasInside;
  surface.nearIor = nearIor;
  surface.eta = eta;
  if (Dot(wo, it.n) * Dot(wo, it.ns) < 0)
    Note("the shading normal turns away from the ray, while the surface faces it");
  if (!hasInside) return;
  const float cosine = std::abs(Dot(wo, it.ns));
  const float refracted = RefractedCosine(cosine, eta);
  surface.totalReflection = refracted < 0;
  surface.fresnel = FrDielectric(cosine, refracted, eta);
}

void Recorder::Reads(std::uint32_t texture, vec2 uv, vec4 texel) {
  Current().reads.push_back({names_.Texture(texture), uv, texel});
}

void Recorder::MayScatter(bool deepest, bool hasScattering) {
  if (!hasScattering) Note("ends: the material only glows");
  if (deepest && hasScattering) Note("ends: it has reached max_depth");
}

void Recorder::Scatters(const PathVertex&, std::uint32_t lobes) {
  if (lobes != ALL_LOBES)
    Note("some kinds of scattering are left out here (limits of depth by kind, or caustics)");
}

void Recorder::Samples(const PathVertex& v, const BsdfSample& way, float lobe) {
  Current().way = Way{LobeAt(v.bsdf, way, lobe), way.pdf, way.weight};
  nextKind_ = way.wanders == 1       ? "below the surface"
              : way.transmitted == 1 ? "refracted"
                                     : "reflected";
  if (way.pdf <= 0) Note("ends: the sampled direction does not leave the surface");
}

void Recorder::SamplesWrongSide() {
  Current().way->pdf = 0;
  Note("ends: the direction lies on the other side of the surface than its shading normal says");
}

void Recorder::Survives(float chance, bool survives) {
  Note(fmt::format("{} by chance of {} (Russian roulette)", survives ? "goes on" : "ends",
                   Share(survives ? chance : 1 - chance)));
}

void Recorder::Divides(const Shares& shares, float) {
  if (IsBlack(shares.reflection) && IsBlack(shares.refraction)) return;
  const auto mean = [](Spectrum s) { return Share(MeanChannel(s)); };
  Note(fmt::format("of the light, its own colour sends {}, reflection {}, refraction {}",
                   mean(shares.own), mean(shares.reflection), mean(shares.refraction)));
}

void Recorder::MayBranch(bool deeper, Spectrum reflected, Spectrum refracted, float least) {
  const float most = std::max(MaxChannel(reflected), MaxChannel(refracted));
  if (most <= 0) return;
  if (!deeper)
    Note("no further rays: it has reached max_depth");
  else if (most < least)
    Note(fmt::format("no further rays: they would add less than {:.3g}", double(least)));
}

void Recorder::Branches(std::uint32_t kind, const kernel::Ray& ray, Spectrum weight) {
  static const char* const Kinds[3] = {"reflected", "refracted", "straight on"};
  Segment made;
  made.parent = current_;
  made.kind = Kinds[kind];
  made.o = ray.o;
  made.d = ray.d;
  made.weight = weight;
  branches_[kind] = int(out_.rays.size());
  out_.rays.push_back(std::move(made));
}

void Recorder::Drops() {
  out_.rays[std::size_t(aside_)].notes.emplace_back("left out: too many branches wait");
}

LightTry& Recorder::NewTry(std::string light) {
  source_ = light;
  Current().lights.emplace_back();
  Current().lights.back().light = std::move(light);
  Current().lights.back().outcome = "dark";
  return Current().lights.back();
}

void Recorder::Tries(std::uint32_t source) {
  if (source == None) {
    NewTry("no light").outcome = "none of the lights can reach this point";
    return;
  }
  NewTry(names_.Light(source));
}

void Recorder::TriesBackground() { NewTry("the background"); }

void Recorder::SeesLight(const LightLiSample& li, float pick) {
  LightTry& light = Current().lights.back();
  light.pick = pick;
  light.wi = li.wi;
  light.distance = li.distance;
  light.irradiance = li.irradiance;
  light.pdf = li.pdf;
  light.outcome = IsBlack(li.irradiance) ? "does not shine this way" : "";
}

void Recorder::FacesLight(bool faces) {
  LightTry& light = Current().lights.back();
  if (!faces && light.outcome.empty()) light.outcome = "is behind the surface";
}

void Recorder::SendsBack(Spectrum f, float pdf) {
  LightTry& light = Current().lights.back();
  light.f = f;
  light.bsdfPdf = pdf;
  if (!IsBlack(f) || !Current().surface) return;
  const bool behind =
      Dot(light.wi, Current().surface->n) * (Current().surface->fromOutside ? 1.0f : -1.0f) <= 0;
  light.outcome =
      behind ? "is behind the surface" : "nothing of it is scattered to the ray's origin";
}

std::string Recorder::BlockerOf(vec3 start, vec3 wi, float distance) const {
  kernel::Ray ray;
  ray.o = start;
  ray.d = wi;
  ray.time = time_;
  const bvh::Intersection found = bvh_.Closest(ray, distance, MASK_SHADOW);
  return found.primitive == None ? "" : names_.ObjectOf({found.primitive, found.instance});
}

void Recorder::Lights(vec3 start, const LightLiSample& li, Spectrum passed, float weight) {
  LightTry& light = Current().lights.back();
  light.start = start;
  light.passed = passed;
  light.weight = weight;
  light.outcome = "lit";
  if (!IsBlack(passed)) return;
  light.blocker = BlockerOf(start, li.wi, li.distance);
  light.outcome = light.blocker.empty() ? "absorbed on the way" : "blocked";
}

void Recorder::FindsBackground(float bsdfPdf, float lightPdf) {
  source_ = "the background";
  if (bsdfPdf > 0 && lightPdf > 0)
    source_ += fmt::format(" (weight {:.3g})", double(bsdfPdf / (bsdfPdf + lightPdf)));
}

void Recorder::FindsLight(std::uint32_t light, float weight) {
  source_ = names_.Light(light);
  if (weight < 1) source_ += fmt::format(" (weight {:.3g})", double(weight));
}

void Recorder::FindsGlow(float weight) {
  source_ = "the surface's own glow";
  if (weight < 1) source_ += fmt::format(" (weight {:.3g})", double(weight));
}

void Recorder::Shines(Spectrum own) {
  source_ =
      IsBlack(own) ? "the lights on this surface" : "this surface's glow and the lights on it";
}

void Recorder::Adds(Spectrum kept, Spectrum L) {
  // Zero changes no sum
  if (kept.x == 0 && kept.y == 0 && kept.z == 0 && L.x == 0 && L.y == 0 && L.z == 0) return;
  const bool held = kept.x != L.x || kept.y != L.y || kept.z != L.z;
  Current().terms.push_back(int(out_.terms.size()));
  out_.terms.push_back({kept, source_, held, current_});
}

}  // namespace snell::explain
