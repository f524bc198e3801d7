// SPDX-License-Identifier: Apache-2.0
//
// CHECK and DCHECK: our own mistakes. A failed check prints the condition and its place and aborts;
// DCHECK is compiled in only where SNELL_DEBUG_CHECKS is set (presets dev and asan).
#pragma once

namespace snell {

// Print "file:line: check failed: condition" to the standard error output, after what the innermost
// `CheckContext` of this thread says, and abort.
[[noreturn]] void CheckFailed(const char* file, int line, const char* condition);

// Adds a sentence to a failed check on this thread while it lives, for example which pixel and sample
// was being computed and the command that replays it. `describe` writes at most `size` characters.
class CheckContext {
 public:
  using Describe = void (*)(const void* data, char* text, int size);
  CheckContext(Describe describe, const void* data);
  ~CheckContext();
  CheckContext(const CheckContext&) = delete;
  CheckContext& operator=(const CheckContext&) = delete;

 private:
  friend void CheckFailed(const char*, int, const char*);
  Describe describe_;
  const void* data_;
  CheckContext* outer_;
};

}  // namespace snell

#define CHECK(condition) \
  ((condition) ? (void)0 : ::snell::CheckFailed(__FILE__, __LINE__, #condition))

#ifdef SNELL_DEBUG_CHECKS
#define DCHECK(condition) CHECK(condition)
#else
#define DCHECK(condition) ((void)0)
#endif
