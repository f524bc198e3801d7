// SPDX-License-Identifier: Apache-2.0
//
// Files: reading whole files under a size limit, finding the files that a scene names without leaving
// its folder, and writing so that a reader never sees half a file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace snell {

// Bytes of memory that one input file may take unless the caller says otherwise: 16 GiB.
inline constexpr std::uint64_t DefaultFileLimit = std::uint64_t(16) << 30;

// The whole file as bytes. Throws Error if it cannot be read, is no regular file or is larger than
// `limit` bytes; then `hint` says what may help.
std::string ReadFile(const std::filesystem::path& path, std::uint64_t limit = DefaultFileLimit,
                     std::string hint = {});

// The path of the file that `name`, as written in `from`'s folder, refers to. Backslashes count as
// slashes. Throws Error (without a place) if the name is absolute or leads out of `root`, also by a
// symbolic link: a scene reads nothing outside its own folder.
std::filesystem::path ConfinedPath(const std::filesystem::path& root,
                                   const std::filesystem::path& fromFolder, std::string_view name);

// The same for several folders, of which the first is the scene's own. In the others files may also be named
// by absolute paths.
std::filesystem::path ConfinedPath(const std::vector<std::filesystem::path>& roots,
                                   const std::filesystem::path& fromFolder, std::string_view name);

// A file that appears under its name only when it is complete: written to "NAME.partial-PID" in the
// same folder, flushed to disk and renamed by Commit(); removed if the writer is destroyed before. A
// symbolic link stays one, what it leads to is replaced. What is no regular file, such as a device or a
// pipe, is written to directly. Every function throws Error with the name and the system's reason.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void Write(const void* bytes, std::size_t size);
  void Write(std::string_view text) { Write(text.data(), text.size()); }
  void Commit();

 private:
  [[noreturn]] void Fail(const char* verb);

  std::filesystem::path path_;       // as given, for messages
  std::filesystem::path target_;     // where links lead
  std::filesystem::path temporary_;  // empty: written directly
  std::FILE* stream_ = nullptr;
};

// Remove what writers of this file have left that were killed: "NAME.partial-PID" of processes that are gone.
void RemoveAbandoned(const std::filesystem::path& path);

// Throws the Error that writing the file would begin with, and leaves it as it is. A device or a pipe is
// not opened: its reader would take that for all.
void CheckFileWritable(const std::filesystem::path& path);

// Write all of `bytes` atomically.
void WriteFile(const std::filesystem::path& path, std::string_view bytes);

// The extension in lower case without its dot: "png" for "A/b.PNG", "" if there is none.
std::string LowerExtension(const std::filesystem::path& path);

}  // namespace snell
