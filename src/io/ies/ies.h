// SPDX-License-Identifier: Apache-2.0
//
// Photometric files of lamps: ANSI/IES LM-63 of 1986, 1991, 1995, 2002 and 2019, photometry of types C, B and A.
#pragma once

#include <string>
#include <string_view>

#include "scene/light_profile.h"

namespace snell::io {

// Candela become W/sr at 683 lm/W. Throws Error with `file` and the line as the place.
scene::LightProfile ReadIes(std::string_view bytes, const std::string& file);

}  // namespace snell::io
