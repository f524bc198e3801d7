// SPDX-License-Identifier: Apache-2.0
#include "io/assimp/import.h"

#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/BaseImporter.h>
#include <algorithm>
#include <exception>
#include <sstream>
#include <utility>
#include <vector>

#include "io/assimp/files.h"
#include "io/assimp/trial.h"
#include "util/error.h"

namespace snell::io {
namespace {

// What the library says of a failure.
std::string InWords(const std::string& fault) {
  if (fault.find("bad_alloc") != fault.npos) return "reading it takes too much memory";
  return fault.empty() ? "reading it failed" : fault;
}

constexpr std::uint64_t LeastMemory = std::uint64_t(4) << 30;
constexpr std::uint64_t MemoryPerByte = 100;
constexpr int LeastSeconds = 20;
constexpr std::uint64_t BytesPerSecond = 500'000;

// The library guesses formats by contents: leave it no choice.
void KeepReaderOf(const std::string& extension, Assimp::Importer& importer) {
  std::vector<Assimp::BaseImporter*> others;
  for (std::size_t i = 0; i < importer.GetImporterCount(); ++i) {
    std::istringstream known(importer.GetImporterInfo(i)->mFileExtensions);
    bool reads = false;
    for (std::string word; known >> word;) reads |= word == extension;
    if (!reads) others.push_back(importer.GetImporter(i));
  }
  for (Assimp::BaseImporter* other : others) {
    importer.UnregisterLoader(other);
    delete other;
  }
}

class Import {
 public:
  Import(const std::filesystem::path& path, const ReadOptions& options)
      : path_(path), options_(options), bytes_(ReadWithin(path, options.limits)) {}

  // What is wrong; then there is no scene.
  std::string Run() {
    result_.importer = std::make_unique<Assimp::Importer>();
    Assimp::Importer& importer = *result_.importer;
    KeepReaderOf(LowerExtension(path_), importer);
    importer.SetIOHandler(
        new AssimpFiles(path_, bytes_, FoldersOf(path_, options_), options_.limits));
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                                aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
    unsigned steps = aiProcess_Triangulate | aiProcess_SortByPType |
                     aiProcess_JoinIdenticalVertices | aiProcess_ValidateDataStructure;
    const float smooth = options_.smooth.value_or(40);
    if (smooth > 0) {
      steps |= aiProcess_GenSmoothNormals;
      importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, std::min(smooth, 175.0f));
    }
    try {
      result_.scene = importer.ReadFile(path_.string(), steps);
    } catch (const std::exception& error) {
      return InWords(error.what());
    }
    return result_.scene ? "" : InWords(importer.GetErrorString());
  }

  TrialLimits Limits() const {
    return {std::max(LeastMemory, bytes_.size() * MemoryPerByte),
            int(LeastSeconds + bytes_.size() / BytesPerSecond)};
  }

  AssimpImport Take() { return std::move(result_); }

 private:
  std::filesystem::path path_;
  const ReadOptions& options_;
  std::string bytes_;
  AssimpImport result_;
};

// The library's words on one line.
std::string OneLine(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  return text.substr(0, 300);
}

}  // namespace

AssimpImport ImportByAssimp(const std::filesystem::path& path, const ReadOptions& options) {
  Import import(path, options);
  std::string fault = TryInProcess([&] { return import.Run(); }, import.Limits());
  if (fault.empty()) fault = import.Run();
  if (!fault.empty()) throw Error(OneLine(fault), {path.string()});
  return import.Take();
}

}  // namespace snell::io
