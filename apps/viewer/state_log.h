// SPDX-License-Identifier: Apache-2.0
//
// Tells what the viewer has come to, a line each: "ready", "samples 16", "render done". For tests, which wait for these
// lines; $SNELL_VIEWER_LOG names the file.
#pragma once

#include <cstdio>
#include <string>

namespace snell::viewer {

class StateLog {
 public:
  StateLog() = default;
  // Throws Error if the file cannot be written.
  explicit StateLog(const std::string& path);
  ~StateLog();
  StateLog(const StateLog&) = delete;
  StateLog& operator=(const StateLog&) = delete;

  void Say(const std::string& line);

 private:
  std::FILE* file_ = nullptr;
};

}  // namespace snell::viewer
