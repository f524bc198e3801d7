// SPDX-License-Identifier: Apache-2.0
//
// The sums of an AovFilm as bytes: each array as its length, then its elements as they lie in memory (little endian).
#include <cstring>
#include <type_traits>

#include "render/aov_film.h"
#include "util/error.h"

namespace snell::render {

namespace {

using Counts = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

void Append(const void* data, std::size_t size, std::string& bytes) {
  bytes.append(static_cast<const char*>(data), size);
}

template <class T>
void AppendArray(const std::vector<T>& array, std::string& bytes) {
  static_assert(std::is_trivially_copyable_v<T>);
  const std::uint64_t length = array.size();
  Append(&length, sizeof length, bytes);
  Append(array.data(), array.size() * sizeof(T), bytes);
}

void AppendCoverages(const std::vector<Coverage>& coverages, std::string& bytes) {
  std::vector<std::uint32_t> flat;
  for (const Coverage& coverage : coverages) {
    flat.push_back(std::uint32_t(coverage.counts().size()));
    for (const auto& [id, count] : coverage.counts()) flat.insert(flat.end(), {id, count});
  }
  AppendArray(flat, bytes);
}

// Takes arrays from the front.
class Rest {
 public:
  explicit Rest(std::string_view bytes) : bytes_(bytes) {}

  template <class T>
  std::vector<T> Array() {
    std::uint64_t length = 0;
    Take(&length, sizeof length);
    if (length > bytes_.size() / sizeof(T)) throw Fault();
    std::vector<T> array(length);
    Take(array.data(), array.size() * sizeof(T));
    return array;
  }
  // As many as there were.
  template <class T>
  void Fill(std::vector<T>& array) {
    std::vector<T> read = Array<T>();
    if (read.size() != array.size()) throw Fault();
    array = std::move(read);
  }
  void Fill(std::vector<Coverage>& coverages) {
    const std::vector<std::uint32_t> flat = Array<std::uint32_t>();
    std::size_t at = 0;
    for (Coverage& coverage : coverages) {
      coverage = {};
      if (at >= flat.size() || flat[at] > (flat.size() - at - 1) / 2) throw Fault();
      const std::size_t end = at + 1 + 2 * std::size_t(flat[at]);
      for (++at; at < end; at += 2) coverage.Add(flat[at], flat[at + 1]);
    }
    if (at != flat.size()) throw Fault();
  }
  void End() const {
    if (!bytes_.empty()) throw Fault();
  }

 private:
  static Error Fault() { return Error("the AOVs are not those of this render, or damaged"); }
  void Take(void* to, std::size_t size) {
    if (size > bytes_.size()) throw Fault();
    if (size > 0) std::memcpy(to, bytes_.data(), size);
    bytes_.remove_prefix(size);
  }

  std::string_view bytes_;
};

}  // namespace

std::string AovFilm::Save() const {
  std::string bytes;
  AppendArray(counts_, bytes);
  AppendArray(sums_, bytes);
  AppendArray(nearest_, bytes);
  AppendCoverages(objects_, bytes);
  AppendCoverages(materials_, bytes);
  return bytes;
}

void AovFilm::Load(std::string_view bytes) {
  Rest rest(bytes);
  rest.Fill(counts_);
  rest.Fill(sums_);
  rest.Fill(nearest_);
  rest.Fill(objects_);
  rest.Fill(materials_);
  rest.End();
}

}  // namespace snell::render
