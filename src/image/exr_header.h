// SPDX-License-Identifier: Apache-2.0
//
// A look at the headers of an OpenEXR file before the library has one. The library takes memory for
// attributes by the sizes that a file claims, up to 2 GiB for one; here they are held against the file.
#pragma once

#include "image/codec.h"

namespace snell::image {

// Throws unless every attribute lies within the file and has the size that its type demands.
void CheckExrHeaders(const Source& source);

}  // namespace snell::image
