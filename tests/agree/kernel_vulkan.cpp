// SPDX-License-Identifier: Apache-2.0
#include "agree/kernel_vulkan.h"

#include <cstring>

#include "agree/brute_force.h"
#include "agree/spirv.h"

namespace snell::agree {

namespace {

constexpr std::uint32_t BufferCount = 26;  // src/gpu/shaders/buffers.glsl, AOVs and radiance
constexpr std::uint32_t GroupSize = 8;     // local_size_x and local_size_y

template <class T>
std::span<const std::byte> Bytes(const std::vector<T>& array) {
  return std::as_bytes(std::span(array));
}

template <class T>
std::span<const std::byte> BytesOf(const T& value) {
  return std::as_bytes(std::span(&value, 1));
}

}  // namespace

KernelOnVulkan::KernelOnVulkan(const VulkanDevice& device, scene::Integrator integrator)
    : device_(device),
      program_(device,
               WithNoContraction(ReadSpirv(
                   integrator == scene::Integrator::Path ? SNELL_PATH_SPIRV : SNELL_WHITTED_SPIRV)),
               BufferCount) {}

void KernelOnVulkan::Upload(const cpu::FlatScene& scene) {
  resolution_ = scene.params.camera.resolution;
  const std::size_t pixels = std::size_t(resolution_.x) * resolution_.y;
  const PrimitiveCounts counts = CountsOf(scene);
  buffers_.clear();
  for (const std::span<const std::byte> content :
       {BytesOf(scene.params),   BytesOf(counts),        Bytes(scene.objects),
        Bytes(scene.shapes),     Bytes(scene.instances), Bytes(scene.meshes),
        Bytes(scene.triangles),  Bytes(scene.positions), Bytes(scene.normals),
        Bytes(scene.uvs),        Bytes(scene.tangents),  Bytes(scene.colors),
        Bytes(scene.materials),  Bytes(scene.terms),     Bytes(scene.physicals),
        Bytes(scene.textures),   Bytes(scene.images),    Bytes(scene.texels),
        Bytes(scene.lights),     Bytes(scene.emitters),  Bytes(scene.albedos),
        Bytes(scene.lightNodes), Bytes(scene.motions),   Bytes(scene.grids)})
    buffers_.emplace_back(device_, content);
  tellsMore_ = scene.params.aovs != 0;
  buffers_.emplace_back(device_, (tellsMore_ ? pixels : 1) * sizeof(kernel::AovSample));
  buffers_.emplace_back(device_, pixels * sizeof(kernel::Spectrum));
  program_.Bind(buffers_);
}

std::vector<kernel::Spectrum> KernelOnVulkan::Render(std::uint32_t sample) {
  // A pixel that the shader does not write must not pass for one of an earlier sample
  std::vector<kernel::Spectrum> radiance(std::size_t(resolution_.x) * resolution_.y);
  const std::size_t bytes = radiance.size() * sizeof(kernel::Spectrum);
  std::byte* const data = buffers_.back().data();
  std::memset(data, 0xff, bytes);
  program_.Run((resolution_.x + GroupSize - 1) / GroupSize,
               (resolution_.y + GroupSize - 1) / GroupSize, sample);
  std::memcpy(radiance.data(), data, bytes);
  return radiance;
}

std::vector<kernel::AovSample> KernelOnVulkan::Aovs() {
  std::vector<kernel::AovSample> aovs(tellsMore_ ? std::size_t(resolution_.x) * resolution_.y : 0);
  const std::byte* const data = buffers_[buffers_.size() - 2].data();
  std::memcpy(aovs.data(), data, aovs.size() * sizeof(kernel::AovSample));
  return aovs;
}

}  // namespace snell::agree
