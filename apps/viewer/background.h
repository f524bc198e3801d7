// SPDX-License-Identifier: Apache-2.0
//
// One piece of work on a thread of its own, and its result or error when it is there.
#pragma once

#include <chrono>
#include <future>
#include <optional>

namespace snell::viewer {

template <class T>
class Background {
 public:
  // Only when nothing is under way.
  template <class Work>
  void Start(Work work) {
    result_ = std::async(std::launch::async, std::move(work));
  }
  bool Busy() const { return result_.valid(); }
  // The result, once. Throws what the work threw.
  std::optional<T> Take() {
    if (!Busy() || result_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
      return std::nullopt;
    return result_.get();
  }

 private:
  std::future<T> result_;
};

}  // namespace snell::viewer
