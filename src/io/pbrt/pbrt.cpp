// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/pbrt.h"

#include <new>
#include <stdexcept>
#include <utility>

#include "io/pbrt/reader.h"

namespace snell::io {

scene::Scene ReadPbrt(const std::filesystem::path& path, const ReadOptions& options,
                      const WarningSink& warn) {
  try {
    const std::string text = ReadWithin(path, options.limits);
    PbrtContext context(path, options, warn);
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
