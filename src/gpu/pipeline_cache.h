// SPDX-License-Identifier: Apache-2.0
//
// What drivers have compiled, kept on disk between runs, so that the first pixel does not wait for the compiler: in
// $XDG_CACHE_HOME/snell, or ~/.cache/snell, a file for each device and driver. A file that is damaged is ignored.
#pragma once

#include <filesystem>
#include <string>

#include "gpu/device.h"

namespace snell::gpu {

class PipelineCache {
 public:
  explicit PipelineCache(const VulkanDevice& device);
  PipelineCache(const PipelineCache&) = delete;
  PipelineCache& operator=(const PipelineCache&) = delete;

  VkPipelineCache handle() const { return cache_; }
  // Write it if it has grown. A fault of the disk is no fault of the render.
  void Save();
  // Why the file was not used; "" if all is well.
  const std::string& warning() const { return warning_; }

 private:
  std::string ReadContent();

  const VulkanDevice& device_;
  std::filesystem::path path_;  // empty: there is no place for it
  std::string warning_;
  std::string content_;  // as it was read
  VkPipelineCache cache_ = VK_NULL_HANDLE;
  Cleanup cleanup_;
};

}  // namespace snell::gpu
