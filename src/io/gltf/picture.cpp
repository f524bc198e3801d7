// SPDX-License-Identifier: Apache-2.0
//
// Pictures of a glTF document: from its folder, a data URI or a buffer view to bytes.
#include "io/gltf/textures.h"
#include "io/gltf/uri.h"
#include "io/images.h"
#include "util/file.h"

namespace snell::io {

GltfPicture ReadGltfPicture(const GltfDocument& document, std::string_view viewBytes, int index) {
  const GltfImage& source = document.images[std::size_t(index)];
  GltfPicture picture;
  try {
    std::string loaded;
    if (!source.uri.empty()) {
      loaded = ReadGltfUri(document.folders, source.uri, document.limits);
      viewBytes = loaded;
    }
    // The numbers in the file are kept: the use of the texture says what they mean, not the file
    picture.texels =
        DecodeTexels(viewBytes, document.path.string(), ImageUse::Data, document.limits);
  } catch (const Error& error) {
    const Diagnostic& cause = error.diagnostics().front();
    picture.fault = cause.message;
    // Of other hints there would be too many words
    if (cause.hint.find("--") != std::string::npos) picture.fault += "; " + cause.hint;
  }
  return picture;
}

}  // namespace snell::io
