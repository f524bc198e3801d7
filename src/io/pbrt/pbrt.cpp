// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/pbrt.h"

#include <new>
#include <stdexcept>
#include <utility>

#include "io/pbrt/reader.h"
#include "util/file.h"

namespace snell::io {

static constexpr std::uint64_t MaxFileBytes = 2'000'000'000;  // lines and columns fit an int

scene::Scene ReadPbrt(const std::filesystem::path& path, const WarningSink& warn) {
  try {
    const std::string text = ReadFile(path, MaxFileBytes);
    PbrtContext context(path, warn);
    PbrtReader(context).Read(text);
    context.findings.Report(warn);
    return std::move(context.scene);
  } catch (const std::bad_alloc&) {
    throw Error("not enough memory for the scene", {path.string()});
  } catch (const std::length_error&) {
    throw Error("not enough memory for the scene", {path.string()});
  }
}

}  // namespace snell::io
