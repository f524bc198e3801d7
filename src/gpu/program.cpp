// SPDX-License-Identifier: Apache-2.0
#include "gpu/program.h"

#include "util/check.h"

namespace snell::gpu {

VulkanProgram::VulkanProgram(const VulkanDevice& device, std::span<const std::uint32_t> spirv,
                             PipelineCache* cache)
    : device_(device) {
  const VulkanFunctions& vk = device_.vk();
  const VkDevice handle = device_.handle();

  // Describe what the shader reads
  std::vector<VkDescriptorSetLayoutBinding> bindings(BufferCount);
  for (std::uint32_t i = 0; i < BufferCount; ++i)
    bindings[i] = {i, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr};
  auto setInfo = VulkanRecord<VkDescriptorSetLayoutCreateInfo>(
      VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO);
  setInfo.bindingCount = BufferCount;
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
  RequireSuccess(
      vk.CreateComputePipelines(handle, cache ? cache->handle() : VkPipelineCache(VK_NULL_HANDLE),
                                1, &info, nullptr, &pipeline_),
      "vkCreateComputePipelines");
  cleanup_.Add([=, this, &vk] { vk.DestroyPipeline(handle, pipeline_, nullptr); });
}

void VulkanProgram::Record(VkCommandBuffer commands, VkDescriptorSet buffers, std::uint32_t groups,
                           std::uint32_t pushConstant) const {
  const VulkanFunctions& vk = device_.vk();
  vk.CmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_);
  vk.CmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_, 0, 1, &buffers, 0,
                           nullptr);
  vk.CmdPushConstants(commands, layout_, VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof pushConstant,
                      &pushConstant);
  vk.CmdDispatch(commands, groups, 1, 1);
}

BufferSet::BufferSet(const VulkanDevice& device, const VulkanProgram& program,
                     std::span<const VkBuffer> buffers) {
  CHECK(buffers.size() == BufferCount);
  const VulkanFunctions& vk = device.vk();
  const VkDevice handle = device.handle();
  const VkDescriptorPoolSize size = {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, BufferCount};
  auto poolInfo =
      VulkanRecord<VkDescriptorPoolCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO);
  poolInfo.maxSets = 1;
  poolInfo.poolSizeCount = 1;
  poolInfo.pPoolSizes = &size;
  VkDescriptorPool pool = VK_NULL_HANDLE;
  RequireSuccess(vk.CreateDescriptorPool(handle, &poolInfo, nullptr, &pool),
                 "vkCreateDescriptorPool");
  cleanup_.Add([=, &vk] { vk.DestroyDescriptorPool(handle, pool, nullptr); });
  const VkDescriptorSetLayout layout = program.setLayout();
  auto info =
      VulkanRecord<VkDescriptorSetAllocateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO);
  info.descriptorPool = pool;
  info.descriptorSetCount = 1;
  info.pSetLayouts = &layout;
  RequireSuccess(vk.AllocateDescriptorSets(handle, &info, &set_), "vkAllocateDescriptorSets");

  std::vector<VkDescriptorBufferInfo> infos(BufferCount);
  std::vector<VkWriteDescriptorSet> writes(BufferCount);
  for (std::uint32_t i = 0; i < BufferCount; ++i) {
    infos[i] = {buffers[i], 0, VK_WHOLE_SIZE};
    writes[i] = VulkanRecord<VkWriteDescriptorSet>(VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET);
    writes[i].dstSet = set_;
    writes[i].dstBinding = i;
    writes[i].descriptorCount = 1;
    writes[i].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    writes[i].pBufferInfo = &infos[i];
  }
  vk.UpdateDescriptorSets(handle, BufferCount, writes.data(), 0, nullptr);
}

}  // namespace snell::gpu
