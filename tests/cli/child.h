// SPDX-License-Identifier: Apache-2.0
//
// Runs the program as a child process, as a shell would: with pipes or at a terminal of its own, in any
// folder, under limits, and with signals.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace snell::test {

struct Surroundings {
  std::filesystem::path folder = {};  // the current folder; empty: this process's
  bool terminal = false;              // all three streams are a terminal of 80 columns
  std::string terminalKind = "xterm";
  std::string outputFile = {};  // the standard output goes there; empty: it is read
  // Called in the child before the program starts; only system calls are allowed. False: do not start.
  std::function<bool()> prepare = {};
};

struct Result {
  int status = -1;      // exit status; -1 if a signal ended it
  int signal = 0;       // that ended it; 0 if none did
  bool started = true;  // false if `prepare` said so
  std::string out;
  std::string err;  // all that a terminal showed, if there is one
};

class Child {
 public:
  explicit Child(const std::vector<std::string>& arguments, const Surroundings& surroundings = {});
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  // Wait until the standard error output, or the terminal, shows `text`. False if the program ends or a
  // minute passes before.
  bool WaitFor(const std::string& text);
  // Wait until the program handles a signal itself. False if the system does not tell.
  bool WaitUntilItCatches(int signal) const;
  void Send(int signal);
  // Press keys at the terminal.
  void Type(const std::string& keys);
  // Wait for the end. A program that is still running after two minutes is killed.
  Result Wait();

 private:
  bool ReadSome(int milliseconds);

  pid_t pid_ = -1;
  int out_ = -1;
  int err_ = -1;
  bool terminal_ = false;
  Result result_;
};

// Run the program to its end.
Result RunSnell(const std::vector<std::string>& arguments, const Surroundings& surroundings = {});

// Run another program, found along PATH; its exit status, -1 if it cannot be started.
int RunOther(const std::vector<std::string>& words, std::string* output = nullptr);

}  // namespace snell::test
