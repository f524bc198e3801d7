// SPDX-License-Identifier: Apache-2.0
//
// The scattering of a physical (OpenPBR) surface at one point, seen from one direction: a coat over fuzz-free base,
// fuzz above all. The base is a rough conductor beside a rough dielectric, whose inside is diffuse or clear. Energy
// that the single-scattering microfacet lobes lose is given back by factors (Turquin 2019, "Practical multiple
// scattering compensation for microfacet models"), and what lies below a layer gets what the layer lets through on
// average; both come from tables (scene_bsdf.h fills the record). Directions are in the surface's frame, z along
// the shading normal on wo's side; Eval, Sample and Pdf agree, and each is a sum over the lobes.
#ifndef SNELL_KERNEL_BSDF_H
#define SNELL_KERNEL_BSDF_H

#include "kernel/diffuse.h"
#include "kernel/fresnel.h"
#include "kernel/lobes.h"
#include "kernel/microfacet.h"
#include "kernel/sampling.h"
#include "kernel/thin_film.h"

KERNEL_BEGIN

struct BsdfSample {
  vec3 wi;
  Spectrum weight;   // f · |cos θ| / pdf
  float pdf;         // per solid angle; 0: no sample
  uint isSpecular;   // 1: a direction of a perfectly smooth lobe, which Eval and Pdf do not see
  uint transmitted;  // 1: on the other side
  uint wanders;      // 1: below the surface; Eval and Pdf do not see it
  uint isDiffuse;    // 1: of a matt or fuzzy surface's reflection
};

FN BsdfSample NoBsdfSample() {
  BsdfSample s;
  s.wi = vec3(0.0f, 0.0f, 1.0f);
  s.weight = Spectrum(0.0f, 0.0f, 0.0f);
  s.pdf = 0.0f;
  s.isSpecular = 0u;
  s.transmitted = 0u;
  s.wanders = 0u;
  s.isDiffuse = 0u;
  return s;
}

// Reflectance of a conductor: Schlick's with a tint that is strongest near 82° (Kutz, Hasan and Edmondson 2021,
// "Novel aspects of the Adobe Standard Material").
FN Spectrum FrConductorF82(Spectrum f0, Spectrum tint, float cosine) {
  float mu = Clamp(cosine, 0.0f, 1.0f);
  Spectrum schlick = FrSchlick(f0, mu);
  Spectrum at82 = FrSchlick(f0, 0.142857142857f);
  Spectrum one = Spectrum(1.0f, 1.0f, 1.0f);
  float m = 1.0f - mu;
  float m2 = m * m;
  // The polynomial is 1 at μ = 1/7
  Spectrum dip = at82 * (one - tint) * (17.6512851f * mu * m2 * m2 * m2);
  return schlick - dip;
}

FN float FrOfEta(float cosine, float eta) {
  return FrDielectric(cosine, RefractedCosine(cosine, eta), eta);
}

// What the base's boundary reflects, before its energy is put right: as a metal,
FN Spectrum MetalFresnel(IN(Bsdf) b, float cosine) {
  Spectrum metal = FrConductorF82(b.metalF0, b.metalTint, cosine);
  if (b.film > 0.0f)
    metal =
        Lerp(b.film, metal, FrFilmOnConductor(cosine, b.filmEta, b.filmPath, b.metalEta, b.metalK));
  return metal * b.metalWeight;
}
// and as a dielectric.
FN Spectrum DielectricFresnel(IN(Bsdf) b, float cosine) {
  float bare = FrOfEta(cosine, b.etaFresnel);
  Spectrum fresnel = Spectrum(bare, bare, bare);
  Spectrum one = Spectrum(1.0f, 1.0f, 1.0f);
  if (b.film > 0.0f)
    fresnel =
        Lerp(b.film, fresnel, FrFilmOnDielectric(cosine, b.filmEta, b.filmPath, b.etaFresnel));
  // The back of a sheet reflects, too, if light gets there
  bool clear = MaxChannel(b.transmissionScale) > 0.0f;
  if (b.thin == 1u) return clear ? fresnel * 2.0f / (one + fresnel) : fresnel;
  // What cannot be refracted is reflected
  if (clear && RefractedCosine(cosine, b.eta) < 0.0f) return one;
  return fresnel;
}

// What the base sends back, and lets through, per microfacet whose normal makes this cosine with wo, and the share of
// the base's samples that are reflections there.
struct BaseSplit {
  Spectrum reflectance;
  Spectrum transmittance;
  float share;
};
FN BaseSplit SplitAtBase(IN(Bsdf) b, float cosine) {
  BaseSplit split;
  split.reflectance = Spectrum(0.0f, 0.0f, 0.0f);
  split.transmittance = split.reflectance;
  if (b.metalness > 0.0f) split.reflectance = MetalFresnel(b, cosine) * b.metalScale * b.metalness;
  if (b.metalness < 1.0f) {
    Spectrum fresnel = DielectricFresnel(b, cosine);
    Spectrum one = Spectrum(1.0f, 1.0f, 1.0f);
    split.reflectance += b.reflectionScale * fresnel * (1.0f - b.metalness);
    if (b.closed == 0u)
      split.transmittance = b.transmissionScale * (one - fresnel) * (1.0f - b.metalness);
  }
  float r = MeanChannel(split.reflectance);
  float t = MeanChannel(split.transmittance);
  split.share = r + t > 0.0f ? r / (r + t) : 1.0f;
  return split;
}

// Whether it is matt, with nothing else to choose and nothing above.
FN bool IsLambertian(IN(Bsdf) b) {
  return b.pickDiffuse == 1.0f && b.diffuseRoughness == 0.0f && b.coat <= 0.0f &&
         b.underFuzz == 1.0f;
}
FN bool IsSmoothBase(IN(Bsdf) b) { return Max(b.alpha.x, b.alpha.y) < SmoothAlpha; }
FN bool IsSmoothCoat(IN(Bsdf) b) { return Max(b.coatAlpha.x, b.coatAlpha.y) < SmoothAlpha; }
// Whether it only mirrors and refracts.
FN bool IsPerfectlySmooth(IN(Bsdf) b) {
  return b.pickDiffuse + b.pickDiffuseTransmission + b.pickSubsurface + b.pickFuzz <= 0.0f &&
         IsSmoothBase(b) && (b.coat <= 0.0f || IsSmoothCoat(b));
}

// Whether EvalBsdf sees light from the other side.
FN bool Transmits(IN(Bsdf) b) {
  return b.pickDiffuseTransmission > 0.0f ||
         (!IsSmoothBase(b) && MaxChannel(b.transmissionScale) > 0.0f);
}

// Between the frame of the base and that of the coat, whose normal may be another.
FN vec3 ToCoat(IN(Bsdf) b, vec3 w) {
  if (b.coatTilted == 0u) return w;
  return vec3(Dot(w, b.coatX), Dot(w, Cross(b.coatZ, b.coatX)), Dot(w, b.coatZ));
}
FN vec3 FromCoat(IN(Bsdf) b, vec3 w) {
  if (b.coatTilted == 0u) return w;
  return b.coatX * w.x + Cross(b.coatZ, b.coatX) * w.y + b.coatZ * w.z;
}

// Passing the coat once takes the root of its colour at normal incidence; the exponent grows with the way's length.
FN Spectrum CoatPassage(float coat, float eta, Spectrum color, float cosine) {
  Spectrum one = Spectrum(1.0f, 1.0f, 1.0f);
  if (MaxChannel(one - color) <= 0.0f) return one;
  float e = 0.5f / Max(RefractedCosine(abs(cosine), eta), 0.05f);
  return Lerp(coat, one, Spectrum(Pow(color.x, e), Pow(color.y, e), Pow(color.z, e)));
}

// What reaches the base and comes back, on the ways along wo and wi.
FN Spectrum ThroughLayers(IN(Bsdf) b, vec3 wo, vec3 wi) {
  if (b.coat <= 0.0f) return b.underCoat * b.underFuzz;
  return b.underCoat * CoatPassage(b.coat, b.coatEta, b.coatTint, wo.z) *
         CoatPassage(b.coat, b.coatEta, b.coatTint, wi.z) * b.underFuzz;
}

FN float FuzzDistribution(float alpha, float cosHalf) {
  float inverse = 1.0f / alpha;
  float sine2 = Max(1.0f - cosHalf * cosHalf, 0.0078125f);
  return (2.0f + inverse) * Pow(sine2, 0.5f * inverse) * Inv2Pi;
}

// Fuzz of colour 1: Estevez and Kulla 2017, "Production friendly microfacet sheen BRDF", times the cosine of wi.
FN float EvalFuzz(float alpha, vec3 wo, vec3 wi) {
  vec3 h = Normalize(wo + wi);
  return FuzzDistribution(alpha, Clamp(h.z, 0.0f, 1.0f)) * wi.z /
         (4.0f * (wi.z + wo.z - wi.z * wo.z));
}

// All lobes that are not perfectly smooth: returns f · |cos θ| and, in `pdf`, the density of SampleBsdf.
FN Spectrum EvalBsdf(IN(Bsdf) b, vec3 wo, vec3 wi, OUT(float) pdf) {
  Spectrum f = Spectrum(0.0f, 0.0f, 0.0f);
  pdf = 0.0f;
  if (wo.z <= 0.0f || wi.z == 0.0f) return f;
  if (IsLambertian(b)) {
    pdf = Max(wi.z, 0.0f) * InvPi;
    return b.diffuse * pdf;
  }
  Spectrum through = ThroughLayers(b, wo, wi);
  if (wi.z < 0.0f) {
    // Through the surface
    if (b.pickDiffuseTransmission > 0.0f) {
      f += through * b.diffuseTransmission * (-wi.z * InvPi);
      pdf += b.pickDiffuseTransmission * (-wi.z * InvPi);
    }
    if (IsSmoothBase(b) || MaxChannel(b.transmissionScale) <= 0.0f) return f;
    if (b.thin == 1u) {
      // As the reflection, mirrored to the other side
      vec3 mirrored = vec3(wi.x, wi.y, -wi.z);
      vec3 m = Normalize(wo + mirrored);
      float cosine = Dot(wo, m);
      BaseSplit split = SplitAtBase(b, cosine);
      f += through * split.transmittance *
           (GgxDistribution(b.alpha, m) * GgxMasking(b.alpha, wo, mirrored) / (4.0f * wo.z));
      pdf += b.pickBase * (1.0f - split.share) * PdfGgxVisible(b.alpha, wo, m) / (4.0f * cosine);
      return f;
    }
    vec3 m = wi * b.eta + wo;
    if (LengthSquared(m) == 0.0f) return f;
    m = Normalize(m);
    if (m.z < 0.0f) m = -m;
    float cosOut = Dot(wo, m);
    float cosIn = Dot(wi, m);
    if (cosOut <= 0.0f || cosIn >= 0.0f) return f;
    float jacobian = -cosIn / Sqr(cosIn + cosOut / b.eta);
    BaseSplit split = SplitAtBase(b, cosOut);
    // Radiance is squeezed into the smaller cone of directions, by 1/η²
    f += through * split.transmittance *
         (GgxDistribution(b.alpha, m) * GgxMasking(b.alpha, wo, wi) * cosOut * jacobian /
          (wo.z * b.eta * b.eta));
    pdf += b.pickBase * (1.0f - split.share) * PdfGgxVisible(b.alpha, wo, m) * jacobian;
    return f;
  }

  if (b.pickDiffuse > 0.0f) {
    f += through * EvalEon(b.diffuse, b.diffuseColor, b.diffuseRoughness, wo, wi) * wi.z;
    pdf += b.pickDiffuse * wi.z * InvPi;
  }
  vec3 m = Normalize(wo + wi);
  float cosine = Max(Dot(wo, m), 1e-7f);
  if (b.pickBase > 0.0f && !IsSmoothBase(b)) {
    BaseSplit split = SplitAtBase(b, cosine);
    f += through * split.reflectance *
         (GgxDistribution(b.alpha, m) * GgxMasking(b.alpha, wo, wi) / (4.0f * wo.z));
    pdf += b.pickBase * split.share * PdfGgxVisible(b.alpha, wo, m) / (4.0f * cosine);
  }
  if (b.pickCoat > 0.0f && !IsSmoothCoat(b)) {
    vec3 coatWo = ToCoat(b, wo);
    vec3 coatWi = ToCoat(b, wi);
    if (coatWo.z > 0.0f && coatWi.z > 0.0f) {
      vec3 coatM = Normalize(coatWo + coatWi);
      float reflectance = b.coatScale * FrOfEta(cosine, b.coatEta) *
                          GgxDistribution(b.coatAlpha, coatM) *
                          GgxMasking(b.coatAlpha, coatWo, coatWi) / (4.0f * coatWo.z);
      f += Spectrum(reflectance, reflectance, reflectance);
      pdf += b.pickCoat * PdfGgxVisible(b.coatAlpha, coatWo, coatM) / (4.0f * cosine);
    }
  }
  if (b.pickFuzz > 0.0f) {
    f += b.fuzz * EvalFuzz(b.fuzzAlpha, wo, wi);
    pdf += b.pickFuzz * Inv2Pi;
  }
  return f;
}

// A sample of a lobe that is perfectly smooth, chosen with probability `pick`.
FN BsdfSample SmoothSample(vec3 wi, Spectrum reflectance, float pick) {
  BsdfSample s;
  s.wi = wi;
  s.weight = reflectance / pick;
  s.pdf = pick;
  s.isSpecular = 1u;
  s.transmitted = wi.z < 0.0f ? 1u : 0u;
  s.wanders = 0u;
  s.isDiffuse = 0u;
  return s;
}

// A direction by `lobe` ∈ [0, 1), which chooses the lobe, and u ∈ [0, 1)².
FN BsdfSample SampleBsdf(IN(Bsdf) b, vec3 wo, float lobe, vec2 u) {
  if (wo.z <= 0.0f) return NoBsdfSample();
  vec3 wi;
  bool isDiffuse = false;
  float left = lobe;
  if (left < b.pickCoat) {
    vec3 coatWo = ToCoat(b, wo);
    if (coatWo.z <= 0.0f) return NoBsdfSample();
    vec3 m = vec3(0.0f, 0.0f, 1.0f);
    if (!IsSmoothCoat(b)) m = SampleGgxVisible(b.coatAlpha, coatWo, u);
    wi = -Reflect(coatWo, m);
    if (wi.z <= 0.0f) return NoBsdfSample();
    wi = FromCoat(b, wi);
    if (wi.z <= 0.0f) return NoBsdfSample();
    if (IsSmoothCoat(b)) {
      float reflectance = b.coatScale * FrOfEta(coatWo.z, b.coatEta);
      return SmoothSample(wi, Spectrum(reflectance, reflectance, reflectance), b.pickCoat);
    }
  } else if ((left -= b.pickCoat) < b.pickBase) {
    // A microfacet, then to which side
    bool even = IsSmoothBase(b);
    vec3 m = vec3(0.0f, 0.0f, 1.0f);
    if (!even) m = SampleGgxVisible(b.alpha, wo, u);
    float cosine = Dot(wo, m);
    if (cosine <= 0.0f) return NoBsdfSample();
    BaseSplit split = SplitAtBase(b, cosine);
    if (left < b.pickBase * split.share) {
      wi = -Reflect(wo, m);
      if (even)
        return SmoothSample(wi, split.reflectance * ThroughLayers(b, wo, wi),
                            b.pickBase * split.share);
      if (wi.z <= 0.0f) return NoBsdfSample();
    } else if (b.thin == 1u) {
      vec3 mirrored = -Reflect(wo, m);
      if (mirrored.z <= 0.0f) return NoBsdfSample();
      wi = even ? -wo : vec3(mirrored.x, mirrored.y, -mirrored.z);
      if (even)
        return SmoothSample(wi, split.transmittance * ThroughLayers(b, wo, wi),
                            b.pickBase * (1.0f - split.share));
    } else {
      wi = Refract(-wo, m, cosine, RefractedCosine(cosine, b.eta), b.eta);
      if (even)
        return SmoothSample(wi, split.transmittance * ThroughLayers(b, wo, wi) / (b.eta * b.eta),
                            b.pickBase * (1.0f - split.share));
      if (wi.z >= 0.0f) return NoBsdfSample();
    }
  } else if ((left -= b.pickBase) < b.pickDiffuse + b.pickDiffuseTransmission) {
    vec2 disk = SampleUniformDisk(u);
    float z = SafeSqrt(1.0f - disk.x * disk.x - disk.y * disk.y);
    wi = vec3(disk.x, disk.y, left < b.pickDiffuse ? z : -z);
    isDiffuse = left < b.pickDiffuse && MaxChannel(b.diffuse) > 0.0f;
  } else if ((left -= b.pickDiffuse + b.pickDiffuseTransmission) < b.pickSubsurface) {
    vec2 disk = SampleUniformDisk(u);
    wi = vec3(disk.x, disk.y, -SafeSqrt(1.0f - disk.x * disk.x - disk.y * disk.y));
    BsdfSample entry = SmoothSample(wi, b.subsurface * ThroughLayers(b, wo, wi), b.pickSubsurface);
    entry.wanders = 1u;
    return entry;
  } else {
    float sine = SafeSqrt(1.0f - u.x * u.x);
    float s;
    float c;
    SinCos(2.0f * Pi * u.y, s, c);
    wi = vec3(sine * c, sine * s, u.x);
    isDiffuse = true;
  }
  BsdfSample s;
  s.wi = wi;
  s.isSpecular = 0u;
  s.transmitted = wi.z < 0.0f ? 1u : 0u;
  s.wanders = 0u;
  s.isDiffuse = isDiffuse ? 1u : 0u;
  if (IsLambertian(b)) {
    s.pdf = wi.z * InvPi;
    s.weight = b.diffuse;
    return s;
  }
  Spectrum f = EvalBsdf(b, wo, wi, s.pdf);
  if (s.pdf <= 0.0f) return NoBsdfSample();
  s.weight = f / s.pdf;
  return s;
}

KERNEL_END

#endif
