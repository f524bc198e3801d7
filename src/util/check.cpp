// SPDX-License-Identifier: Apache-2.0
#include "util/check.h"

#include <cstdio>
#include <cstdlib>

namespace snell {

static thread_local CheckContext* innermostContext = nullptr;

CheckContext::CheckContext(Describe describe, const void* data)
    : describe_(describe), data_(data), outer_(innermostContext) {
  innermostContext = this;
}

CheckContext::~CheckContext() { innermostContext = outer_; }

void CheckFailed(const char* file, int line, const char* condition) {
  std::fprintf(stderr, "%s:%d: check failed: %s\n", file, line, condition);
  if (innermostContext) {
    char text[512];
    innermostContext->describe_(innermostContext->data_, text, int(sizeof text));
    std::fprintf(stderr, "%s\n", text);
  }
  std::abort();
}

}  // namespace snell
