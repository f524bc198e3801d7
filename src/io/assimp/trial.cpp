// SPDX-License-Identifier: Apache-2.0
#include "io/assimp/trial.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <exception>
#include <fstream>

namespace snell::io {
namespace {

// Tools that watch memory reserve more of it than any limit allows.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool LimitsMemory = false;
#else
constexpr bool LimitsMemory = true;
#endif

std::uint64_t MemoryInUse() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * std::uint64_t(::sysconf(_SC_PAGESIZE));
}

void SetLimit(int resource, std::uint64_t value) {
  const rlimit limit{value, value};
  ::setrlimit(static_cast<__rlimit_resource_t>(resource), &limit);
}

[[noreturn]] void Work(const std::function<std::string()>& work, const TrialLimits& limits,
                       int report) {
  if (LimitsMemory) SetLimit(RLIMIT_AS, MemoryInUse() + limits.bytes);
  SetLimit(RLIMIT_CPU, std::uint64_t(limits.seconds));
  SetLimit(RLIMIT_CORE, 0);
  for (const int fault : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGXCPU, SIGINT, SIGTERM})
    ::signal(fault, SIG_DFL);
  const int nowhere = ::open("/dev/null", O_WRONLY);
  if (nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
  std::string fault;
  try {
    fault = work();
  } catch (const std::exception& error) {
    fault = error.what();
  }
  if (fault.size() > 1000) fault.resize(1000);
  const bool told = ::write(report, fault.data(), fault.size()) == ssize_t(fault.size());
  ::_exit(fault.empty() && told ? 0 : 1);
}

std::string ReadAll(int file) {
  std::string text;
  char part[1024];
  for (;;) {
    const ssize_t got = ::read(file, part, sizeof part);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return text;
    text.append(part, std::size_t(got));
  }
}

}  // namespace

std::string TryInProcess(const std::function<std::string()>& work, const TrialLimits& limits) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return "no pipe can be opened";
  const pid_t child = ::fork();
  if (child == 0) Work(work, limits, ends[1]);
  ::close(ends[1]);
  const std::string fault = child < 0 ? "no process can be started" : ReadAll(ends[0]);
  ::close(ends[0]);
  if (child < 0) return fault;

  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (WIFEXITED(status)) {
    const bool good = WEXITSTATUS(status) == 0 && fault.empty();
    return good ? "" : fault.empty() ? "reading it failed" : fault;
  }
  const int signal = WTERMSIG(status);
  if (signal == SIGXCPU || signal == SIGKILL) return "reading it takes too much time or memory";
  return "the library that reads this format crashed on it: the file is malformed";
}

}  // namespace snell::io
