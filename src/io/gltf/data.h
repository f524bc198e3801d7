// SPDX-License-Identifier: Apache-2.0
//
// Numbers from a glTF document's buffers: buffer views, which may be compressed, and accessors of every
// kind. All sizes and offsets are checked here, once; nothing else touches the buffers.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "io/gltf/document.h"

namespace snell::io {

class GltfData {
 public:
  explicit GltfData(const GltfDocument& document) : document_(document) {}

  // The bytes of a buffer view, uncompressed. They live as long as this object. Throws Error if the view
  // does not exist or reaches beyond its buffer.
  std::string_view View(int index);

  // The elements of an accessor with `components` numbers each, one after the other; normalized integers
  // as the fractions that they stand for. Throws Error if the accessor is not of this type, is not
  // `count` long (unless that is AnyCount), or reaches beyond its view.
  std::vector<float> Floats(int accessor, int components, std::size_t count = AnyCount);
  std::vector<std::uint32_t> Indices(int accessor);

  static constexpr std::size_t AnyCount = ~std::size_t(0);

  // Of an accessor that exists, else Error.
  const tinygltf::Accessor& Accessor(int index) const;
  const GltfDocument& document() const { return document_; }

 private:
  struct Elements {
    std::string_view bytes;  // of the first element and all that follow
    std::size_t stride = 0;
    std::size_t size = 0;  // of an element
  };
  Elements ElementsOf(int view, std::size_t offset, std::size_t count, std::size_t size,
                      bool strided, const std::string& part);
  // A small file may refer to the same elements again and again: throws Error at a limit.
  void CountNumbers(std::size_t count, const std::string& part);
  template <typename T, typename Convert>
  std::vector<T> Read(int accessor, int components, std::size_t count, const Convert& convert);

  const GltfDocument& document_;
  std::map<int, std::string> decompressed_;
  std::uint64_t numbersRead_ = 0;
};

// The bytes of a view with EXT_meshopt_compression. Throws Error.
std::string DecodeMeshopt(const tinygltf::Value& extension, std::string_view source,
                          const GltfDocument& document, const std::string& part);

// The part [offset, offset + length) of a buffer. Throws Error.
std::string_view GltfBytes(const GltfDocument& document, int buffer, std::size_t offset,
                           std::size_t length, const std::string& part);

}  // namespace snell::io
