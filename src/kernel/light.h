// SPDX-License-Identifier: Apache-2.0
//
// Sampling the light that reaches a point from one light source, one switch over their kinds. Spheres are
// sampled by the solid angle that they fill (pbrt-v4, section 6.2.4), rectangles, too, where it is not tiny, other flat areas
// by their surface.
#ifndef SNELL_KERNEL_LIGHT_H
#define SNELL_KERNEL_LIGHT_H

#include "kernel/falloff.h"
#include "kernel/ray.h"
#include "kernel/sampling.h"
#include "kernel/spherical_rectangle.h"

KERNEL_BEGIN

struct LightLiSample {
  vec3 wi;              // unit direction to the light
  float distance;       // that the shadow ray may go, metres
  Spectrum irradiance;  // on a surface that faces the light, of this sample alone; black: no light
};

// A point on a light's surface as seen from p: how far a shadow ray goes so that it ends just before it,
// also where another surface lies directly behind the light.
FN float DistanceToLight(vec3 p, vec3 onLight, vec3 n, vec3 wi, float distance) {
  vec3 extent = Abs(p) + Abs(onLight);
  float margin = Gamma(32.0f) * (extent.x + extent.y + extent.z);
  float cosLight = Max(abs(Dot(n, wi)), 1e-3f);
  return Max(distance - margin / cosLight, 0.0f);
}

FN LightLiSample SampleFlatLight(IN(Light) light, vec3 p, vec3 onLight) {
  LightLiSample s;
  vec3 toLight = onLight - p;
  float distance = Length(toLight);
  s.wi = toLight / distance;
  float cosLight = -Dot(light.direction, s.wi);
  s.distance = DistanceToLight(p, onLight, light.direction, s.wi, distance);
  float geometry = 0.0f;
  if (cosLight > 0.0f && distance > 0.0f) {
    geometry = cosLight * light.area * DistanceFalloff(light.falloff, distance, light.factor);
  }
  s.irradiance = light.emission * (geometry * RangeWindow(distance, light.range));
  return s;
}

// A rectangle near by is sampled by its solid angle, else by its area.
FN bool HasSphericalRectangle(IN(Light) light) {
  return light.kind == LIGHT_RECTANGLE && light.falloff == FALLOFF_INVERSE_SQUARE;
}
FN LightLiSample SampleRectangleLight(IN(Light) light, vec3 p, vec2 u) {
  vec3 byArea = light.position + light.edgeU * u.x + light.edgeV * u.y;
  if (!HasSphericalRectangle(light)) return SampleFlatLight(light, p, byArea);
  SphericalRectangle seen = SphericalRectangleAt(p, light.position, light.edgeU, light.edgeV);
  if (seen.solidAngle == 0.0f) return SampleFlatLight(light, p, byArea);
  LightLiSample s;
  vec3 toLight = SampleSphericalRectangle(seen, u);
  float distance = Length(toLight);
  s.wi = toLight / distance;
  s.distance = DistanceToLight(p, p + toLight, light.direction, s.wi, distance);
  bool isLit = Dot(light.direction, s.wi) < 0.0f;
  s.irradiance =
      light.emission * (isLit ? seen.solidAngle * RangeWindow(distance, light.range) : 0.0f);
  return s;
}

// A sphere of radiance L and radius r: uniform over the directions that it fills as seen from p. Returns the
// solid angle in `solidAngle`; from inside, all directions.
FN LightLiSample SampleSphereDirections(vec3 center, float radius, vec3 p, vec2 u,
                                        OUT(float) solidAngle) {
  LightLiSample s;
  vec3 toCenter = center - p;
  float distance = Length(toCenter);
  if (distance <= radius) {
    float z = 1.0f - 2.0f * u.x;
    float r = SafeSqrt(1.0f - z * z);
    float sine;
    float cosine;
    SinCos(2.0f * Pi * u.y, sine, cosine);
    s.wi = vec3(r * cosine, r * sine, z);
    solidAngle = 4.0f * Pi;
    float along = Dot(toCenter, s.wi);
    s.distance = along + SafeSqrt(along * along + (radius * radius - distance * distance));
  } else {
    vec3 axis = toCenter / distance;
    float sin2 = Sqr(radius / distance);
    float oneMinusCos = sin2 / (1.0f + SafeSqrt(1.0f - sin2));
    vec3 local = SampleUniformCone(u, oneMinusCos);
    vec3 tangent;
    vec3 bitangent;
    CoordinateSystem(axis, tangent, bitangent);
    s.wi = Normalize(tangent * local.x + bitangent * local.y + axis * local.z);
    solidAngle = 2.0f * Pi * oneMinusCos;
    // The sample's own sine keeps the digits of half the chord for far, small spheres
    float sample2 = local.x * local.x + local.y * local.y;
    s.distance = distance * local.z - SafeSqrt(radius * radius - distance * distance * sample2);
  }
  s.distance = DistanceToLight(p, center, s.wi, s.wi, s.distance);
  s.irradiance = Spectrum(0.0f, 0.0f, 0.0f);
  return s;
}

// Their density.
FN float PdfSphereDirections(vec3 center, float radius, vec3 p) {
  float distance = Length(center - p);
  if (distance <= radius) return 0.25f * InvPi;
  float sin2 = Sqr(radius / distance);
  return Inv2Pi * (1.0f + SafeSqrt(1.0f - sin2)) / sin2;
}

// What a sphere's solid angle stands for: its intensity per radiance, π r², with the light's falloff.
FN float SphereStrength(IN(Light) light, float distance, float solidAngle) {
  if (light.falloff == FALLOFF_INVERSE_SQUARE) return solidAngle;
  return Pi * light.radius * light.radius * DistanceFalloff(light.falloff, distance, light.factor);
}

// Light from a point or spot light. One with a radius is a sphere of the same intensity: physically so
// under the inverse-square law, else only in its shadows.
FN LightLiSample SamplePointLight(IN(Light) light, vec3 p, vec2 u) {
  LightLiSample s;
  vec3 toLight = light.position - p;
  float distance = Length(toLight);
  float strength = DistanceFalloff(light.falloff, distance, light.factor);
  if (light.radius > 0.0f) {
    float solidAngle;
    s = SampleSphereDirections(light.position, light.radius, p, u, solidAngle);
    strength = SphereStrength(light, distance, solidAngle) / (Pi * light.radius * light.radius);
  } else {
    s.wi = toLight / distance;
    s.distance = distance;
  }
  if (light.kind == LIGHT_SPOT) {
    strength *=
        SpotFalloff(-Dot(light.direction, toLight) / distance, light.cosInner, light.cosOuter);
  }
  if (distance <= 0.0f) strength = 0.0f;
  s.irradiance = light.emission * (strength * RangeWindow(distance, light.range));
  return s;
}

FN LightLiSample SampleDirectionalLight(IN(Light) light, vec2 u) {
  LightLiSample s;
  vec3 axis = -light.direction;
  s.wi = axis;
  if (light.oneMinusCos > 0.0f) {
    vec3 local = SampleUniformCone(u, light.oneMinusCos);
    vec3 tangent;
    vec3 bitangent;
    CoordinateSystem(axis, tangent, bitangent);
    s.wi = Normalize(tangent * local.x + bitangent * local.y + axis * local.z);
  }
  s.distance = Infinite;
  s.irradiance = light.emission;
  return s;
}

// One sample, by u ∈ [0, 1)², of the light that p receives directly; the mean over samples is the whole.
FN LightLiSample SampleLi(IN(Light) light, vec3 p, vec2 u) {
  switch (light.kind) {
    case LIGHT_POINT:
    case LIGHT_SPOT: return SamplePointLight(light, p, u);
    case LIGHT_DIRECTIONAL: return SampleDirectionalLight(light, u);
    case LIGHT_TRIANGLE: {
      vec2 b = SampleUniformTriangle(u);
      return SampleFlatLight(light, p, light.position + light.edgeU * b.x + light.edgeV * b.y);
    }
    case LIGHT_DISK: {
      vec2 disk = SampleUniformDisk(u);
      return SampleFlatLight(light, p,
                             light.position + light.edgeU * disk.x + light.edgeV * disk.y);
    }
    case LIGHT_SPHERE: {
      float solidAngle;
      LightLiSample s = SampleSphereDirections(light.position, light.radius, p, u, solidAngle);
      float distance = Length(light.position - p);
      float strength = SphereStrength(light, distance, solidAngle);
      s.irradiance = light.emission * (strength * RangeWindow(distance, light.range));
      return s;
    }
  }
  return SampleRectangleLight(light, p, u);
}

// The density of SampleLi, per solid angle at p, of the direction wi in which an area light is met at a distance, or
// the disc of a directional light.
FN float PdfLi(IN(Light) light, vec3 p, vec3 wi, float distance) {
  if (light.kind == LIGHT_DIRECTIONAL) return Inv2Pi / light.oneMinusCos;
  if (light.kind == LIGHT_SPHERE) return PdfSphereDirections(light.position, light.radius, p);
  float cosLight = -Dot(light.direction, wi);
  if (cosLight <= 0.0f) return 0.0f;
  if (HasSphericalRectangle(light)) {
    float solidAngle = SphericalRectangleAt(p, light.position, light.edgeU, light.edgeV).solidAngle;
    if (solidAngle > 0.0f) return 1.0f / solidAngle;
  }
  return Sqr(distance) / (cosLight * light.area);
}

// Radiance of a directional light's disc, black beside it.
FN Spectrum SunLe(IN(Light) light, vec3 d) {
  // The squared chord between the directions is twice 1 − their cosine and keeps the digits of narrow discs
  if (LengthSquared(d + light.direction) >= 2.0f * light.oneMinusCos)
    return Spectrum(0.0f, 0.0f, 0.0f);
  return light.emission * (Inv2Pi / light.oneMinusCos);
}

KERNEL_END

#endif
