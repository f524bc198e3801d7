// SPDX-License-Identifier: Apache-2.0
#include "render/oidn.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include "util/error.h"

namespace snell::render {

namespace {

// The part of its C interface that is used, as its documentation has it; the same in versions 1 and 2 but for the name of
// one function.
constexpr int DeviceDefault = 0;
constexpr int FormatFloat3 = 3;

struct Library {
  void* handle = nullptr;
  void* (*newDevice)(int type) = nullptr;
  void (*commitDevice)(void* device) = nullptr;
  void (*releaseDevice)(void* device) = nullptr;
  int (*deviceError)(void* device, const char** message) = nullptr;
  void* (*newFilter)(void* device, const char* type) = nullptr;
  void (*setImage)(void* filter, const char* name, void* values, int format, std::size_t width,
                   std::size_t height, std::size_t offset, std::size_t pixelStride,
                   std::size_t rowStride) = nullptr;
  void (*setFlag)(void* filter, const char* name, bool value) = nullptr;
  void (*commitFilter)(void* filter) = nullptr;
  void (*executeFilter)(void* filter) = nullptr;
  void (*releaseFilter)(void* filter) = nullptr;

  template <class Function>
  void Find(Function& function, const char* name) {
    function = reinterpret_cast<Function>(::dlsym(handle, name));
  }

  // Empty if there is none that is complete.
  static Library Open() {
    Library library;
    for (const char* name : {"libOpenImageDenoise.so.2", "libOpenImageDenoise.so.1",
                             "libOpenImageDenoise.so.0", "libOpenImageDenoise.so"}) {
      library.handle = ::dlopen(name, RTLD_NOW | RTLD_LOCAL);
      if (library.handle) break;
    }
    if (!library.handle) return library;
    library.Find(library.newDevice, "oidnNewDevice");
    library.Find(library.commitDevice, "oidnCommitDevice");
    library.Find(library.releaseDevice, "oidnReleaseDevice");
    library.Find(library.deviceError, "oidnGetDeviceError");
    library.Find(library.newFilter, "oidnNewFilter");
    library.Find(library.setImage, "oidnSetSharedFilterImage");
    library.Find(library.setFlag, "oidnSetFilterBool");
    if (!library.setFlag) library.Find(library.setFlag, "oidnSetFilter1b");
    library.Find(library.commitFilter, "oidnCommitFilter");
    library.Find(library.executeFilter, "oidnExecuteFilter");
    library.Find(library.releaseFilter, "oidnReleaseFilter");
    const bool isComplete = library.newDevice && library.commitDevice && library.releaseDevice &&
                            library.deviceError && library.newFilter && library.setImage &&
                            library.setFlag && library.commitFilter && library.executeFilter &&
                            library.releaseFilter;
    if (!isComplete) {
      ::dlclose(library.handle);
      library.handle = nullptr;
    }
    return library;
  }
};

// Opened once and never closed: its threads may outlive a picture.
const Library& TheLibrary() {
  static const Library library = Library::Open();
  return library;
}

std::vector<vec3> Together(const std::array<std::vector<vec3>, 2>& halves) {
  std::vector<vec3> mean(halves[0].size());
  for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = (halves[0][i] + halves[1][i]) * 0.5f;
  return mean;
}

}  // namespace

bool HasOidn() { return TheLibrary().handle != nullptr; }

image::Image DenoiseByOidn(const DenoiseInput& input) {
  const Library& oidn = TheLibrary();
  if (!oidn.handle)
    throw Error("Open Image Denoise is not installed", {},
                "install its library, or take the denoiser nfor");
  std::vector<vec3> color = Together(input.color), albedo = Together(input.albedo),
                    normal = Together(input.normal);
  image::Image result(input.width, input.height);

  void* const device = oidn.newDevice(DeviceDefault);
  if (!device) throw Error("Open Image Denoise finds no device");
  oidn.commitDevice(device);
  void* const filter = oidn.newFilter(device, "RT");
  if (filter) {
    const auto set = [&](const char* name, std::vector<vec3>& values) {
      oidn.setImage(filter, name, values.data(), FormatFloat3, std::size_t(input.width),
                    std::size_t(input.height), 0, 0, 0);
    };
    set("color", color);
    set("albedo", albedo);
    set("normal", normal);
    set("output", result.pixels);
    oidn.setFlag(filter, "hdr", true);
    oidn.commitFilter(filter);
    oidn.executeFilter(filter);
  }
  const char* message = nullptr;
  const bool failed = oidn.deviceError(device, &message) != 0 || !filter;
  const std::string reason = message ? message : "no filter";
  if (filter) oidn.releaseFilter(filter);
  oidn.releaseDevice(device);
  if (failed) throw Error("Open Image Denoise: " + reason);
  return result;
}

}  // namespace snell::render
