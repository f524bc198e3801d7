// SPDX-License-Identifier: Apache-2.0
//
// Stopping politely: Ctrl-C and its relatives raise a flag, so that a render can end with what it has.
#pragma once

#include "util/progress.h"

namespace snell::cli {

// While one lives, the first SIGINT, SIGTERM or SIGHUP raises the flag; the second one ends the program at
// once, as it does without this. Signals that whoever started the program chose to ignore stay ignored.
// One in the life of the program.
class StopOnSignal {
 public:
  StopOnSignal();
  ~StopOnSignal();
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;

  const StopFlag& flag() const;
  // The signal that came; 0 if none did.
  int signal() const;
};

// Let faults of writing come back as errors that can be told and mended, not as the end of the program:
// a reader that went away (SIGPIPE), a limit on the size of files (SIGXFSZ).
void IgnoreWriteSignals();

}  // namespace snell::cli
