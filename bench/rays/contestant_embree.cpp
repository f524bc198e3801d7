// SPDX-License-Identifier: Apache-2.0
//
// Embree 3 as a contestant: ray by ray, and by packets of sixteen.
#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <utility>

#include "rays/contestant.h"
#include "util/error.h"

namespace snell::bench {

namespace {

constexpr float Inf = std::numeric_limits<float>::infinity();
constexpr int PacketSize = 16;

class Embree : public Contestant {
 public:
  Embree(Quality quality, bool robust) : quality_(quality), robust_(robust) {
    device_ = rtcNewDevice("");
    rtcSetDeviceMemoryMonitorFunction(device_, CountMemory, &bytes_);
  }
  ~Embree() override {
    if (mesh_) rtcReleaseScene(mesh_);
    if (scene_) rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }

  std::string Name() const override {
    return std::string("Embree ") + (quality_ == Quality::High ? "high" : "medium") +
           (robust_ ? " robust" : "");
  }

  void Build(const Scene& scene) override {
    scene_ = NewScene();
    RTCScene holder = scene.placements.empty() ? scene_ : (mesh_ = NewScene());
    RTCGeometry mesh = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               scene.positions.data(), 0, sizeof(vec3), scene.positions.size());
    rtcSetSharedGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               scene.triangles.data(), 0, sizeof(kernel::Triangle),
                               scene.triangles.size());
    Attach(holder, mesh);
    if (mesh_) {
      rtcCommitScene(mesh_);
      for (const kernel::Transform& placement : scene.placements) {
        RTCGeometry instance = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE);
        rtcSetGeometryInstancedScene(instance, mesh_);
        rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, &placement);
        Attach(scene_, instance);
      }
    }
    rtcCommitScene(scene_);
    if (rtcGetDeviceError(device_) != RTC_ERROR_NONE)
      throw Error("Embree could not build the scene");
  }

  std::uint64_t MemoryBytes() const override { return std::uint64_t(bytes_.load()); }

  void Closest(std::span<const Query> queries, Answer* answers) const override {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      RTCRayHit r;
      Fill(r.ray, queries[i]);
      r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      r.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(scene_, &context, &r);
      const bool hit = r.hit.geomID != RTC_INVALID_GEOMETRY_ID;
      answers[i] = {hit ? r.ray.tfar : Inf, hit ? r.hit.primID : kernel::None, r.hit.instID[0]};
    }
  }

  void Any(std::span<const Query> queries, Answer* answers) const override {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      RTCRay ray;
      Fill(ray, queries[i]);
      rtcOccluded1(scene_, &context, &ray);
      answers[i].t = ray.tfar < 0 ? 0 : Inf;
    }
  }

 protected:
  RTCScene scene() const { return scene_; }
  bool HasInstances() const { return mesh_ != nullptr; }

 private:
  RTCScene NewScene() {
    RTCScene scene = rtcNewScene(device_);
    rtcSetSceneBuildQuality(
        scene, quality_ == Quality::High ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM);
    if (robust_) rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    return scene;
  }

  static void Attach(RTCScene scene, RTCGeometry geometry) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
  }

  static void Fill(RTCRay& r, const Query& query) {
    r.org_x = query.ray.o.x;
    r.org_y = query.ray.o.y;
    r.org_z = query.ray.o.z;
    r.tnear = 0;
    r.dir_x = query.ray.d.x;
    r.dir_y = query.ray.d.y;
    r.dir_z = query.ray.d.z;
    r.time = 0;
    r.tfar = query.tMax;
    r.mask = ~0u;
    r.id = 0;
    r.flags = 0;
  }

  static bool CountMemory(void* total, ssize_t bytes, bool) {
    *static_cast<std::atomic<std::int64_t>*>(total) += bytes;
    return true;
  }

  Quality quality_;
  bool robust_;
  RTCDevice device_;
  RTCScene scene_ = nullptr;
  RTCScene mesh_ = nullptr;
  std::atomic<std::int64_t> bytes_ = 0;
};

class EmbreePackets : public Embree {
 public:
  explicit EmbreePackets(Quality quality) : Embree(quality, false) {}

  std::string Name() const override { return Embree::Name() + " packets"; }

  void Closest(std::span<const Query> queries, Answer* answers) const override {
    RTCIntersectContext context = NewContext();
    ForPackets(queries, [&](std::size_t first, int count, const int* valid, const RTCRay16& rays) {
      RTCRayHit16 r;
      r.ray = rays;
      for (int i = 0; i < PacketSize; ++i)
        r.hit.geomID[i] = r.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect16(valid, scene(), &context, &r);
      for (int i = 0; i < count; ++i) {
        const bool hit = r.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
        answers[first + std::size_t(i)] = {
            hit ? r.ray.tfar[i] : Inf, hit ? r.hit.primID[i] : kernel::None, r.hit.instID[0][i]};
      }
    });
  }

  void Any(std::span<const Query> queries, Answer* answers) const override {
    RTCIntersectContext context = NewContext();
    ForPackets(queries, [&](std::size_t first, int count, const int* valid, RTCRay16& rays) {
      rtcOccluded16(valid, scene(), &context, &rays);
      for (int i = 0; i < count; ++i)
        answers[first + std::size_t(i)].t = rays.tfar[i] < 0 ? 0 : Inf;
    });
  }

 private:
  // Neighbours are coherent. Where there are instances they are not called so: Embree 3.13.5 then sometimes
  // never returns from rtcOccluded16, and is slower when it does.
  RTCIntersectContext NewContext() const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = HasInstances() ? RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT
                                   : RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    return context;
  }

  template <class Body>
  static void ForPackets(std::span<const Query> queries, const Body& body) {
    for (std::size_t first = 0; first < queries.size(); first += PacketSize) {
      const int count = int(std::min<std::size_t>(PacketSize, queries.size() - first));
      alignas(64) int valid[PacketSize];
      RTCRay16 rays;
      for (int i = 0; i < PacketSize; ++i) {
        valid[i] = i < count ? -1 : 0;
        const Query& query = queries[first + std::size_t(std::min(i, count - 1))];
        rays.org_x[i] = query.ray.o.x;
        rays.org_y[i] = query.ray.o.y;
        rays.org_z[i] = query.ray.o.z;
        rays.tnear[i] = 0;
        rays.dir_x[i] = query.ray.d.x;
        rays.dir_y[i] = query.ray.d.y;
        rays.dir_z[i] = query.ray.d.z;
        rays.time[i] = 0;
        rays.tfar[i] = query.tMax;
        rays.mask[i] = ~0u;
        rays.id[i] = 0;
        rays.flags[i] = 0;
      }
      body(first, count, valid, rays);
    }
  }
};

}  // namespace

std::unique_ptr<Contestant> MakeEmbree(Quality quality, bool robust) {
  return std::make_unique<Embree>(quality, robust);
}

std::unique_ptr<Contestant> MakeEmbreePackets(Quality quality) {
  return std::make_unique<EmbreePackets>(quality);
}

std::string EmbreeVersion() {
  const RTCDevice device = rtcNewDevice("");
  const auto property = [&](RTCDeviceProperty name) { return rtcGetDeviceProperty(device, name); };
  const int packets = property(RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED)  ? 16
                      : property(RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED) ? 8
                                                                            : 4;
  std::string text =
      fmt::format("{}.{}.{}, native packets of {}", property(RTC_DEVICE_PROPERTY_VERSION_MAJOR),
                  property(RTC_DEVICE_PROPERTY_VERSION_MINOR),
                  property(RTC_DEVICE_PROPERTY_VERSION_PATCH), packets);
  rtcReleaseDevice(device);
  return text;
}

}  // namespace snell::bench
