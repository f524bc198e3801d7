// SPDX-License-Identifier: Apache-2.0
#include "viewer/state_log.h"

#include <cerrno>
#include <system_error>

#include "util/error.h"

namespace snell::viewer {

StateLog::StateLog(const std::string& path) {
  if (path.empty()) return;
  file_ = std::fopen(path.c_str(), "w");
  if (!file_) throw Error("cannot be written: " + std::generic_category().message(errno), {path});
}

StateLog::~StateLog() {
  if (file_) std::fclose(file_);
}

void StateLog::Say(const std::string& line) {
  if (!file_) return;
  std::fputs((line + "\n").c_str(), file_);
  std::fflush(file_);
}

}  // namespace snell::viewer
