// SPDX-License-Identifier: Apache-2.0
//
// Errors that are the world's fault (a file, a device, memory): a message, the place where the cause
// stands, and a hint what to do. Thrown as `snell::Error`; one Error may carry several diagnostics, so
// that a reader can report every mistake of a file in one go. Our own mistakes are CHECKs (check.h).
// This header is installed.
#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#if defined(__GNUC__)
#define SNELL_EXPORT __attribute__((visibility("default")))
#else
#define SNELL_EXPORT
#endif

namespace snell {

// A place in a file. `line` and `column` count from 1; 0 means unknown. `offset` is a byte offset for
// binary files, -1 where it has no meaning.
struct Place {
  std::string file = {};
  int line = 0;
  int column = 0;
  std::int64_t offset = -1;
};

// "scene.toml:12:9", "mesh.ply, byte 4711", "mesh.ply" or "" for no place at all.
SNELL_EXPORT std::string ToString(const Place& place);

// One finding about an input: what is wrong, where, and what may help. `hint` may be empty.
struct Diagnostic {
  std::string message;
  Place place = {};
  std::string hint = {};
};

// "place: message; hint" on one line, without the parts that are empty.
SNELL_EXPORT std::string ToString(const Diagnostic& diagnostic);

// The exception for faults of the world. `what()` holds one line per diagnostic.
class SNELL_EXPORT Error : public std::runtime_error {
 public:
  explicit Error(std::string message, Place place = {}, std::string hint = {});
  explicit Error(std::vector<Diagnostic> diagnostics);

  // At least one; in the order of the file.
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

// Receives warnings; owned by the caller, called from one thread at a time.
using WarningSink = std::function<void(const Diagnostic&)>;

}  // namespace snell
