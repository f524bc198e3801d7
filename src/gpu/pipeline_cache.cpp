// SPDX-License-Identifier: Apache-2.0
#include "gpu/pipeline_cache.h"

#include <fmt/format.h>

#include <cstdlib>

#include "util/file.h"
#include "util/hash.h"

namespace snell::gpu {

namespace fs = std::filesystem;

namespace {

// A file is this, a checksum of 16 digits, a line's end, and what the driver gave.
constexpr std::string_view Magic = "snell pipelines 1 ";
constexpr std::size_t HeaderSize = Magic.size() + 17;
constexpr std::uint64_t MaxBytes = std::uint64_t(256) << 20;

std::string HeaderOf(std::string_view content) {
  Hasher hasher;
  hasher.Add(content.data(), content.size());
  return fmt::format("{}{}\n", Magic, hasher.Text());
}

// The file for a device and its driver; empty if there is no folder for caches.
fs::path PathFor(const VkPhysicalDeviceProperties& properties) {
  const char* const cache = std::getenv("XDG_CACHE_HOME");
  const char* const home = std::getenv("HOME");
  fs::path folder;
  if (cache && *cache)
    folder = cache;
  else if (home && *home)
    folder = fs::path(home) / ".cache";
  if (!folder.is_absolute()) return {};
  Hasher hasher;
  hasher.Add(properties.pipelineCacheUUID, sizeof properties.pipelineCacheUUID);
  return folder / "snell" /
         fmt::format("vulkan-{:04x}-{:04x}-{:08x}-{}.pipelines", properties.vendorID,
                     properties.deviceID, properties.driverVersion, hasher.Text());
}

}  // namespace

PipelineCache::PipelineCache(const VulkanDevice& device)
    : device_(device), path_(PathFor(device.properties())), content_(ReadContent()) {
  const VulkanFunctions& vk = device.vk();
  auto info = VulkanRecord<VkPipelineCacheCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO);
  info.initialDataSize = content_.size();
  info.pInitialData = content_.data();
  RequireSuccess(vk.CreatePipelineCache(device.handle(), &info, nullptr, &cache_),
                 "vkCreatePipelineCache");
  cleanup_.Add([this, &vk] { vk.DestroyPipelineCache(device_.handle(), cache_, nullptr); });
}

std::string PipelineCache::ReadContent() {
  std::error_code ignored;
  if (path_.empty() || !fs::exists(path_, ignored)) return {};
  try {
    std::string content = ReadFile(path_, MaxBytes);
    const std::string header = content.substr(0, HeaderSize);
    content.erase(0, HeaderSize);
    if (header == HeaderOf(content)) return content;
    warning_ = fmt::format("{}: the cache of compiled shaders is damaged; it is made anew",
                           path_.string());
  } catch (const Error& error) {
    warning_ = error.what();
  }
  return {};
}

void PipelineCache::Save() {
  if (path_.empty()) return;
  const VulkanFunctions& vk = device_.vk();
  std::size_t size = 0;
  if (vk.GetPipelineCacheData(device_.handle(), cache_, &size, nullptr) != VK_SUCCESS) return;
  std::string content(size, '\0');
  if (vk.GetPipelineCacheData(device_.handle(), cache_, &size, content.data()) != VK_SUCCESS)
    return;
  content.resize(size);
  if (content == content_ && warning_.empty()) return;
  try {
    std::error_code ignored;
    fs::create_directories(path_.parent_path(), ignored);
    WriteFile(path_, HeaderOf(content) + content);
    content_ = content;
  } catch (const Error&) {
    // The next run compiles again
  }
}

}  // namespace snell::gpu
