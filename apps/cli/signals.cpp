// SPDX-License-Identifier: Apache-2.0
#include "cli/signals.h"

#include <signal.h>

#include <atomic>

#include "util/check.h"

namespace snell::cli {

namespace {

constexpr int StopSignals[] = {SIGINT, SIGTERM, SIGHUP};

// What the handler touches: lock-free atomics only.
StopFlag stopFlag;
std::atomic<int> signalThatCame{0};
static_assert(std::atomic<int>::is_always_lock_free, "signal handlers store it");
bool installed = false;

void SetDefault() {
  for (const int signal : StopSignals) {
    struct sigaction action = {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler != SIG_IGN) ::signal(signal, SIG_DFL);
  }
}

void HandleStop(int signal) {
  signalThatCame = signal;
  stopFlag.Raise();
  SetDefault();
}

}  // namespace

StopOnSignal::StopOnSignal() {
  CHECK(!installed);
  installed = true;
  for (const int signal : StopSignals) {
    struct sigaction old = {};
    sigaction(signal, nullptr, &old);
    if (old.sa_handler == SIG_IGN) continue;
    struct sigaction action = {};
    action.sa_handler = HandleStop;
    action.sa_flags = SA_RESTART;
    for (const int other : StopSignals) sigaddset(&action.sa_mask, other);
    sigaction(signal, &action, nullptr);
  }
}

StopOnSignal::~StopOnSignal() { SetDefault(); }

const StopFlag& StopOnSignal::flag() const { return stopFlag; }
int StopOnSignal::signal() const { return signalThatCame; }

void IgnoreWriteSignals() {
  ::signal(SIGPIPE, SIG_IGN);
  ::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace snell::cli
