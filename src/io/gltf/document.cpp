// SPDX-License-Identifier: Apache-2.0
#include <fstream>  // of tinygltf's writer
#include <sstream>

#define TINYGLTF_IMPLEMENTATION
#include "io/gltf/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/gltf/uri.h"
#include "util/file.h"
#include "util/text.h"

namespace snell::io {
namespace {

using Json = nlohmann::json;

constexpr int DepthLimit = 64;  // of nested JSON

Place PlaceOfByte(std::string_view text, std::size_t byte, const std::string& file, bool binary) {
  if (binary) return {.file = file, .offset = std::int64_t(20 + byte)};
  const std::string_view before = text.substr(0, byte);
  const std::size_t line = before.rfind('\n') + 1;  // 0 if there is none
  return {.file = file,
          .line = int(std::ranges::count(before, '\n')) + 1,
          .column = int(before.size() - line) + 1};
}

// The document without the `extras` of applications. Deep nesting is refused: what follows recurses.
Json ParseJson(std::string_view text, const std::string& file, bool binary) {
  try {
    return Json::parse(text, [&](int depth, Json::parse_event_t event, Json& parsed) {
      if (depth > DepthLimit)
        throw Error(fmt::format("the JSON is nested more than {} levels deep", DepthLimit), {file});
      return event != Json::parse_event_t::key || parsed != "extras";
    });
  } catch (const Json::parse_error& error) {
    const std::size_t byte = error.byte > 0 ? error.byte - 1 : 0;
    throw Error("the JSON is malformed here or just before",
                PlaceOfByte(text, std::min(byte, text.size()), file, binary));
  } catch (const Json::exception&) {
    throw Error("the JSON holds a number that is too large", {file});
  }
}

// Prepares the JSON for tinygltf 2.7, which reads what these parts refer to without checks.
class Preparation {
 public:
  Preparation(Json& json, GltfDocument& document) : json_(json), document_(document) {}

  void CheckVersion() {
    const auto asset = json_.find("asset");
    if (asset == json_.end() || !asset->is_object())
      throw document_.Fault("", "there is no 'asset', which every glTF document has");
    for (const char* key : {"minVersion", "version"}) {
      const std::string version = Text(*asset, key);
      const bool isMinimum = key == std::string_view("minVersion");
      if (isMinimum && version.empty()) continue;
      if (isMinimum ? version != "2.0" : !version.starts_with("2."))
        throw document_.Fault("", fmt::format("this is glTF {}; Snell reads glTF 2.0",
                                              version.empty() ? "without a version" : version));
    }
  }

  void TakeBuffers(const GltfContainer& container) {
    const Json buffers = Take("buffers");
    for (std::size_t i = 0; i < buffers.size(); ++i) {
      const std::string part = GltfPart("buffer", i);
      const Json& buffer = buffers[i];
      if (!buffer.is_object()) throw document_.Fault(part, "not an object");
      const std::string uri = Text(buffer, "uri");
      std::string bytes;
      if (!uri.empty()) {
        try {
          bytes = ReadGltfUri(document_.folders, uri, document_.limits);
        } catch (const Error& error) {
          const Diagnostic& cause = error.diagnostics().front();
          throw document_.Fault(part, ShortUri(uri) + ": " + cause.message, cause.hint);
        }
      } else if (i == 0 && container.hasBinary) {
        bytes = container.binary;
      }
      const auto length = buffer.find("byteLength");
      if (length != buffer.end() && length->is_number_unsigned()) {
        const std::uint64_t promised = length->get<std::uint64_t>();
        if (promised > bytes.size() && !bytes.empty())
          document_.findings.Note("a buffer is shorter than it should be", part);
        if (promised < bytes.size()) bytes.resize(std::size_t(promised));
      }
      document_.buffers.push_back(std::move(bytes));
    }
  }

  void TakeImages() {
    const Json images = Take("images");
    for (std::size_t i = 0; i < images.size(); ++i) {
      if (!images[i].is_object()) throw document_.Fault(GltfPart("image", i), "not an object");
      document_.images.push_back(
          {Text(images[i], "name"), Text(images[i], "uri"), Integer(images[i], "bufferView")});
    }
  }

  // tinygltf refuses strides that are not a multiple of four, which exporters write
  void TakeStrides() {
    for (Json& view : Array("bufferViews")) {
      const auto stride = view.is_object() ? view.find("byteStride") : view.end();
      const bool given = view.is_object() && stride != view.end() && stride->is_number_unsigned();
      document_.strides.push_back(given ? stride->get<std::size_t>() : 0);
      if (given) view.erase("byteStride");
    }
  }

  // tinygltf wants a buffer view behind all indices, which Draco's streams and zeros do not have; attributes
  // need none
  void TakeIndices() {
    for (Json& mesh : Array("meshes")) {
      if (!mesh.is_object() || !mesh.contains("primitives")) continue;
      for (Json& primitive : mesh["primitives"]) {
        const int indices = Integer(primitive, "indices");
        if (!primitive.is_object() || !primitive.contains("indices")) continue;
        primitive.erase("indices");
        if (primitive.contains("attributes") && primitive["attributes"].is_object())
          primitive["attributes"][GltfDocument::Indices] = indices;
      }
    }
  }

  // tinygltf leaves the numbers of incomplete sparse accessors undefined
  void CheckSparse() {
    const Json& accessors = Array("accessors");
    for (std::size_t i = 0; i < accessors.size(); ++i) {
      if (!accessors[i].is_object() || !accessors[i].contains("sparse")) continue;
      const Json& sparse = accessors[i]["sparse"];
      const bool complete = Integer(sparse, "count") > 0 && HasView(sparse, "indices") &&
                            HasView(sparse, "values") &&
                            Integer(sparse["indices"], "componentType") > 0;
      if (!complete) throw document_.Fault(GltfPart("accessor", i), "'sparse' is not complete");
    }
  }

 private:
  static std::string Text(const Json& object, const char* key) {
    const auto member = object.is_object() ? object.find(key) : object.end();
    if (!object.is_object() || member == object.end() || !member->is_string()) return {};
    return member->get<std::string>();
  }
  // -1 if it is absent, no integer, negative or too large.
  static int Integer(const Json& object, const char* key) {
    if (!object.is_object() || !object.contains(key)) return -1;
    const Json& member = object[key];
    if (!member.is_number_unsigned() || member.get<std::uint64_t>() > 0x7fffffff) return -1;
    return member.get<int>();
  }
  static bool HasView(const Json& sparse, const char* key) {
    return sparse.is_object() && sparse.contains(key) && Integer(sparse[key], "bufferView") >= 0 &&
           (!sparse[key].contains("byteOffset") || Integer(sparse[key], "byteOffset") >= 0);
  }
  // An array at the top; empty if it is absent.
  Json& Array(const char* key) {
    const auto member = json_.find(key);
    if (member == json_.end()) return empty_ = Json::array();
    if (!member->is_array()) throw document_.Fault("", fmt::format("'{}' is not an array", key));
    return *member;
  }
  Json Take(const char* key) {
    Json taken = std::move(Array(key));
    json_.erase(key);
    return taken;
  }

  Json& json_;
  GltfDocument& document_;
  Json empty_;
};

// Let tinygltf make records of the rest.
void ParseRest(const Json& json, GltfDocument& document) {
  const std::string text = json.dump();
  const std::uint64_t limit = std::min<std::uint64_t>(document.limits.jsonBytes, 0x7fffffff);
  if (text.size() > limit)
    throw document.Fault("",
                         fmt::format("the JSON has {} without data; the limit is {}",
                                     ByteSize(text.size()), ByteSize(limit)),
                         LiftedBy(&ReadLimits::jsonBytes));
  tinygltf::TinyGLTF parser;
  std::string errors, warnings;
  const bool parsed = parser.LoadASCIIFromString(&document.model, &errors, &warnings, text.c_str(),
                                                 unsigned(text.size()), "");
  // What it says, a line each
  for (std::size_t at = 0; at < errors.size();) {
    const std::size_t end = std::min(errors.find('\n', at), errors.size());
    std::string line = errors.substr(at, end - at);
    at = end + 1;
    while (!line.empty() && (line.back() == '.' || line.back() == ' ')) line.pop_back();
    const bool isOptional = line.find("'inverseBindMatrices'") != std::string::npos;
    if (line.empty() || isOptional) continue;
    if (!parsed) throw document.Fault("", "the document is malformed: " + line);
    document.findings.Note("a malformed part is left out: " + line);
  }
  if (!parsed) throw document.Fault("", "the document is malformed");
}

}  // namespace

Error GltfDocument::Fault(std::string_view part, std::string_view message, std::string hint) const {
  return Error(part.empty() ? std::string(message) : fmt::format("{}: {}", part, message),
               {path.string()}, std::move(hint));
}

GltfDocument OpenGltf(const std::filesystem::path& path, const ReadOptions& options) {
  GltfDocument document;
  document.path = path;
  document.limits = options.limits;
  document.folders = FoldersOf(path, options);
  const std::string bytes = ReadWithin(path, document.limits);
  if (bytes.empty()) throw document.Fault("", "the file is empty");
  const GltfContainer container = SplitGltf(bytes, path.string());
  const bool isBinary = bytes.starts_with("glTF");
  Json json = ParseJson(container.json, path.string(), isBinary);
  if (!json.is_object()) throw document.Fault("", "the JSON is no object");

  try {
    Preparation preparation(json, document);
    preparation.CheckVersion();
    preparation.TakeBuffers(container);
    preparation.TakeImages();
    preparation.TakeStrides();
    preparation.TakeIndices();
    preparation.CheckSparse();
    ParseRest(json, document);
  } catch (const Json::exception&) {
    throw document.Fault("", "the document is malformed");
  }
  document.strides.resize(document.model.bufferViews.size());
  CheckGltfExtensions(document);
  return document;
}

}  // namespace snell::io
