// SPDX-License-Identifier: Apache-2.0
//
// Stands in for the library of Open Image Denoise in tests: the functions of its C interface that oidn.cpp calls. It adds
// up its images, which tells that each arrived, and fails where the order of calls is wrong.
#include <cstddef>
#include <cstring>
#include <map>
#include <string>

namespace {

struct Filter {
  std::map<std::string, float*> images;
  std::size_t count = 0;
  bool hdr = false;
  bool committed = false;
};

bool deviceReady = false;
const char* fault = nullptr;

}  // namespace

#define EXPORTED extern "C" __attribute__((visibility("default")))

EXPORTED void* oidnNewDevice(int) { return &deviceReady; }
EXPORTED void oidnCommitDevice(void*) { deviceReady = true; }
EXPORTED void oidnReleaseDevice(void*) { deviceReady = false; }
EXPORTED int oidnGetDeviceError(void*, const char** message) {
  *message = fault;
  return fault ? 1 : 0;
}
EXPORTED void* oidnNewFilter(void*, const char* type) {
  return deviceReady && std::strcmp(type, "RT") == 0 ? new Filter : nullptr;
}
EXPORTED void oidnSetSharedFilterImage(void* filter, const char* name, void* values, int format,
                                       std::size_t width, std::size_t height, std::size_t,
                                       std::size_t, std::size_t) {
  Filter& f = *static_cast<Filter*>(filter);
  if (format == 3) f.images[name] = static_cast<float*>(values);
  f.count = 3 * width * height;
}
EXPORTED void oidnSetFilterBool(void* filter, const char* name, bool value) {
  if (std::strcmp(name, "hdr") == 0) static_cast<Filter*>(filter)->hdr = value;
}
EXPORTED void oidnCommitFilter(void* filter) {
  Filter& f = *static_cast<Filter*>(filter);
  f.committed = f.hdr && f.images.size() == 4;
}
EXPORTED void oidnExecuteFilter(void* filter) {
  Filter& f = *static_cast<Filter*>(filter);
  fault = f.committed ? nullptr : "the filter is not committed";
  // A picture that is too small to be true asks for a fault
  if (f.count == 3) fault = "the picture is too small";
  if (fault) return;
  for (std::size_t i = 0; i < f.count; ++i)
    f.images["output"][i] = f.images["color"][i] + f.images["albedo"][i] + f.images["normal"][i];
}
EXPORTED void oidnReleaseFilter(void* filter) { delete static_cast<Filter*>(filter); }
