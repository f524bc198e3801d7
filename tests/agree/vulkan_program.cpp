// SPDX-License-Identifier: Apache-2.0
//
// Buffers and programs (vulkan.h).
#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "agree/vulkan.h"
#include "util/check.h"
#include "util/error.h"

namespace snell::agree {

namespace {

// Longer than any dispatch of a test takes, on a busy machine too.
constexpr std::uint64_t TimeoutNanoseconds = 1200'000'000'000;

}  // namespace

VulkanBuffer::VulkanBuffer(const VulkanDevice& device, std::size_t bytes) {
  const VulkanFunctions& vk = device.vk();
  const VkDevice handle = device.handle();
  auto info = VulkanRecord<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
  info.size = std::max<std::size_t>(bytes, 1);
  info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  RequireSuccess(vk.CreateBuffer(handle, &info, nullptr, &buffer_), "vkCreateBuffer");
  cleanup_.Add([&vk, handle, buffer = buffer_] { vk.DestroyBuffer(handle, buffer, nullptr); });

  // Give it memory of its own
  VkMemoryRequirements requirements;
  vk.GetBufferMemoryRequirements(handle, buffer_, &requirements);
  auto allocation = VulkanRecord<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
  allocation.allocationSize = requirements.size;
  allocation.memoryTypeIndex = device.HostMemoryType(requirements.memoryTypeBits);
  VkDeviceMemory memory = VK_NULL_HANDLE;
  RequireSuccess(vk.AllocateMemory(handle, &allocation, nullptr, &memory), "vkAllocateMemory");
  cleanup_.Add([&vk, handle, memory] { vk.FreeMemory(handle, memory, nullptr); });
  RequireSuccess(vk.BindBufferMemory(handle, buffer_, memory, 0), "vkBindBufferMemory");
  void* data = nullptr;
  RequireSuccess(vk.MapMemory(handle, memory, 0, VK_WHOLE_SIZE, 0, &data), "vkMapMemory");
  data_ = static_cast<std::byte*>(data);
}

VulkanBuffer::VulkanBuffer(const VulkanDevice& device, std::span<const std::byte> content)
    : VulkanBuffer(device, content.size()) {
  if (!content.empty()) std::memcpy(data_, content.data(), content.size());
}

VulkanProgram::VulkanProgram(const VulkanDevice& device, std::span<const std::uint32_t> spirv,
                             std::uint32_t bufferCount)
    : device_(device), bufferCount_(bufferCount) {
  CreatePipeline(spirv);
  CreateDescriptorSet();
  CreateCommands();
}

void VulkanProgram::CreatePipeline(std::span<const std::uint32_t> spirv) {
  const VulkanFunctions& vk = device_.vk();
  const VkDevice handle = device_.handle();

  // Describe what the shader reads
  std::vector<VkDescriptorSetLayoutBinding> bindings(bufferCount_);
  for (std::uint32_t i = 0; i < bufferCount_; ++i) {
    bindings[i] = {i, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr};
  }
  auto setInfo = VulkanRecord<VkDescriptorSetLayoutCreateInfo>(
      VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO);
  setInfo.bindingCount = bufferCount_;
  setInfo.pBindings = bindings.data();
  RequireSuccess(vk.CreateDescriptorSetLayout(handle, &setInfo, nullptr, &setLayout_),
                 "vkCreateDescriptorSetLayout");
  cleanup_.Add([=, this, &vk] { vk.DestroyDescriptorSetLayout(handle, setLayout_, nullptr); });
  const VkPushConstantRange push = {VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(std::uint32_t)};
  auto layoutInfo =
      VulkanRecord<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
  layoutInfo.setLayoutCount = 1;
  layoutInfo.pSetLayouts = &setLayout_;
  layoutInfo.pushConstantRangeCount = 1;
  layoutInfo.pPushConstantRanges = &push;
  RequireSuccess(vk.CreatePipelineLayout(handle, &layoutInfo, nullptr, &layout_),
                 "vkCreatePipelineLayout");
  cleanup_.Add([=, this, &vk] { vk.DestroyPipelineLayout(handle, layout_, nullptr); });

  // Compile it
  auto moduleInfo =
      VulkanRecord<VkShaderModuleCreateInfo>(VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO);
  moduleInfo.codeSize = spirv.size_bytes();
  moduleInfo.pCode = spirv.data();
  VkShaderModule module = VK_NULL_HANDLE;
  RequireSuccess(vk.CreateShaderModule(handle, &moduleInfo, nullptr, &module),
                 "vkCreateShaderModule");
  cleanup_.Add([=, &vk] { vk.DestroyShaderModule(handle, module, nullptr); });
  auto info =
      VulkanRecord<VkComputePipelineCreateInfo>(VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO);
  info.layout = layout_;
  info.stage = VulkanRecord<VkPipelineShaderStageCreateInfo>(
      VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO);
  info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  info.stage.module = module;
  info.stage.pName = "main";
  RequireSuccess(vk.CreateComputePipelines(handle, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline_),
                 "vkCreateComputePipelines");
  cleanup_.Add([=, this, &vk] { vk.DestroyPipeline(handle, pipeline_, nullptr); });
}

void VulkanProgram::CreateDescriptorSet() {
  const VulkanFunctions& vk = device_.vk();
  const VkDevice handle = device_.handle();
  const VkDescriptorPoolSize size = {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, bufferCount_};
  auto poolInfo =
      VulkanRecord<VkDescriptorPoolCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO);
  poolInfo.maxSets = 1;
  poolInfo.poolSizeCount = 1;
  poolInfo.pPoolSizes = &size;
  VkDescriptorPool pool = VK_NULL_HANDLE;
  RequireSuccess(vk.CreateDescriptorPool(handle, &poolInfo, nullptr, &pool),
                 "vkCreateDescriptorPool");
  cleanup_.Add([=, &vk] { vk.DestroyDescriptorPool(handle, pool, nullptr); });
  auto info =
      VulkanRecord<VkDescriptorSetAllocateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO);
  info.descriptorPool = pool;
  info.descriptorSetCount = 1;
  info.pSetLayouts = &setLayout_;
  RequireSuccess(vk.AllocateDescriptorSets(handle, &info, &set_), "vkAllocateDescriptorSets");
}

void VulkanProgram::CreateCommands() {
  const VulkanFunctions& vk = device_.vk();
  const VkDevice handle = device_.handle();
  auto poolInfo = VulkanRecord<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
  poolInfo.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
  poolInfo.queueFamilyIndex = device_.queueFamily();
  VkCommandPool pool = VK_NULL_HANDLE;
  RequireSuccess(vk.CreateCommandPool(handle, &poolInfo, nullptr, &pool), "vkCreateCommandPool");
  cleanup_.Add([=, &vk] { vk.DestroyCommandPool(handle, pool, nullptr); });
  auto info =
      VulkanRecord<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
  info.commandPool = pool;
  info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  info.commandBufferCount = 1;
  RequireSuccess(vk.AllocateCommandBuffers(handle, &info, &commands_), "vkAllocateCommandBuffers");
  auto fenceInfo = VulkanRecord<VkFenceCreateInfo>(VK_STRUCTURE_TYPE_FENCE_CREATE_INFO);
  RequireSuccess(vk.CreateFence(handle, &fenceInfo, nullptr, &fence_), "vkCreateFence");
  cleanup_.Add([=, this, &vk] { vk.DestroyFence(handle, fence_, nullptr); });
}

void VulkanProgram::Bind(std::span<const VulkanBuffer> buffers) {
  CHECK(buffers.size() == bufferCount_);
  std::vector<VkDescriptorBufferInfo> infos(buffers.size());
  std::vector<VkWriteDescriptorSet> writes(buffers.size());
  for (std::uint32_t i = 0; i < bufferCount_; ++i) {
    infos[i] = {buffers[i].handle(), 0, VK_WHOLE_SIZE};
    writes[i] = VulkanRecord<VkWriteDescriptorSet>(VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET);
    writes[i].dstSet = set_;
    writes[i].dstBinding = i;
    writes[i].descriptorCount = 1;
    writes[i].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    writes[i].pBufferInfo = &infos[i];
  }
  device_.vk().UpdateDescriptorSets(device_.handle(), bufferCount_, writes.data(), 0, nullptr);
}

void VulkanProgram::Run(std::uint32_t groupsX, std::uint32_t groupsY, std::uint32_t pushConstant) {
  const VulkanFunctions& vk = device_.vk();
  const VkDevice handle = device_.handle();

  // Record the dispatch, and that the host reads afterwards
  auto begin = VulkanRecord<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  RequireSuccess(vk.BeginCommandBuffer(commands_, &begin), "vkBeginCommandBuffer");
  vk.CmdBindPipeline(commands_, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_);
  vk.CmdBindDescriptorSets(commands_, VK_PIPELINE_BIND_POINT_COMPUTE, layout_, 0, 1, &set_, 0,
                           nullptr);
  vk.CmdPushConstants(commands_, layout_, VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof pushConstant,
                      &pushConstant);
  vk.CmdDispatch(commands_, groupsX, groupsY, 1);
  auto barrier = VulkanRecord<VkMemoryBarrier>(VK_STRUCTURE_TYPE_MEMORY_BARRIER);
  barrier.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
  vk.CmdPipelineBarrier(commands_, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT,
                        0, 1, &barrier, 0, nullptr, 0, nullptr);
  RequireSuccess(vk.EndCommandBuffer(commands_), "vkEndCommandBuffer");

  // Submit it and wait
  auto submit = VulkanRecord<VkSubmitInfo>(VK_STRUCTURE_TYPE_SUBMIT_INFO);
  submit.commandBufferCount = 1;
  submit.pCommandBuffers = &commands_;
  RequireSuccess(vk.QueueSubmit(device_.queue(), 1, &submit, fence_), "vkQueueSubmit");
  RequireSuccess(vk.WaitForFences(handle, 1, &fence_, VK_TRUE, TimeoutNanoseconds),
                 "vkWaitForFences");
  RequireSuccess(vk.ResetFences(handle, 1, &fence_), "vkResetFences");
}

}  // namespace snell::agree
