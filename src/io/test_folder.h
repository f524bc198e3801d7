// SPDX-License-Identifier: Apache-2.0
//
// For the tests of scene readers: a folder of files that goes with the test.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>

namespace snell::io {

class TestFolder {
 public:
  TestFolder() {
    static int count = 0;
    folder_ = std::filesystem::temp_directory_path() /
              ("snell-scene-" + std::to_string(::getpid()) + "-" + std::to_string(++count));
    std::filesystem::create_directory(folder_);
  }
  ~TestFolder() { std::filesystem::remove_all(folder_); }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  const std::filesystem::path& folder() const { return folder_; }

 protected:
  // A message with places relative to the folder.
  std::string Local(std::string text) const {
    const std::string prefix = folder_.string() + "/";
    for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix))
      text.erase(at, prefix.size());
    return text;
  }

  std::filesystem::path folder_;
};

}  // namespace snell::io
