// SPDX-License-Identifier: Apache-2.0
//
// The CPU as a device: the same film at any number of threads, whole or in parts; a render that is stopped
// leaves a sound film; what is reported is true.
#include "cpu/render_cpu.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <mutex>
#include <string>

#include "scene/validate.h"
#include "util/threads.h"

namespace snell::cpu {
namespace {

using kernel::Spectrum;
using kernel::vec3;
using render::Film;
using render::PixelRect;
using render::RenderRequest;
using render::Statistics;

constexpr PixelRect Whole{0, 0, 70, 50};

// Two spheres on a checker, one of glass and one mirror, under two lights, one of them soft.
scene::Scene SpheresOnPlane() {
  scene::Scene scene;
  scene.name = "spheres";
  scene.settings.width = Whole.x1;
  scene.settings.height = Whole.y1;
  scene.environment.top = Spectrum(0.2f, 0.3f, 0.5f);
  scene::Camera camera;
  camera.position = vec3(0, 1.5f, 6);
  camera.lookAt = vec3(0, 0.8f, 0);
  scene.cameras = {camera};
  scene::Light point;
  point.position = vec3(3, 5, 4);
  point.strength = 60;
  scene::Light soft = point;
  soft.position = vec3(-4, 4, 2);
  soft.radius = 0.5f;
  scene.lights = {point, soft};
  scene::Texture checker;
  scene.textures = {checker};
  scene::Material floor, glass, mirror;
  floor.terms.resize(1);
  floor.terms[0].color.texture = 0;
  glass.reflectivity.value = glass.transparency.value = Spectrum(1.0f);
  glass.reflection = scene::ReflectionModel::Fresnel;
  mirror.reflectivity.value = Spectrum(0.9f, 0.8f, 0.6f);
  scene.materials = {floor, glass, mirror};
  const auto add = [&](const scene::Geometry& geometry, int material) {
    scene::Object object;
    object.geometry = geometry;
    object.material = material;
    scene.objects.push_back(object);
  };
  add(scene::Plane{}, 0);
  add(scene::Sphere{vec3(-1, 1, 0), 1}, 1);
  add(scene::Sphere{vec3(1.2f, 1, -0.5f), 1}, 2);
  scene::Validate(scene, nullptr);
  return scene;
}

RenderRequest RequestOf(const scene::Scene& scene, std::uint32_t last, PixelRect rect = Whole) {
  return {scene.settings, scene.cameras.at(0), rect, last};
}

Film Rendered(const scene::Scene& scene, std::uint32_t samples, PixelRect rect = Whole) {
  Film film(rect);
  CpuRenderer().Render(scene, RequestOf(scene, samples, rect), film, nullptr, nullptr);
  return film;
}

// The number of pixels in which two films differ, within the first's rectangle.
int Difference(const Film& a, const Film& b) {
  const image::Image imageA = a.ToImage(), imageB = b.ToImage();
  int different = 0;
  for (int y = a.rect().y0; y < a.rect().y1; ++y) {
    for (int x = a.rect().x0; x < a.rect().x1; ++x) {
      const auto at = [&](const Film& film, const image::Image& image) {
        return image.pixels[std::size_t(y - film.rect().y0) * std::size_t(image.width) +
                            std::size_t(x - film.rect().x0)];
      };
      const vec3 p = at(a, imageA), q = at(b, imageB);
      different += std::memcmp(&p, &q, sizeof p) != 0 || a.SampleCount(x, y) != b.SampleCount(x, y);
    }
  }
  return different;
}

TEST(CpuRenderer, GivesTheSameFilmAtAnyNumberOfThreads) {
  const scene::Scene scene = SpheresOnPlane();
  const auto render = [&](int threads) {
    const ThreadLimit limit(threads);
    return Rendered(scene, 6);
  };
  const Film one = render(1);
  for (const int threads : {2, 3, 0}) EXPECT_EQ(Difference(one, render(threads)), 0) << threads;
  EXPECT_EQ(one.SampleCount(69, 49), 6u);
}

TEST(CpuRenderer, GivesTheSameFilmInParts) {
  const scene::Scene scene = SpheresOnPlane();
  const Film whole = Rendered(scene, 6);
  // Samples in two goes
  Film film(Whole);
  CpuRenderer().Render(scene, RequestOf(scene, 1), film, nullptr, nullptr);
  CpuRenderer().Render(scene, RequestOf(scene, 6), film, nullptr, nullptr);
  EXPECT_EQ(Difference(film, whole), 0);
  // A part of the picture, and single pixels
  for (const PixelRect rect : {PixelRect{11, 7, 60, 33}, PixelRect{0, 0, 1, 1}, {69, 49, 70, 50}})
    EXPECT_EQ(Difference(Rendered(scene, 6, rect), whole), 0);
}

TEST(CpuRenderer, DependsOnSeedAndSamples) {
  scene::Scene scene = SpheresOnPlane();
  const Film film = Rendered(scene, 2);
  scene.settings.seed = 1;
  EXPECT_GT(Difference(film, Rendered(scene, 2)), 500);
}

// Watches a render and raises a flag after so many samples.
class Watcher : public Progress {
 public:
  explicit Watcher(std::uint64_t stopAt = std::numeric_limits<std::uint64_t>::max())
      : stopAt_(stopAt) {}

  void Begin(std::string_view phase, std::uint64_t total) override {
    log += std::string(phase) + " ";
    totalSteps = total;
    most = 0;
  }
  void Update(std::uint64_t done, std::uint64_t rays) override {
    const std::lock_guard lock(mutex_);
    most = std::max(most, done);
    mostRays = std::max(mostRays, rays);
    if (done >= stopAt_) flag.Raise();
  }
  void End() override { log += "end "; }

  StopFlag flag;
  std::string log;
  std::uint64_t totalSteps = 0;
  std::uint64_t most = 0;
  std::uint64_t mostRays = 0;

 private:
  std::mutex mutex_;
  std::uint64_t stopAt_;
};

TEST(CpuRenderer, ReportsProgressAndWhatItDid) {
  const scene::Scene scene = SpheresOnPlane();
  Film film(Whole);
  Watcher watcher;
  const Statistics s =
      CpuRenderer().Render(scene, RequestOf(scene, 5), film, &watcher, &watcher.flag);
  const std::uint64_t samples = 70 * 50 * 5;
  EXPECT_EQ(watcher.log, "building end rendering end ");
  EXPECT_EQ(watcher.totalSteps, samples);
  EXPECT_EQ(watcher.most, samples);
  EXPECT_EQ(watcher.mostRays, s.rays.Sum());
  EXPECT_EQ(s.samples, samples);
  EXPECT_EQ(s.rays.camera, samples);
  EXPECT_GT(s.rays.reflected, 0u);
  EXPECT_GT(s.rays.refracted, 0u);
  EXPECT_GT(s.rays.shadow, 0u);
  EXPECT_EQ(s.nonFiniteSamples + s.droppedPrimitives, 0u);
  EXPECT_EQ(s.filmBytes, film.MemoryBytes());
  EXPECT_GT(s.sceneBytes, 0u);
  EXPECT_GT(s.bvhBytes, 0u);
  EXPECT_EQ(s.threads, ActiveThreads());
  EXPECT_EQ(s.device.rfind("CPU, ", 0), 0u);
}

TEST(CpuRenderer, LeavesASoundFilmWhenStopped) {
  const scene::Scene scene = SpheresOnPlane();
  const Film full = Rendered(scene, 40);
  for (const std::uint64_t stopAt : {1u, 4000u, 30000u, 100000u}) {
    Film film(Whole);
    Watcher watcher(stopAt);
    const Statistics s =
        CpuRenderer().Render(scene, RequestOf(scene, 40), film, &watcher, &watcher.flag);
    EXPECT_EQ(watcher.log, "building end rendering end ");
    EXPECT_LT(s.samples, 70u * 50 * 40);
    std::uint64_t samples = 0;
    std::uint32_t least = 1000, most = 0;
    for (int y = 0; y < 50; ++y) {
      for (int x = 0; x < 70; ++x) {
        const std::uint32_t count = film.SampleCount(x, y);
        samples += count;
        least = std::min(least, count);
        most = std::max(most, count);
      }
    }
    EXPECT_EQ(samples, s.samples);
    // At most one pass apart: a pass at most doubles what there is, plus one
    EXPECT_LE(most, 2 * std::max(least, 1u)) << stopAt;
    for (const Spectrum& pixel : film.ToImage().pixels)
      EXPECT_TRUE(std::isfinite(pixel.x + pixel.y + pixel.z));
    // Go on where it was left, pixel by pixel: the picture of an undisturbed render
    if (stopAt != 4000) continue;
    for (int y = 0; y < 50; y += 7) {
      for (int x = 0; x < 70; x += 7) {
        const PixelRect pixel{x, y, x + 1, y + 1};
        Film rest(pixel);
        CpuRenderer().Render(scene, RequestOf(scene, film.SampleCount(x, y), pixel), rest, nullptr,
                             nullptr);
        EXPECT_EQ(Difference(rest, film), 0);
      }
    }
  }
  EXPECT_EQ(full.SampleCount(0, 0), 40u);
}

TEST(CpuRenderer, DoesNothingWhenStoppedBefore) {
  const scene::Scene scene = SpheresOnPlane();
  Film film(Whole);
  StopFlag stop;
  stop.Raise();
  const Statistics s = CpuRenderer().Render(scene, RequestOf(scene, 8), film, nullptr, &stop);
  EXPECT_EQ(s.samples, 0u);
  for (const Spectrum& pixel : film.ToImage().pixels) EXPECT_EQ(pixel, Spectrum(0.0f));
}

TEST(CpuRenderer, CountsAndLocatesRadianceThatIsNotFinite) {
  scene::Scene scene = SpheresOnPlane();
  scene::Light ambient;
  ambient.kind = scene::LightKind::Ambient;
  ambient.strength = 3e38f;
  scene.lights.push_back(ambient);
  scene.materials[0].emission.value = Spectrum(3e38f);
  scene.materials[0].terms[0].kind = scene::TermKind::Ambient;
  scene.materials[0].terms[0].color = {Spectrum(1.0f), -1};
  scene::Validate(scene, nullptr);
  Film film(Whole);
  const Statistics s = CpuRenderer().Render(scene, RequestOf(scene, 2), film, nullptr, nullptr);
  EXPECT_GT(s.nonFiniteSamples, 100u);
  EXPECT_EQ(s.samples, 70u * 50 * 2);
  ASSERT_FALSE(s.nonFinite.empty());
  EXPECT_LE(s.nonFinite.size(), 8u);
  for (const Spectrum& pixel : film.ToImage().pixels)
    EXPECT_TRUE(std::isfinite(pixel.x) && std::isfinite(pixel.y) && std::isfinite(pixel.z));
  // The place is one where the sample is not finite when it is rendered alone
  const render::NonFiniteSample at = s.nonFinite.front();
  const PixelRect pixel{at.x, at.y, at.x + 1, at.y + 1};
  Film alone(pixel, at.sample);
  const Statistics again =
      CpuRenderer().Render(scene, RequestOf(scene, at.sample + 1, pixel), alone, nullptr, nullptr);
  EXPECT_EQ(again.nonFiniteSamples, 1u);
}

TEST(CpuRenderer, LeavesOutTrianglesThatAreNowhere) {
  scene::Scene scene = SpheresOnPlane();
  scene::Mesh mesh;
  mesh.positions = {vec3(0, 0, 2), vec3(1, 0, 2), vec3(0, 1, 2),
                    vec3(std::numeric_limits<float>::quiet_NaN())};
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}};
  scene.meshes = {mesh};
  scene::Object object;
  object.geometry = scene::MeshGeometry{0};
  object.material = 0;
  scene.objects.push_back(object);
  Film film(Whole);
  const Statistics s = CpuRenderer().Render(scene, RequestOf(scene, 1), film, nullptr, nullptr);
  EXPECT_EQ(s.droppedPrimitives, 1u);
  EXPECT_EQ(s.nonFiniteSamples, 0u);
}

TEST(CpuRenderer, RendersEmptyScenes) {
  scene::Scene scene;
  scene.cameras.resize(1);
  scene.environment.bottom = scene.environment.top = Spectrum(0.25f);
  scene.settings.width = Whole.x1;
  scene.settings.height = Whole.y1;
  for (const Spectrum& pixel : Rendered(scene, 3).ToImage().pixels)
    EXPECT_EQ(pixel, Spectrum(0.25f));
}

}  // namespace
}  // namespace snell::cpu
