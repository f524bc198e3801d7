// SPDX-License-Identifier: Apache-2.0
#include "child.h"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace snell::test {

namespace {

constexpr int NotStarted = 125;

using Clock = std::chrono::steady_clock;

std::vector<char*> Pointers(const std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

// A pipe or terminal between parent and child; the ends do not leak into other programs.
struct Channel {
  int parent = -1;
  int child = -1;
};

Channel OpenPipe() {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) std::abort();
  return {ends[0], ends[1]};
}

Channel OpenTerminal() {
  Channel channel;
  winsize size = {};
  size.ws_row = 24;
  size.ws_col = 80;
  if (::openpty(&channel.parent, &channel.child, nullptr, nullptr, &size) != 0) std::abort();
  ::fcntl(channel.parent, F_SETFD, FD_CLOEXEC);
  ::fcntl(channel.child, F_SETFD, FD_CLOEXEC);
  return channel;
}

}  // namespace

Child::Child(const std::vector<std::string>& arguments, const Surroundings& surroundings)
    : terminal_(surroundings.terminal) {
  std::vector<std::string> words = {SNELL_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const std::vector<char*> argv = Pointers(words);
  const Channel err = terminal_ ? OpenTerminal() : OpenPipe();
  const Channel out = terminal_ ? Channel{} : OpenPipe();

  pid_ = ::fork();
  if (pid_ == 0) {
    // A new session, so that the terminal is its own and no signal of ours reaches it
    ::setsid();
    if (terminal_) ::ioctl(err.child, TIOCSCTTY, 0);
    const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    int target = terminal_ ? err.child : out.child;
    if (!surroundings.outputFile.empty())
      target = ::open(surroundings.outputFile.c_str(), O_WRONLY | O_CLOEXEC);
    ::dup2(terminal_ ? err.child : nothing, STDIN_FILENO);
    ::dup2(target, STDOUT_FILENO);
    ::dup2(err.child, STDERR_FILENO);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) ::signal(signal, SIG_DFL);
    ::setenv("TERM", surroundings.terminalKind.c_str(), 1);
    const bool moved = surroundings.folder.empty() || ::chdir(surroundings.folder.c_str()) == 0;
    if (!moved || (surroundings.prepare && !surroundings.prepare())) ::_exit(NotStarted);
    ::execv(argv[0], argv.data());
    ::_exit(NotStarted);
  }
  ::close(err.child);
  if (out.child >= 0) ::close(out.child);
  err_ = err.parent;
  out_ = out.parent;
}

Child::~Child() {
  if (pid_ > 0) {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  for (const int file : {out_, err_})
    if (file >= 0) ::close(file);
}

// Read what there is; false once both streams have ended.
bool Child::ReadSome(int milliseconds) {
  pollfd files[2] = {{out_, POLLIN, 0}, {err_, POLLIN, 0}};
  if (out_ < 0 && err_ < 0) return false;
  ::poll(files, 2, milliseconds);
  const auto read = [](const pollfd& ready, int& file, std::string& text) {
    if (file < 0 || ready.revents == 0) return;
    char bytes[4096];
    const ssize_t got = ::read(file, bytes, sizeof bytes);
    if (got > 0) {
      text.append(bytes, std::size_t(got));
    } else if (got == 0 || errno != EINTR) {  // a terminal ends with an error
      ::close(file);
      file = -1;
    }
  };
  read(files[0], out_, result_.out);
  read(files[1], err_, result_.err);
  return true;
}

bool Child::WaitFor(const std::string& text) {
  const Clock::time_point deadline = Clock::now() + std::chrono::minutes(1);
  while (result_.err.find(text) == std::string::npos) {
    if (Clock::now() > deadline || !ReadSome(100)) return false;
  }
  return true;
}

bool Child::WaitUntilItCatches(int signal) const {
  const std::string status = "/proc/" + std::to_string(pid_) + "/status";
  const Clock::time_point deadline = Clock::now() + std::chrono::minutes(1);
  while (Clock::now() < deadline) {
    std::ifstream file(status);
    std::string line;
    while (std::getline(file, line) && !line.starts_with("SigCgt:")) {
    }
    if (!file) return false;
    const unsigned long long caught = std::stoull(line.substr(7), nullptr, 16);
    if (caught >> (signal - 1) & 1) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

void Child::Send(int signal) { ::kill(pid_, signal); }

void Child::Type(const std::string& keys) {
  if (::write(err_, keys.data(), keys.size()) < 0) std::abort();
}

Result Child::Wait() {
  const Clock::time_point deadline = Clock::now() + std::chrono::minutes(2);
  while (ReadSome(100)) {
    if (Clock::now() > deadline) ::kill(pid_, SIGKILL);
  }
  int status = 0;
  ::waitpid(pid_, &status, 0);
  pid_ = -1;
  if (WIFEXITED(status)) result_.status = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result_.signal = WTERMSIG(status);
  result_.started = result_.status != NotStarted;
  return result_;
}

Result RunSnell(const std::vector<std::string>& arguments, const Surroundings& surroundings) {
  return Child(arguments, surroundings).Wait();
}

int RunOther(const std::vector<std::string>& words, std::string* output) {
  const std::vector<char*> argv = Pointers(words);
  const Channel pipe = OpenPipe();
  const pid_t pid = ::fork();
  if (pid == 0) {
    ::dup2(pipe.child, STDOUT_FILENO);
    ::dup2(pipe.child, STDERR_FILENO);
    ::execvp(argv[0], argv.data());
    ::_exit(NotStarted);
  }
  ::close(pipe.child);
  std::string text;
  char bytes[4096];
  for (ssize_t got; (got = ::read(pipe.parent, bytes, sizeof bytes)) > 0;)
    text.append(bytes, std::size_t(got));
  ::close(pipe.parent);
  int status = 0;
  ::waitpid(pid, &status, 0);
  if (output) *output = text;
  return WIFEXITED(status) && WEXITSTATUS(status) != NotStarted ? WEXITSTATUS(status) : -1;
}

}  // namespace snell::test
