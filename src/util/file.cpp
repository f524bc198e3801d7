// SPDX-License-Identifier: Apache-2.0
#include "util/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <iterator>
#include <system_error>
#include <utility>

#include "util/error.h"

namespace snell {

namespace fs = std::filesystem;

static std::string Reason() { return std::strerror(errno); }

std::string ReadFile(const fs::path& path, std::uint64_t limit, std::string hint) {
  // Opening a pipe would wait for its writer
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) throw Error(fmt::format("cannot read the file: {}", Reason()), {path.string()});
  struct Closer {
    int file;
    ~Closer() { ::close(file); }
  } closer{file};

  // Check kind and size before any memory is taken
  struct stat status = {};
  if (::fstat(file, &status) != 0)
    throw Error(fmt::format("cannot read the file: {}", Reason()), {path.string()});
  if (!S_ISREG(status.st_mode)) throw Error("not a regular file", {path.string()});
  if (std::uint64_t(status.st_size) > limit)
    throw Error(fmt::format("the file has {} bytes; the limit is {}", status.st_size, limit),
                {path.string()}, std::move(hint));

  std::string bytes(std::size_t(status.st_size), '\0');
  std::size_t filled = 0;
  while (filled < bytes.size()) {
    const ssize_t got = ::read(file, bytes.data() + filled, bytes.size() - filled);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw Error(fmt::format("cannot read the file: {}", Reason()), {path.string()});
    if (got == 0) break;
    filled += std::size_t(got);
  }
  bytes.resize(filled);
  return bytes;
}

// Whether a path without links lies in the folder or in one within it.
static bool LiesIn(const fs::path& folder, const fs::path& realPath) {
  std::error_code ignored;
  const fs::path real = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, ignored);
  const auto [end, rest] =
      std::mismatch(real.begin(), real.end(), realPath.begin(), realPath.end());
  // The name of a folder may end in a slash
  return end == real.end() || (end->empty() && std::next(end) == real.end());
}

fs::path ConfinedPath(const std::vector<fs::path>& roots, const fs::path& fromFolder,
                      std::string_view name) {
  static constexpr const char* Hint =
      "files are read only from the scene's own folder and the folders in it; --allow FOLDER adds "
      "others";
  std::string portable(name);
  std::replace(portable.begin(), portable.end(), '\\', '/');
  if (portable.empty()) throw Error("the file name is empty");
  // The system would cut it short, after the check
  if (portable.find('\0') != std::string::npos) throw Error("the file name has a zero byte");
  const bool driveLetter = portable.size() > 1 && portable[1] == ':';
  const bool absolute = portable[0] == '/' || driveLetter;

  // Resolve symbolic links too: what counts is where the bytes lie
  std::error_code ignored;
  const fs::path path = fromFolder / portable;
  const fs::path realPath = fs::weakly_canonical(fs::absolute(path, ignored), ignored);
  for (std::size_t i = absolute ? 1 : 0; i < roots.size() && !driveLetter; ++i)
    if (LiesIn(roots[i], realPath)) return path;
  throw Error(absolute ? fmt::format("'{}' is an absolute path", name)
                       : fmt::format("'{}' lies outside the scene's folder", name),
              {}, Hint);
}

fs::path ConfinedPath(const fs::path& root, const fs::path& fromFolder, std::string_view name) {
  return ConfinedPath(std::vector{root}, fromFolder, name);
}

// What a symbolic link leads to, also if that does not exist yet.
static fs::path BehindLinks(fs::path path) {
  std::error_code ignored;
  for (int links = 0; links < 40 && fs::is_symlink(path, ignored); ++links)
    path = path.parent_path() / fs::read_symlink(path, ignored);
  return path;
}

AtomicFile::AtomicFile(fs::path path) : path_(std::move(path)) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path_, ignored);
  if (fs::is_directory(status)) {
    errno = EISDIR;
    Fail("write");
  }
  target_ = BehindLinks(path_);
  if (!fs::exists(status) || fs::is_regular_file(status)) {
    temporary_ = target_;
    temporary_ += fmt::format(".partial-{}", ::getpid());
  }
  stream_ = std::fopen(temporary_.empty() ? target_.c_str() : temporary_.c_str(), "wb");
  if (!stream_) Fail("write");
}

AtomicFile::~AtomicFile() {
  if (!stream_) return;
  std::fclose(stream_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::Write(const void* bytes, std::size_t size) {
  if (std::fwrite(bytes, 1, size, stream_) != size) Fail("write");
}

void AtomicFile::Commit() {
  if (std::fflush(stream_) != 0) Fail("write");
  if (!temporary_.empty() && ::fsync(::fileno(stream_)) != 0) Fail("write");
  std::FILE* stream = stream_;
  stream_ = nullptr;
  if (temporary_.empty()) {
    if (std::fclose(stream) != 0) Fail("write");
    return;
  }
  if (std::fclose(stream) != 0 || ::rename(temporary_.c_str(), target_.c_str()) != 0) {
    const int cause = errno;
    ::unlink(temporary_.c_str());
    errno = cause;
    Fail("write");
  }
}

void AtomicFile::Fail(const char* verb) {
  throw Error(fmt::format("cannot {} the file: {}", verb, Reason()), {path_.string()});
}

void RemoveAbandoned(const fs::path& path) {
  std::error_code fault;
  const std::string prefix = path.filename().string() + ".partial-";
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::vector<fs::path> abandoned;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, fault)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(prefix)) continue;
    const std::string_view digits = std::string_view(name).substr(prefix.size());
    pid_t process = 0;
    const auto [end, failed] =
        std::from_chars(digits.data(), digits.data() + digits.size(), process);
    if (failed == std::errc() && end == digits.data() + digits.size() && process > 0 &&
        ::kill(process, 0) != 0 && errno == ESRCH)
      abandoned.push_back(entry.path());
  }
  for (const fs::path& file : abandoned) fs::remove(file, fault);
}

void CheckFileWritable(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  const bool special =
      fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
  if (!special) AtomicFile attempt(path);
}

void WriteFile(const fs::path& path, std::string_view bytes) {
  AtomicFile file(path);
  file.Write(bytes);
  file.Commit();
}

std::string LowerExtension(const fs::path& path) {
  std::string extension = path.extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

}  // namespace snell
