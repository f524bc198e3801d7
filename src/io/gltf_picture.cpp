// SPDX-License-Identifier: Apache-2.0
//
// Pictures of a glTF document: from its folder, a data URI or a buffer view to bytes.
#include <cmath>

#include "image/read.h"
#include "io/gltf_textures.h"
#include "io/gltf_uri.h"
#include "util/file.h"

namespace snell::io {

static std::uint8_t Byte(float value) {
  return std::uint8_t(std::lround(std::fmin(std::fmax(value, 0.0f), 1.0f) * 255));
}

GltfPicture ReadGltfPicture(const GltfDocument& document, std::string_view viewBytes, int index) {
  const GltfImage& source = document.images[std::size_t(index)];
  GltfPicture picture;
  try {
    std::string loaded;
    if (!source.uri.empty()) {
      loaded = ReadGltfUri(document.Folder(), source.uri, DefaultFileLimit);
      viewBytes = loaded;
    }
    // The numbers in the file are kept: the use of the texture says what they mean, not the file
    const image::ReadOptions options{.colorSpace = image::ColorSpace::Raw};
    const image::Image decoded = image::DecodeImage(viewBytes, document.path.string(), options);
    picture.width = decoded.width;
    picture.height = decoded.height;
    picture.bytes.reserve(decoded.pixels.size() * 4);
    for (std::size_t i = 0; i < decoded.pixels.size(); ++i) {
      for (int k = 0; k < 3; ++k) picture.bytes.push_back(Byte(decoded.pixels[i][k]));
      picture.bytes.push_back(decoded.HasAlpha() ? Byte(decoded.alpha[i]) : 255);
    }
  } catch (const Error& error) {
    picture.fault = error.diagnostics().front().message;
  }
  return picture;
}

}  // namespace snell::io
