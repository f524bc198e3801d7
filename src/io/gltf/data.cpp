// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "io/gltf/value.h"
#include "util/text.h"

namespace snell::io {
namespace {

// Elements of an accessor without a buffer view: zeros, as far as `sparse` does not replace them.
constexpr std::size_t ZerosLimit = std::size_t(1) << 24;

template <typename C>
C Load(const char* at) {
  C value;
  std::memcpy(&value, at, sizeof(C));
  return value;
}

// Call `use` with a zero of the C++ type of a component; false if there is no such type in glTF.
template <typename Use>
bool WithComponent(int componentType, const Use& use) {
  switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: use(std::int8_t()); return true;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: use(std::uint8_t()); return true;
    case TINYGLTF_COMPONENT_TYPE_SHORT: use(std::int16_t()); return true;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: use(std::uint16_t()); return true;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: use(std::uint32_t()); return true;
    case TINYGLTF_COMPONENT_TYPE_FLOAT: use(float()); return true;
    default: return false;
  }
}

std::size_t ComponentSize(int componentType) {
  std::size_t size = 0;
  WithComponent(componentType, [&](auto zero) { size = sizeof(zero); });
  return size;
}

}  // namespace

std::string_view GltfBytes(const GltfDocument& document, int buffer, std::size_t offset,
                           std::size_t length, const std::string& part) {
  if (buffer < 0 || std::size_t(buffer) >= document.buffers.size())
    throw document.Fault(part, fmt::format("there is no buffer {}", buffer));
  const std::string_view bytes = document.buffers[std::size_t(buffer)];
  if (offset > bytes.size() || length > bytes.size() - offset)
    throw document.Fault(part, fmt::format("it reaches beyond the {} of buffer {}",
                                           Plural(bytes.size(), "byte"), buffer));
  return bytes.substr(offset, length);
}

std::string_view GltfData::View(int index) {
  const auto& views = document_.model.bufferViews;
  if (index < 0 || std::size_t(index) >= views.size())
    throw document_.Fault("", fmt::format("there is no buffer view {}", index));
  const tinygltf::BufferView& view = views[std::size_t(index)];
  const std::string part = GltfPart("buffer view", std::size_t(index));
  const auto compressed = view.extensions.find("EXT_meshopt_compression");
  if (compressed == view.extensions.end())
    return GltfBytes(document_, view.buffer, view.byteOffset, view.byteLength, part);

  const auto [entry, isNew] = decompressed_.try_emplace(index);
  if (isNew) {
    const GltfValue source(compressed->second);
    const std::string_view bytes =
        GltfBytes(document_, source.Integer("buffer"), source.Size("byteOffset"),
                  source.Size("byteLength"), part);
    entry->second = DecodeMeshopt(compressed->second, bytes, document_, part);
  }
  return entry->second;
}

const tinygltf::Accessor& GltfData::Accessor(int index) const {
  const auto& accessors = document_.model.accessors;
  if (index < 0 || std::size_t(index) >= accessors.size())
    throw document_.Fault("", fmt::format("there is no accessor {}", index));
  return accessors[std::size_t(index)];
}

GltfData::Elements GltfData::ElementsOf(int view, std::size_t offset, std::size_t count,
                                        std::size_t size, bool strided, const std::string& part) {
  const std::string_view bytes = View(view);
  Elements elements{{}, size, size};
  if (const std::size_t stride = document_.strides[std::size_t(view)]; strided && stride > 0)
    elements.stride = stride;
  const bool fits = offset <= bytes.size() && size <= bytes.size() - offset &&
                    count - 1 <= (bytes.size() - offset - size) / elements.stride;
  if (!fits)
    throw document_.Fault(
        part, fmt::format("its {} reach beyond the {} of buffer view {}", Plural(count, "element"),
                          Plural(bytes.size(), "byte"), view));
  elements.bytes = bytes.substr(offset);
  return elements;
}

void GltfData::CountNumbers(std::size_t count, const std::string& part) {
  numbersRead_ += count;
  if (numbersRead_ > document_.limits.numbers)
    throw document_.Fault(part, "the file's parts read more numbers than Snell allows",
                          LiftedBy(&ReadLimits::numbers));
}

template <typename T, typename Convert>
std::vector<T> GltfData::Read(int index, int components, std::size_t count,
                              const Convert& convert) {
  const tinygltf::Accessor& accessor = Accessor(index);
  const std::string part = GltfPart("accessor", std::size_t(index));
  const std::size_t width = std::size_t(components);
  const std::size_t size = ComponentSize(accessor.componentType) * width;
  if (size == 0) throw document_.Fault(part, "its component type is not one of glTF's");
  if (tinygltf::GetNumComponentsInType(std::uint32_t(accessor.type)) != components)
    throw document_.Fault(part, fmt::format("{} needed in each element", Plural(width, "number")));
  if (accessor.count == 0) throw document_.Fault(part, "it has no elements");
  if (count != AnyCount && accessor.count != count)
    throw document_.Fault(part, fmt::format("it has {}, {} are needed",
                                            Plural(accessor.count, "element"), WithCommas(count)));

  // The elements themselves, or zeros
  std::vector<T> values;
  if (accessor.bufferView >= 0) {
    const Elements from =
        ElementsOf(accessor.bufferView, accessor.byteOffset, accessor.count, size, true, part);
    CountNumbers(accessor.count * width, part);
    values.resize(accessor.count * width);
    WithComponent(accessor.componentType, [&](auto zero) {
      using C = decltype(zero);
      for (std::size_t i = 0; i < accessor.count; ++i)
        for (std::size_t k = 0; k < width; ++k)
          values[i * width + k] =
              convert(Load<C>(from.bytes.data() + i * from.stride + k * sizeof(C)), accessor);
    });
  } else {
    if (accessor.count > ZerosLimit)
      throw document_.Fault(part,
                            fmt::format("{} without a buffer view; the limit is {}",
                                        Plural(accessor.count, "element"), WithCommas(ZerosLimit)));
    CountNumbers(accessor.count * width, part);
    values.resize(accessor.count * width);
  }
  if (!accessor.sparse.isSparse) return values;

  // Replace some
  const auto& sparse = accessor.sparse;
  const std::size_t replaced = std::size_t(sparse.count);
  const std::size_t indexSize = ComponentSize(sparse.indices.componentType);
  const bool isIndex = sparse.indices.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                       sparse.indices.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                       sparse.indices.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  if (!isIndex) throw document_.Fault(part, "the sparse indices are not of a type for indices");
  const Elements indices =
      ElementsOf(sparse.indices.bufferView, std::size_t(sparse.indices.byteOffset), replaced,
                 indexSize, false, part);
  const Elements from = ElementsOf(sparse.values.bufferView, std::size_t(sparse.values.byteOffset),
                                   replaced, size, false, part);
  for (std::size_t i = 0; i < replaced; ++i) {
    std::size_t target = 0;
    WithComponent(sparse.indices.componentType, [&](auto zero) {
      target = std::size_t(Load<decltype(zero)>(indices.bytes.data() + i * indexSize));
    });
    if (target >= accessor.count)
      throw document_.Fault(part, fmt::format("sparse index {} beyond its {}", target,
                                              Plural(accessor.count, "element")));
    WithComponent(accessor.componentType, [&](auto zero) {
      using C = decltype(zero);
      for (std::size_t k = 0; k < width; ++k)
        values[target * width + k] =
            convert(Load<C>(from.bytes.data() + i * size + k * sizeof(C)), accessor);
    });
  }
  return values;
}

std::vector<float> GltfData::Floats(int accessor, int components, std::size_t count) {
  return Read<float>(accessor, components, count, [](auto value, const auto& a) -> float {
    using C = decltype(value);
    if constexpr (std::is_floating_point_v<C>) {
      return value;
    } else {
      if (!a.normalized) return float(value);
      const double fraction = double(value) / double(std::numeric_limits<C>::max());
      return float(std::max(fraction, -1.0));
    }
  });
}

std::vector<std::uint32_t> GltfData::Indices(int index) {
  const int type = Accessor(index).componentType;
  const bool isIndex = type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                       type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                       type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  if (!isIndex)
    throw document_.Fault(GltfPart("accessor", std::size_t(index)),
                          "indices must be unsigned integers");
  return Read<std::uint32_t>(index, 1, AnyCount,
                             [](auto value, const auto&) { return std::uint32_t(value); });
}

}  // namespace snell::io
