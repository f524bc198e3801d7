// SPDX-License-Identifier: Apache-2.0
//
// EXT_meshopt_compression: buffer views packed by meshoptimizer. Its decoders are made for untrusted input.
#include <fmt/format.h>
#include <meshoptimizer.h>

#include "io/gltf/data.h"
#include "io/gltf/value.h"
#include "util/text.h"

namespace snell::io {

// The codecs' best case is about 1 to 64 plus a block of at most 8 KiB.
static constexpr std::size_t BestCompression = 100;
static constexpr std::size_t BlockSize = 8192;

std::string DecodeMeshopt(const tinygltf::Value& extension, std::string_view source,
                          const GltfDocument& document, const std::string& part) {
  const GltfValue value(extension);
  const std::size_t count = value.Size("count"), stride = value.Size("byteStride");
  const std::string mode = value.Text("mode"), filter = value.Text("filter");
  const auto fault = [&](std::string_view message) {
    return document.Fault(part + ", EXT_meshopt_compression", message);
  };

  // What each decoder asks for, and whether the result can be in so few bytes
  const bool isAttributes = mode == "ATTRIBUTES";
  if (!isAttributes && mode != "TRIANGLES" && mode != "INDICES") throw fault("unknown mode");
  const bool strideFits =
      isAttributes ? stride > 0 && stride <= 256 && stride % 4 == 0 : stride == 2 || stride == 4;
  if (!strideFits) throw fault(fmt::format("a stride of {} is not possible", stride));
  if (count == 0 || (mode == "TRIANGLES" && count % 3 != 0)) throw fault("a wrong count");
  if (count > (source.size() * BestCompression + BlockSize) / stride)
    throw fault(
        fmt::format("{} cannot hold {}", Plural(source.size(), "byte"), Plural(count, "element")));

  std::string bytes(count * stride, '\0');
  const auto* from = reinterpret_cast<const unsigned char*>(source.data());
  const int result =
      isAttributes ? meshopt_decodeVertexBuffer(bytes.data(), count, stride, from, source.size())
      : mode == "TRIANGLES"
          ? meshopt_decodeIndexBuffer(bytes.data(), count, stride, from, source.size())
          : meshopt_decodeIndexSequence(bytes.data(), count, stride, from, source.size());
  if (result != 0) throw fault("the data is damaged");

  if (filter.empty() || filter == "NONE") return bytes;
  if (!isAttributes) throw fault("filters are for attributes");
  if (filter == "OCTAHEDRAL" && (stride == 4 || stride == 8)) {
    meshopt_decodeFilterOct(bytes.data(), count, stride);
  } else if (filter == "QUATERNION" && stride == 8) {
    meshopt_decodeFilterQuat(bytes.data(), count, stride);
  } else if (filter == "EXPONENTIAL") {
    meshopt_decodeFilterExp(bytes.data(), count, stride);
  } else {
    throw fault("unknown filter, or one that does not fit the stride");
  }
  return bytes;
}

}  // namespace snell::io
