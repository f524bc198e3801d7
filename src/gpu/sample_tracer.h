// SPDX-License-Identifier: Apache-2.0
//
// A scene on a device, and samples of it traced in batches: while the device works on one batch, the host adds up
// another.
#pragma once

#include <span>
#include <vector>

#include "cpu/flatten.h"
#include "gpu/program.h"
#include "gpu/records.h"
#include "gpu/trace_tree.h"
#include "kernel/aov.h"

namespace snell::gpu {

class SampleTracer {
 public:
  // Batches that can be under way at a time.
  static constexpr std::size_t Slots = 2;

  struct Results {
    std::span<const kernel::SampleResult> samples;
    std::span<const kernel::AovSample> aovs;  // if the scene asks for them
  };

  // Copies the scene to the device. Throws Error with the figures if it does not fit. `mostSamples` limits a batch.
  SampleTracer(const VulkanDevice& device, const VulkanProgram& program,
               const cpu::FlatScene& scene, const TraceArrays& tree, std::uint64_t mostSamples);
  ~SampleTracer();
  SampleTracer(const SampleTracer&) = delete;
  SampleTracer& operator=(const SampleTracer&) = delete;

  // Samples that a batch may have, at least those of a tile.
  std::uint32_t capacity() const { return capacity_; }
  std::uint64_t sceneBytes() const { return sceneBytes_; }

  // Begin a batch in a slot that is not under way. Throws DeviceLost, as Finish does.
  void Start(std::size_t slot, std::span<const kernel::SampleRequest> requests);
  // Wait for it. What it gave stays where it is until the slot is used again.
  Results Finish(std::size_t slot);

 private:
  // One batch's way in and out.
  struct Slot {
    VulkanBuffer requests;
    VulkanBuffer results;
    VulkanBuffer aovs;
    VulkanBuffer resultsRead;
    VulkanBuffer aovsRead;
    BufferSet buffers;
    VkCommandBuffer commands;
    VkFence fence;
    std::uint32_t count = 0;
  };

  void RequireRoom(std::span<const std::span<const std::byte>> contents) const;
  void AddSlot(const VulkanProgram& program, std::vector<VkBuffer> handles);

  const VulkanDevice& device_;
  const VulkanProgram& program_;
  bool tellsMore_;
  std::uint32_t capacity_ = 0;
  std::uint64_t sceneBytes_ = 0;
  std::uint64_t batches_ = 0;  // that were begun
  std::vector<VulkanBuffer> scene_;
  std::vector<Slot> slots_;
};

}  // namespace snell::gpu
