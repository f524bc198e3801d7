// SPDX-License-Identifier: Apache-2.0
#include "gpu/sample_tracer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "gpu/work.h"
#include "util/check.h"
#include "util/text.h"

namespace snell::gpu {

namespace {

constexpr std::uint32_t GroupSize = 64;  // local_size_x
constexpr std::uint64_t MostSamples = std::uint64_t(1) << 19;
constexpr std::uint64_t SlotBytes = std::uint64_t(64) << 20;
constexpr const char* MemoryHint =
    "smaller textures or coarser meshes need less, and --device cpu has the processor's memory";

template <class T>
std::span<const std::byte> Bytes(const std::vector<T>& array) {
  return std::as_bytes(std::span(array));
}

template <class T>
std::span<const std::byte> BytesOf(const T& value) {
  return std::as_bytes(std::span(&value, 1));
}

// In the order of shaders/buffers.glsl.
std::vector<std::span<const std::byte>> ContentsOf(const cpu::FlatScene& scene,
                                                   const TraceArrays& tree) {
  return {BytesOf(scene.params),   BytesOf(tree.world),    Bytes(scene.objects),
          Bytes(scene.shapes),     Bytes(scene.instances), Bytes(scene.meshes),
          Bytes(scene.triangles),  Bytes(scene.positions), Bytes(scene.normals),
          Bytes(scene.uvs),        Bytes(scene.tangents),  Bytes(scene.colors),
          Bytes(scene.materials),  Bytes(scene.terms),     Bytes(scene.physicals),
          Bytes(scene.textures),   Bytes(scene.images),    Bytes(scene.texels),
          Bytes(scene.lights),     Bytes(scene.emitters),  Bytes(scene.albedos),
          Bytes(scene.lightNodes), Bytes(scene.motions),   Bytes(scene.grids),
          Bytes(tree.nodes),       Bytes(tree.triangles),  Bytes(tree.trees),
          Bytes(tree.shapes)};
}

}  // namespace

SampleTracer::SampleTracer(const VulkanDevice& device, const VulkanProgram& program,
                           const cpu::FlatScene& scene, const TraceArrays& tree,
                           std::uint64_t mostSamples)
    : device_(device), program_(program), tellsMore_(scene.params.aovs != 0) {
  const std::uint64_t bytesPerSample = sizeof(kernel::SampleRequest) +
                                       sizeof(kernel::SampleResult) +
                                       (tellsMore_ ? sizeof(kernel::AovSample) : 0);
  capacity_ = std::uint32_t(std::max<std::uint64_t>(
      std::min({mostSamples, MostSamples, SlotBytes / bytesPerSample}), Work::LeastLimit));

  const std::vector<std::span<const std::byte>> contents = ContentsOf(scene, tree);
  RequireRoom(contents);
  Uploader uploader(device);
  std::vector<VkBuffer> handles;
  for (const std::span<const std::byte> content : contents) {
    scene_.emplace_back(device, content.size(), Memory::Device);
    uploader.Copy(content, scene_.back());
    handles.push_back(scene_.back().handle());
    sceneBytes_ += content.size();
  }
  for (std::size_t i = 0; i < Slots; ++i) AddSlot(program, handles);
}

// A batch may still be under way if the other one has failed.
SampleTracer::~SampleTracer() { device_.vk().DeviceWaitIdle(device_.handle()); }

void SampleTracer::RequireRoom(std::span<const std::span<const std::byte>> contents) const {
  std::uint64_t needed = Slots * SlotBytes, largest = 0;
  for (const std::span<const std::byte> content : contents) {
    needed += content.size();
    largest = std::max<std::uint64_t>(largest, content.size());
  }
  const std::string& name = device_.physical().name;
  const std::uint64_t available = device_.AvailableBytes();
  if (needed > available)
    throw Error(fmt::format("the scene needs {} of memory on the GPU '{}'; {} are available",
                            ByteSize(needed), name, ByteSize(available)),
                {}, MemoryHint);
  const std::uint64_t most = device_.properties().limits.maxStorageBufferRange;
  if (largest > most)
    throw Error(fmt::format("the scene needs a buffer of {} on the GPU '{}', whose buffers hold {}",
                            ByteSize(largest), name, ByteSize(most)),
                {}, MemoryHint);
}

void SampleTracer::AddSlot(const VulkanProgram& program, std::vector<VkBuffer> handles) {
  const std::uint64_t aovs = tellsMore_ ? capacity_ * sizeof(kernel::AovSample) : 0;
  const std::uint64_t results = capacity_ * sizeof(kernel::SampleResult);
  VulkanBuffer requests(device_, capacity_ * sizeof(kernel::SampleRequest), Memory::Upload);
  VulkanBuffer resultBuffer(device_, results, Memory::Device);
  VulkanBuffer aovBuffer(device_, aovs, Memory::Device);
  VulkanBuffer resultsRead(device_, results, Memory::Readback);
  VulkanBuffer aovsRead(device_, aovs, Memory::Readback);
  handles.insert(handles.end(), {requests.handle(), resultBuffer.handle(), aovBuffer.handle()});
  BufferSet buffers(device_, program, handles);
  slots_.push_back({std::move(requests), std::move(resultBuffer), std::move(aovBuffer),
                    std::move(resultsRead), std::move(aovsRead), std::move(buffers),
                    device_.NewCommands(), device_.NewFence()});
}

void SampleTracer::Start(std::size_t index, std::span<const kernel::SampleRequest> requests) {
  Slot& slot = slots_[index];
  CHECK(!requests.empty() && requests.size() <= capacity_);
  const std::optional<std::uint64_t> lost = SimulatedFault("lost");
  if (lost && ++batches_ >= *lost) RequireSuccess(VK_ERROR_DEVICE_LOST, "vkQueueSubmit");
  slot.count = std::uint32_t(requests.size());
  std::memcpy(slot.requests.data(), requests.data(), requests.size_bytes());

  // Trace, then copy what came out to where the host reads it
  const VulkanFunctions& vk = device_.vk();
  auto begin = VulkanRecord<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  RequireSuccess(vk.BeginCommandBuffer(slot.commands, &begin), "vkBeginCommandBuffer");
  program_.Record(slot.commands, slot.buffers.handle(), (slot.count + GroupSize - 1) / GroupSize,
                  slot.count);
  auto traced = VulkanRecord<VkMemoryBarrier>(VK_STRUCTURE_TYPE_MEMORY_BARRIER);
  traced.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
  traced.dstAccessMask = VK_ACCESS_TRANSFER_READ_BIT;
  vk.CmdPipelineBarrier(slot.commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                        VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 1, &traced, 0, nullptr, 0, nullptr);
  const VkBufferCopy results = {0, 0, slot.count * sizeof(kernel::SampleResult)};
  vk.CmdCopyBuffer(slot.commands, slot.results.handle(), slot.resultsRead.handle(), 1, &results);
  if (tellsMore_) {
    const VkBufferCopy aovs = {0, 0, slot.count * sizeof(kernel::AovSample)};
    vk.CmdCopyBuffer(slot.commands, slot.aovs.handle(), slot.aovsRead.handle(), 1, &aovs);
  }
  auto copied = VulkanRecord<VkMemoryBarrier>(VK_STRUCTURE_TYPE_MEMORY_BARRIER);
  copied.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
  copied.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
  vk.CmdPipelineBarrier(slot.commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT,
                        0, 1, &copied, 0, nullptr, 0, nullptr);
  RequireSuccess(vk.EndCommandBuffer(slot.commands), "vkEndCommandBuffer");
  device_.Submit(slot.commands, slot.fence);
}

SampleTracer::Results SampleTracer::Finish(std::size_t index) {
  const Slot& slot = slots_[index];
  device_.Wait(slot.fence);
  return {{reinterpret_cast<const kernel::SampleResult*>(slot.resultsRead.data()), slot.count},
          {reinterpret_cast<const kernel::AovSample*>(slot.aovsRead.data()),
           tellsMore_ ? slot.count : 0}};
}

}  // namespace snell::gpu
