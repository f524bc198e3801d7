// SPDX-License-Identifier: Apache-2.0
//
// What Assimp may open: the file itself and files in the folders that it may read from, as many bytes as the
// limits allow. It writes nothing.
#pragma once

#include <assimp/IOSystem.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "io/read_limits.h"

namespace snell::io {

class AssimpFiles : public Assimp::IOSystem {
 public:
  // `folders` are the file's own and others. `bytes` are the file's.
  AssimpFiles(std::filesystem::path file, const std::string& bytes,
              std::vector<std::filesystem::path> folders, const ReadLimits& limits);

  bool Exists(const char* name) const override;
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* name, const char* mode) override;
  void Close(Assimp::IOStream* stream) override;

 private:
  std::filesystem::path file_;
  const std::string& bytes_;
  std::vector<std::filesystem::path> folders_;
  ReadLimits limits_;
  std::uint64_t used_ = 0;
};

}  // namespace snell::io
