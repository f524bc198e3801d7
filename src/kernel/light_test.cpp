// SPDX-License-Identifier: Apache-2.0
//
// The light that a point receives, as the mean over 2^14 samples, against closed forms: the form factors of
// sphere, disk and polygons (Lambert 1760; Howell, Mengüç and Siegel, catalogue B-13 for the disk beside the
// axis), and that samples lie on the light and shadow rays end just before it.
#include "kernel/light.h"

#include <gtest/gtest.h>

#include "kernel/sobol.h"
#include "support/polygon_light.h"
#include "support/random.h"

namespace snell::kernel {
namespace {

constexpr double Pi64 = 3.141592653589793;
constexpr uint SampleCount = 1u << 14;

Light MakeLight(uint kind) {
  Light light = {};
  light.kind = kind;
  light.falloff = FALLOFF_INVERSE_SQUARE;
  light.emission = Spectrum(2.0f, 1.0f, 0.5f);
  light.direction = vec3(0, -1, 0);
  light.cosInner = -1;
  light.cosOuter = -1;
  light.factor = 1;
  return light;
}

Light MakePolygon(uint kind, vec3 corner, vec3 edgeU, vec3 edgeV) {
  Light light = MakeLight(kind);
  light.position = corner;
  light.edgeU = edgeU;
  light.edgeV = edgeV;
  light.direction = Normalize(Cross(edgeU, edgeV));
  light.area = Length(Cross(edgeU, edgeV)) * (kind == LIGHT_TRIANGLE ? 0.5f : 1.0f);
  return light;
}

Light MakeDisk(vec3 center, vec3 normal, float radius) {
  Light light = MakeLight(LIGHT_DISK);
  light.position = center;
  light.direction = normal;
  CoordinateSystem(normal, light.edgeU, light.edgeV);
  light.edgeU = light.edgeU * radius;
  light.edgeV = light.edgeV * radius;
  light.area = Pi * radius * radius;
  return light;
}

Light MakeSphere(uint kind, vec3 center, float radius) {
  Light light = MakeLight(kind);
  light.position = center;
  light.radius = radius;
  return light;
}

// Irradiance of a surface at p with normal n per unit of the light's second channel.
double Irradiance(const Light& light, glm::dvec3 p, glm::dvec3 n) {
  double sum = 0;
  for (uint i = 0; i < SampleCount; ++i) {
    const LightLiSample s = SampleLi(light, vec3(p), Sobol2D(i, 0x51u));
    sum += double(s.irradiance.y) * std::max(0.0, glm::dot(glm::dvec3(s.wi), n));
  }
  return sum / SampleCount;
}

TEST(SphereLight, HasItsFormFactorAtAnyDistance) {
  for (const double distance : {1.001, 1.5, 10.0, 1e3, 1e5}) {
    const Light light = MakeSphere(LIGHT_SPHERE, vec3(0, float(distance), 0), 1);
    // A surface that faces the light, and one so tilted that the light stays above its horizon
    const double sine = 1 / distance;
    EXPECT_NEAR(Irradiance(light, {0, 0, 0}, {0, 1, 0}) / (Pi64 * sine * sine), 1, 1e-3);
    const double tilt = 0.9 * std::acos(sine);
    EXPECT_NEAR(Irradiance(light, {0, 0, 0}, {std::sin(tilt), std::cos(tilt), 0}) /
                    (Pi64 * sine * sine * std::cos(tilt)),
                1, 2e-3)
        << distance;
  }
}

TEST(SphereLight, GivesPiFromInside) {
  test::Random random(111);
  for (int i = 0; i < 5; ++i) {
    const Light light = MakeSphere(LIGHT_SPHERE, vec3(1, 2, 3), 2);
    const glm::dvec3 p = glm::dvec3(1, 2, 3) + random.Direction() * random.Uniform(0, 1.9);
    EXPECT_NEAR(Irradiance(light, p, random.Direction()), Pi64, 5e-3);
  }
}

TEST(DiskLight, HasItsFormFactorOnTheAxis) {
  for (const double h : {0.05, 0.5, 2.0, 50.0}) {
    const Light light = MakeDisk(vec3(0, float(h), 0), vec3(0, -1, 0), 0.7f);
    EXPECT_NEAR(Irradiance(light, {0, 0, 0}, {0, 1, 0}) / (Pi64 * 0.49 / (0.49 + h * h)), 1, 6e-3)
        << h;
  }
}

TEST(DiskLight, HasItsFormFactorBesideTheAxis) {
  const Light light = MakeDisk(vec3(0, 1, 0), vec3(0, -1, 0), 0.7f);
  for (const double a : {0.3, 1.0, 3.0}) {
    const double z = 1 + a * a + 0.49;
    const double expected =
        Pi64 / 2 * (1 - (1 + a * a - 0.49) / std::sqrt(z * z - 4 * a * a * 0.49));
    EXPECT_NEAR(Irradiance(light, {a, 0, 0}, {0, 1, 0}) / expected, 1, 2e-3) << a;
  }
}

TEST(DiskLight, ShinesFromItsFrontOnly) {
  const Light light = MakeDisk(vec3(0, 1, 0), vec3(0, 1, 0), 0.7f);
  EXPECT_EQ(Irradiance(light, {0, 0, 0}, {0, 1, 0}), 0);
}

TEST(PolygonLights, ObeyLambertsFormula) {
  test::Random random(112);
  for (int i = 0; i < 40; ++i) {
    const bool triangle = i % 2 == 0;
    const glm::dvec3 p = random.InCube();
    const glm::dvec3 n = random.Direction();
    // Corners above the horizon, wound so that the front sees p
    glm::dvec3 corner = p + n * 1.5 + random.InCube();
    const glm::dvec3 u = random.InCube() * 0.4, v = random.InCube() * 0.4;
    const bool faces = glm::dot(glm::cross(u, v), corner - p) < 0;
    const Light light = MakePolygon(triangle ? LIGHT_TRIANGLE : LIGHT_RECTANGLE, vec3(corner),
                                    vec3(faces ? u : v), vec3(faces ? v : u));
    std::vector<glm::dvec3> corners = {corner, corner + u, corner + u + v, corner + v};
    if (triangle) corners.erase(corners.begin() + 2);
    const double expected = std::abs(test::PolygonIrradiance(p, n, corners));
    EXPECT_NEAR(Irradiance(light, p, n) / expected, 1, 3e-3) << i;
  }
}

TEST(PolygonLights, GiveTheKnownRadianceOfAFloor) {
  for (const auto& [corners, radiance] : test::TrianglesOverFloor) {
    EXPECT_NEAR(0.5 / Pi64 * std::abs(test::PolygonIrradiance({0, 0, 0}, {0, 1, 0}, corners)),
                radiance, 2e-6);
    glm::dvec3 u = corners[1] - corners[0], v = corners[2] - corners[0];
    if (glm::dot(glm::cross(u, v), corners[0]) > 0) std::swap(u, v);
    const Light light = MakePolygon(LIGHT_TRIANGLE, vec3(corners[0]), vec3(u), vec3(v));
    EXPECT_NEAR(0.5 / Pi64 * Irradiance(light, {0, 0, 0}, {0, 1, 0}), radiance, 2e-3 * radiance);
  }
}

TEST(PointLight, GivesIntensityOverDistanceSquared) {
  Light light = MakeLight(LIGHT_POINT);
  light.position = vec3(0, 3, 0);
  EXPECT_NEAR(Irradiance(light, {0, 0, 0}, {0, 1, 0}), 1 / 9.0, 1e-7);
  EXPECT_NEAR(Irradiance(light, {4, 0, 0}, {0, 1, 0}), 0.6 / 25, 1e-7);
  const LightLiSample s = SampleLi(light, vec3(0, 0, 0), vec2(0, 0));
  EXPECT_FLOAT_EQ(s.irradiance.x, 2.0f / 9);
  EXPECT_EQ(s.distance, 3.0f);
  light.falloff = FALLOFF_LINEAR;
  light.factor = 0.5f;
  EXPECT_NEAR(Irradiance(light, {0, 0, 0}, {0, 1, 0}), 1 / 1.5, 1e-6);
  light.falloff = FALLOFF_NONE;
  EXPECT_NEAR(Irradiance(light, {0, 0, 0}, {0, 1, 0}), 1, 1e-6);
  light.range = 4;
  EXPECT_NEAR(Irradiance(light, {0, 0, 0}, {0, 1, 0}), double(RangeWindow(3.0f, 4.0f)), 1e-6);
}

TEST(PointLight, WithARadiusIsASphereOfItsIntensity) {
  for (const uint kind : {LIGHT_POINT, LIGHT_SPOT}) {
    Light light = MakeSphere(kind, vec3(0, 3, 0), 0.8f);
    const Light sphere = MakeSphere(LIGHT_SPHERE, vec3(0, 3, 0), 0.8f);
    const double areaFactor = Pi64 * 0.64;
    for (const glm::dvec3 p : {glm::dvec3(0, 0, 0), glm::dvec3(1, 1.5, 0), glm::dvec3(0, 3.1, 0)}) {
      EXPECT_NEAR(Irradiance(light, p, {0, 1, 0}) * areaFactor, Irradiance(sphere, p, {0, 1, 0}),
                  1e-3);
    }
    // Outside it is the point light's own law
    EXPECT_NEAR(Irradiance(light, {0, 0, 0}, {0, 1, 0}), 1 / 9.0, 1e-4);
    // Without the physical law the radius softens shadows and changes brightness little
    light.falloff = FALLOFF_NONE;
    const double cosAlpha = std::sqrt(1 - 0.64 / 9);
    EXPECT_NEAR(Irradiance(light, {0, 0, 0}, {0, 1, 0}), 0.5 * (1 + cosAlpha), 1e-4);
  }
}

TEST(SpotLight, HasItsCone) {
  Light light = MakeLight(LIGHT_SPOT);
  light.position = vec3(0, 2, 0);
  light.cosInner = std::cos(0.3f);
  light.cosOuter = std::cos(0.5f);
  for (const double angle : {0.0, 0.2, 0.35, 0.4, 0.45, 0.6}) {
    const glm::dvec3 p(2 * std::tan(angle), 0, 0);
    const glm::dvec3 n = glm::normalize(glm::dvec3(0, 2, 0) - p);
    const double law = std::cos(angle) * std::cos(angle) / 4;
    const float cone = SpotFalloff(float(std::cos(angle)), light.cosInner, light.cosOuter);
    EXPECT_NEAR(Irradiance(light, p, n), law * double(cone), 1e-5) << angle;
  }
  // Behind a light with a full cone too
  light.cosInner = light.cosOuter = -1;
  EXPECT_NEAR(Irradiance(light, {0, 4, 0}, {0, -1, 0}), 0.25, 1e-6);
}

TEST(DirectionalLight, GivesItsIrradianceOnAFacingSurface) {
  Light light = MakeLight(LIGHT_DIRECTIONAL);
  EXPECT_NEAR(Irradiance(light, {5, 6, 7}, {0, 1, 0}), 1, 1e-6);
  EXPECT_NEAR(Irradiance(light, {5, 6, 7}, {0.6, 0.8, 0}), 0.8, 1e-6);
  // Half the angular size: the mean cosine of the cone
  for (const double half : {0.00465, 0.1, 0.5}) {
    light.oneMinusCos = float(2 * std::sin(half / 2) * std::sin(half / 2));
    const double mean = 0.5 * (1 + std::cos(half));
    EXPECT_NEAR(Irradiance(light, {0, 0, 0}, {0, 1, 0}), mean, 1e-5);
    EXPECT_NEAR(Irradiance(light, {0, 0, 0}, {0.6, 0.8, 0}), 0.8 * mean, 1e-4);
    for (uint i = 0; i < 1000; ++i) {
      const LightLiSample s = SampleLi(light, vec3(0, 0, 0), Sobol2D(i, 1u));
      EXPECT_LE(std::atan2(std::hypot(s.wi.x, s.wi.z), s.wi.y), float(half) * 1.00001f);
      EXPECT_GE(s.distance, 1e30f);
    }
  }
}

TEST(Lights, SampleTheirSurfaceAndEndShadowRaysJustBeforeIt) {
  test::Random random(113);
  for (std::uint64_t i = 0; i < test::Scaled(200000); ++i) {
    const double scale = random.LogUniform(1e-4, 1e5);
    const glm::dvec3 centre = random.InCube() * (scale * random.LogUniform(0.1, 100));
    const glm::dvec3 p = centre + random.Direction() * (scale * random.LogUniform(1.01, 1e4));
    const glm::dvec3 toP = glm::normalize(p - centre);
    const double extent = glm::length(p) + glm::length(centre) + scale;
    const vec2 u(random.UniformFloat(), random.UniformFloat());
    if (i % 4 == 0) {
      const Light light =
          MakeSphere(i % 8 == 0 ? LIGHT_SPHERE : LIGHT_POINT, vec3(centre), float(scale));
      const LightLiSample s = SampleLi(light, vec3(p), u);
      const glm::dvec3 o{vec3(p)}, w(s.wi), c(light.position);
      // Nearest approach to the centre within the radius, but for rounding
      const double along = glm::dot(c - o, w);
      const double miss = glm::length(o + w * along - c) - scale;
      const double slack = 1e-6 * extent;
      ASSERT_LE(miss, slack);
      const double depth = std::sqrt(std::max(0.0, scale * scale - std::pow(scale + miss, 2)));
      // At the sphere's rim the length is as uncertain as the root of the miss
      const double rim = std::sqrt(2 * scale * slack) + slack;
      ASSERT_LE(double(s.distance), along - depth + rim);
      ASSERT_GE(double(s.distance), along - depth - rim - 8 * slack);
      continue;
    }
    const vec3 normal(random.DirectionAbove(toP));
    vec3 edgeU, edgeV;
    CoordinateSystem(normal, edgeU, edgeV);
    edgeU *= float(scale);
    edgeV *= float(scale * random.LogUniform(0.1, 1));
    Light light = i % 4 == 1 ? MakeDisk(vec3(centre), normal, float(scale))
                             : MakePolygon(i % 4 == 2 ? LIGHT_TRIANGLE : LIGHT_RECTANGLE,
                                           vec3(centre), edgeU, edgeV);
    const LightLiSample s = SampleLi(light, vec3(p), u);
    const glm::dvec3 o{vec3(p)}, w(s.wi), n(light.direction), c(light.position);
    const double cosLight = std::max(std::abs(glm::dot(w, n)), 1e-3);
    const glm::dvec3 end = o + w * double(s.distance);
    // On the light's plane or a little before it, and within the light's extent
    const double before = glm::dot(end - c, n) * (glm::dot(w, n) < 0 ? 1 : -1);
    ASSERT_GE(before, -4e-7 * extent) << i % 4;
    ASSERT_LE(before, 1e-5 * extent / cosLight) << i % 4;
    ASSERT_LE(glm::length(end - c), 1.5 * scale + 1e-5 * extent / cosLight);
  }
}

TEST(SphereLight, EndsShadowRaysAtItsSurfaceFromFarAway) {
  for (const float distance : {1e2f, 1e3f, 1e4f}) {
    const Light light = MakeSphere(LIGHT_SPHERE, vec3(0, distance, 0), 1);
    for (uint i = 0; i < 1000; ++i) {
      const LightLiSample s = SampleLi(light, vec3(0, 0, 0), Sobol2D(i, 2u));
      EXPECT_LE(s.distance, distance);
      EXPECT_GE(s.distance, distance - 1 - 4e-6f * distance);
    }
  }
}

TEST(Lights, AreBlackAtTheirOwnPosition) {
  for (const uint kind : {LIGHT_POINT, LIGHT_SPOT}) {
    Light light = MakeLight(kind);
    light.position = vec3(1, 2, 3);
    const LightLiSample s = SampleLi(light, vec3(1, 2, 3), vec2(0.3f, 0.4f));
    EXPECT_TRUE(IsBlack(s.irradiance));
  }
  const Light square = MakePolygon(LIGHT_RECTANGLE, vec3(0, 0, 0), vec3(1, 0, 0), vec3(0, 0, 1));
  EXPECT_TRUE(IsBlack(SampleLi(square, vec3(0.5f, 0, 0.5f), vec2(0.5f, 0.5f)).irradiance));
}

}  // namespace
}  // namespace snell::kernel
