// SPDX-License-Identifier: Apache-2.0
//
// Reflection at a thin film on a dielectric or a metal: Airy's sum of all reflections between its two faces (Born and
// Wolf, Principles of Optics, section 7.6.1), as a series in the waves that differ by m ways through the film, each
// averaged over what red, green and blue see of the spectrum (Belcour and Barla 2017, "A practical extension to
// microfacet theory for the modeling of varying iridescence", section 4). Lengths are in micrometres.
#ifndef SNELL_KERNEL_THIN_FILM_H
#define SNELL_KERNEL_THIN_FILM_H

#include "kernel/fresnel.h"
#include "kernel/types.h"

KERNEL_BEGIN

// Beyond this difference of path the colours see no interference.
CONST float FilmCoherence = 17.0f;
CONST uint FilmOrders = 10u;

// Amplitudes that are reflected, per channel: re + i·im of the waves across and along the plane of incidence.
struct FilmAmplitudes {
  Spectrum acrossRe;
  Spectrum acrossIm;
  Spectrum alongRe;
  Spectrum alongIm;
};

// The mean of exp(2πi · path / λ) over the light that a channel sees of daylight: `re` and `im`. The responses (CIE 1931,
// D65, Rec.709) as nine normal distributions over 1/λ, from 1.52/µm in steps of 0.115/µm, of the width 0.0575/µm, fitted
// to 0.003 (thin_film_test.cpp).
FN void MeanWave(float path, OUT(Spectrum) re, OUT(Spectrum) im) {
  re = Spectrum(0.0f, 0.0f, 0.0f);
  im = re;
  if (path > FilmCoherence) return;
  float c;
  float s;
  SinCos(9.5504417f * path, s, c);
  float turnC;
  float turnS;
  SinCos(0.72256631f * path, turnS, turnC);
  for (uint k = 0u; k < 9u; ++k) {
    Spectrum weight = k == 0u   ? Spectrum(0.07313f, -0.01102f, 0.00023f)
                      : k == 1u ? Spectrum(1.06473f, -0.07912f, -0.01172f)
                      : k == 2u ? Spectrum(0.39922f, 0.37237f, -0.0551f)
                      : k == 3u ? Spectrum(-0.34279f, 0.57053f, -0.05688f)
                      : k == 4u ? Spectrum(-0.20979f, 0.20968f, 0.01734f)
                      : k == 5u ? Spectrum(-0.07438f, 0.03108f, 0.26525f)
                      : k == 6u ? Spectrum(0.04774f, -0.05595f, 0.58252f)
                      : k == 7u ? Spectrum(0.04013f, -0.03584f, 0.23965f)
                                : Spectrum(0.00202f, -0.00173f, 0.01871f);
    re += weight * c;
    im += weight * s;
    float next = c * turnC - s * turnS;
    s = s * turnC + c * turnS;
    c = next;
  }
  float fade = Exp(-0.06526157f * path * path);  // 2π² · 0.0575²
  re = re * fade;
  im = im * fade;
}

// At the boundary of two dielectrics, for cosines as in FrDielectric.
FN vec2 FrAmplitudes(float cosIncident, float cosRefracted, float eta) {
  return vec2((cosIncident - eta * cosRefracted) / (cosIncident + eta * cosRefracted),
              (eta * cosIncident - cosRefracted) / (eta * cosIncident + cosRefracted));
}

FN FilmAmplitudes DielectricBelowFilm(float cosIncident, float cosRefracted, float eta) {
  vec2 r = FrAmplitudes(cosIncident, cosRefracted, eta);
  FilmAmplitudes below;
  below.acrossRe = Spectrum(r.x, r.x, r.x);
  below.alongRe = Spectrum(r.y, r.y, r.y);
  below.acrossIm = Spectrum(0.0f, 0.0f, 0.0f);
  below.alongIm = below.acrossIm;
  return below;
}

// (a + ib) / (c + id)
FN vec2 Quotient(vec2 a, vec2 b) {
  float inverse = 1.0f / Max(b.x * b.x + b.y * b.y, 1e-20f);
  return vec2((a.x * b.x + a.y * b.y) * inverse, (a.y * b.x - a.x * b.y) * inverse);
}

// At the boundary to a conductor of relative index eta + ik: across in x and y, along in z and w.
FN vec4 ConductorAmplitudes(float cosIncident, float eta, float k) {
  // w = η cos θ of the refracted wave
  vec2 square = vec2(eta * eta - k * k, 2.0f * eta * k);
  float real = square.x - (1.0f - cosIncident * cosIncident);
  float size = sqrt(real * real + square.y * square.y);
  vec2 w = vec2(SafeSqrt(0.5f * (size + real)), SafeSqrt(0.5f * (size - real)));
  vec2 across = Quotient(vec2(cosIncident - w.x, -w.y), vec2(cosIncident + w.x, w.y));
  vec2 along = Quotient(vec2(square.x * cosIncident - w.x, square.y * cosIncident - w.y),
                        vec2(square.x * cosIncident + w.x, square.y * cosIncident + w.y));
  return vec4(across.x, across.y, along.x, along.y);
}
FN float FrConductor(float cosIncident, float eta, float k) {
  vec4 r = ConductorAmplitudes(cosIncident, eta, k);
  return 0.5f * (r.x * r.x + r.y * r.y + r.z * r.z + r.w * r.w);
}

FN FilmAmplitudes ConductorBelowFilm(float cosIncident, Spectrum eta, Spectrum k) {
  vec4 red = ConductorAmplitudes(cosIncident, eta.x, k.x);
  vec4 green = ConductorAmplitudes(cosIncident, eta.y, k.y);
  vec4 blue = ConductorAmplitudes(cosIncident, eta.z, k.z);
  FilmAmplitudes below;
  below.acrossRe = Spectrum(red.x, green.x, blue.x);
  below.acrossIm = Spectrum(red.y, green.y, blue.y);
  below.alongRe = Spectrum(red.z, green.z, blue.z);
  below.alongIm = Spectrum(red.w, green.w, blue.w);
  return below;
}

// One polarisation's share of (1 − r²)(1 − |b|²) / |1 + r·b·wave|², from the terms of the series (Poisson's kernel) that
// `series` has added up.
FN Spectrum FilmTransmittance(float r, Spectrum bRe, Spectrum bIm, Spectrum series) {
  Spectrum one = Spectrum(1.0f, 1.0f, 1.0f);
  Spectrum square = bRe * bRe + bIm * bIm;
  Spectrum tail = one - square * (r * r);
  tail = Spectrum(Max(tail.x, 1e-4f), Max(tail.y, 1e-4f), Max(tail.z, 1e-4f));
  return (one - square) * (1.0f - r * r) / tail * series;
}

// Reflectance of a film: `r` are the amplitudes of its upper face, `below` those of its lower one, `path` is twice its
// thickness times its index times the cosine inside.
RARE_FN Spectrum FilmReflectance(vec2 r, IN(FilmAmplitudes) below, float path) {
  Spectrum one = Spectrum(1.0f, 1.0f, 1.0f);
  Spectrum zero = Spectrum(0.0f, 0.0f, 0.0f);
  Spectrum across = one;
  Spectrum along = one;
  // The powers of −r·b, and the waves that they come with
  Spectrum acrossRe = below.acrossRe * -r.x;
  Spectrum acrossIm = below.acrossIm * -r.x;
  Spectrum alongRe = below.alongRe * -r.y;
  Spectrum alongIm = below.alongIm * -r.y;
  Spectrum pRe = one;
  Spectrum pIm = zero;
  Spectrum qRe = one;
  Spectrum qIm = zero;
  for (uint m = 1u; m <= FilmOrders; ++m) {
    Spectrum next = pRe * acrossRe - pIm * acrossIm;
    pIm = pRe * acrossIm + pIm * acrossRe;
    pRe = next;
    next = qRe * alongRe - qIm * alongIm;
    qIm = qRe * alongIm + qIm * alongRe;
    qRe = next;
    Spectrum re;
    Spectrum im;
    MeanWave(path * float(m), re, im);
    across += (pRe * re - pIm * im) * 2.0f;
    along += (qRe * re - qIm * im) * 2.0f;
    if (MaxChannel(Abs(pRe) + Abs(pIm) + Abs(qRe) + Abs(qIm)) < 2e-3f) break;
  }
  Spectrum passed = (FilmTransmittance(r.x, below.acrossRe, below.acrossIm, across) +
                     FilmTransmittance(r.y, below.alongRe, below.alongIm, along)) *
                    0.5f;
  return Saturate(one - passed);
}

// Of a film of relative index `filmEta` on a dielectric of relative index `eta`; `filmPath` is twice its thickness
// times its index.
RARE_FN Spectrum FrFilmOnDielectric(float cosine, float filmEta, float filmPath, float eta) {
  Spectrum all = Spectrum(1.0f, 1.0f, 1.0f);
  float inside = RefractedCosine(cosine, filmEta);
  if (inside <= 0.0f) return all;
  float behind = RefractedCosine(inside, eta / filmEta);
  if (behind <= 0.0f) return all;
  return FilmReflectance(FrAmplitudes(cosine, inside, filmEta),
                         DielectricBelowFilm(inside, behind, eta / filmEta), filmPath * inside);
}
RARE_FN Spectrum FrFilmOnConductor(float cosine, float filmEta, float filmPath, Spectrum eta,
                                   Spectrum k) {
  float inside = RefractedCosine(cosine, filmEta);
  if (inside <= 0.0f) return Spectrum(1.0f, 1.0f, 1.0f);
  return FilmReflectance(FrAmplitudes(cosine, inside, filmEta),
                         ConductorBelowFilm(inside, eta / filmEta, k / filmEta), filmPath * inside);
}

// The index of refraction n + ik, as (n, k), of a conductor by what it reflects at normal incidence and at the cosine
// 1/7. Of all that reflect f0 (Gulbrandsen 2014, "Artist friendly metallic Fresnel", equation 5) the one with the
// greatest n has the deepest dip there.
RARE_FN vec2 ConductorIor(float f0, float f82) {
  float r = Clamp(f0, 1e-3f, 0.995f);
  float root = sqrt(r);
  float low = (1.0f - r) / (1.0f + r);
  float high = (1.0f + root) / (1.0f - root);
  vec2 ior = vec2(low, 0.0f);
  for (uint i = 0u; i < 10u; ++i) {
    float n = sqrt(low * high);
    float k = SafeSqrt((r * Sqr(n + 1.0f) - Sqr(n - 1.0f)) / (1.0f - r));
    ior = vec2(n, k);
    if (FrConductor(0.142857142857f, n, k) > f82) {
      low = n;
    } else {
      high = n;
    }
  }
  return ior;
}

KERNEL_END

#endif
