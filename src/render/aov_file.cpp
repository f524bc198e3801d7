// SPDX-License-Identifier: Apache-2.0
//
// An AovFilm as bytes: names of its AOVs and light groups, the number of halves, names of objects and materials, then its
// arrays, each as its length and its elements as they lie in memory (little endian). A text is an array, too; a list of
// them is its length and the texts.
#include <limits>
#include <type_traits>

#include "render/aov_film.h"
#include "util/error.h"

namespace snell::render {

namespace {

using Texts = std::vector<std::string>;

template <class Array>
void WriteArray(const Array& array, const AovFilm::Sink& write) {
  static_assert(std::is_trivially_copyable_v<typename Array::value_type>);
  const std::uint64_t length = array.size();
  write(&length, sizeof length);
  if (length > 0) write(array.data(), array.size() * sizeof array[0]);
}

void WriteTexts(const Texts& texts, const AovFilm::Sink& write) {
  const std::uint64_t length = texts.size();
  write(&length, sizeof length);
  for (const std::string& text : texts) WriteArray(text, write);
}

void WriteCoverages(const std::vector<Coverage>& coverages, const AovFilm::Sink& write) {
  std::vector<std::uint32_t> flat;
  for (const Coverage& coverage : coverages) {
    flat.push_back(std::uint32_t(coverage.counts().size()));
    for (const auto& [id, count] : coverage.counts()) flat.insert(flat.end(), {id, count});
  }
  WriteArray(flat, write);
}

Error Fault() { return Error("the film file's layers make no sense"); }

// Takes arrays from the front of what is left.
class Rest {
 public:
  Rest(std::uint64_t size, const AovFilm::Source& read) : left_(size), read_(read) {}

  std::uint64_t Number() {
    std::uint64_t number = 0;
    Take(&number, sizeof number);
    return number;
  }
  template <class Array>
  Array ReadArray() {
    const std::uint64_t length = Number();
    if (length > left_ / sizeof(typename Array::value_type)) throw Fault();
    Array array;
    array.resize(length);
    Take(array.data(), array.size() * sizeof(typename Array::value_type));
    return array;
  }
  Texts ReadTexts() {
    const std::uint64_t length = Number();
    if (length > left_ / sizeof length) throw Fault();
    Texts texts;
    for (std::uint64_t i = 0; i < length; ++i) texts.push_back(ReadArray<std::string>());
    return texts;
  }
  // As many as there are.
  template <class T>
  void Fill(std::vector<T>& array) {
    if (Number() != array.size()) throw Fault();
    Take(array.data(), array.size() * sizeof(T));
  }
  void Fill(std::vector<Coverage>& coverages) {
    const auto flat = ReadArray<std::vector<std::uint32_t>>();
    std::size_t at = 0;
    for (Coverage& coverage : coverages) {
      if (at >= flat.size() || flat[at] > (flat.size() - at - 1) / 2) throw Fault();
      const std::size_t end = at + 1 + 2 * std::size_t(flat[at]);
      for (++at; at < end; at += 2) coverage.Add(flat[at], flat[at + 1]);
    }
    if (at != flat.size()) throw Fault();
  }
  std::uint64_t left() const { return left_; }

 private:
  void Take(void* to, std::size_t size) {
    if (size > left_) throw Fault();
    if (size > 0) read_(to, size);
    left_ -= size;
  }

  std::uint64_t left_;
  const AovFilm::Source& read_;
};

}  // namespace

void AovFilm::Save(const Sink& write) const {
  Texts names;
  for (const auto& [name, aov] : scene::AovNames())
    if (aov != scene::Aov::All && wanted_.Has(aov)) names.push_back(name);
  WriteTexts(names, write);
  WriteTexts(lightGroups_, write);
  const std::uint64_t halves = halves_;
  write(&halves, sizeof halves);
  WriteTexts(objectNames_, write);
  WriteTexts(materialNames_, write);
  WriteArray(counts_, write);
  WriteArray(sums_, write);
  WriteArray(nearest_, write);
  WriteCoverages(objects_, write);
  WriteCoverages(materials_, write);
}

AovFilm AovFilm::Load(PixelRect rect, std::uint64_t size, const Source& read) {
  // What there is
  Rest rest(size, read);
  scene::AovSet wanted;
  for (const std::string& name : rest.ReadTexts()) {
    bool isKnown = false;
    for (const auto& [known, aov] : scene::AovNames()) {
      if (known == name) {
        wanted.Add(aov);
        isKnown = true;
      }
    }
    if (!isKnown) throw Fault();
  }
  Texts groups = rest.ReadTexts();
  const std::uint64_t halves = rest.Number();
  if (groups.size() > kernel::MaxLightGroups || halves < 1 || halves > 2) throw Fault();
  Texts objects = rest.ReadTexts(), materials = rest.ReadTexts();

  // The arrays are not larger than the bytes that are left
  std::array<std::size_t, SumCount> places;
  const std::uint64_t sums = PlaceSums(wanted, halves == 2, places) +
                             (wanted.Has(scene::Aov::LightGroups) ? groups.size() : 0);
  const std::uint64_t pixels = std::uint64_t(rect.Width()) * std::uint64_t(rect.Height());
  if (pixels > rest.left() / (halves * (sums * sizeof(Sum3) + sizeof(std::uint32_t))))
    throw Fault();
  AovFilm film(rect, wanted, std::move(groups), halves == 2);
  film.objectNames_ = std::move(objects);
  film.materialNames_ = std::move(materials);
  rest.Fill(film.counts_);
  rest.Fill(film.sums_);
  rest.Fill(film.nearest_);
  rest.Fill(film.objects_);
  rest.Fill(film.materials_);
  if (rest.left() != 0 || !film.IsSound()) throw Fault();
  return film;
}

// Whether samples can have added up to this.
bool AovFilm::IsSound() const {
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    for (std::size_t k = 0; k < stride_; ++k) {
      for (const ExactSum& sum : sums_[i * stride_ + k])
        if (!sum.MayHave(counts_[i])) return false;
    }
  }
  const auto covers = [&](const std::vector<Coverage>& coverages) {
    for (std::size_t pixel = 0; pixel < coverages.size(); ++pixel) {
      std::uint64_t sum = 0;
      for (const auto& [id, count] : coverages[pixel].counts()) sum += count;
      if (sum > Count(pixel)) return false;
    }
    return true;
  };
  return covers(objects_) && covers(materials_);
}

}  // namespace snell::render
