// SPDX-License-Identifier: Apache-2.0
#include "io/assimp/files.h"

#include <algorithm>
#include <assimp/IOStream.hpp>
#include <cstring>
#include <optional>
#include <system_error>
#include <utility>

#include "util/error.h"

namespace snell::io {
namespace {

// A file in memory. Reads and moves as fread and fseek do.
class MemoryStream : public Assimp::IOStream {
 public:
  explicit MemoryStream(std::string bytes) : bytes_(std::move(bytes)) {}

  size_t Read(void* to, size_t size, size_t count) override {
    if (size == 0) return 0;
    const size_t read = std::min(count, (bytes_.size() - at_) / size);
    if (read > 0) std::memcpy(to, bytes_.data() + at_, read * size);
    at_ += read * size;
    return read;
  }
  size_t Write(const void*, size_t, size_t) override { return 0; }
  aiReturn Seek(size_t offset, aiOrigin origin) override {
    const size_t from = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? at_ : bytes_.size();
    const size_t to = origin == aiOrigin_END ? from - std::min(offset, from) : from + offset;
    if (to > bytes_.size() || to < from - (origin == aiOrigin_END ? offset : 0))
      return aiReturn_FAILURE;
    at_ = to;
    return aiReturn_SUCCESS;
  }
  size_t Tell() const override { return at_; }
  size_t FileSize() const override { return bytes_.size(); }
  void Flush() override {}

 private:
  std::string bytes_;
  size_t at_ = 0;
};

}  // namespace

AssimpFiles::AssimpFiles(std::filesystem::path file, const std::string& bytes,
                         std::vector<std::filesystem::path> folders, const ReadLimits& limits)
    : file_(std::move(file)), bytes_(bytes), folders_(std::move(folders)), limits_(limits) {}

bool AssimpFiles::Exists(const char* name) const {
  std::error_code ignored;
  if (file_ == name) return true;
  try {
    const auto path = ConfinedPath(folders_, {}, name);
    return std::filesystem::is_regular_file(path, ignored);
  } catch (const Error&) {
    return false;
  }
}

Assimp::IOStream* AssimpFiles::Open(const char* name, const char* mode) {
  if (std::strpbrk(mode, "wa+")) return nullptr;
  if (file_ == name) return new MemoryStream(bytes_);
  try {
    std::string bytes =
        ReadWithin(ConfinedPath(folders_, {}, name), limits_, &ReadLimits::fileBytes, used_);
    used_ += bytes.size();
    return new MemoryStream(std::move(bytes));
  } catch (const Error&) {
    return nullptr;
  }
}

void AssimpFiles::Close(Assimp::IOStream* stream) { delete stream; }

}  // namespace snell::io
