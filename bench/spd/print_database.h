// SPDX-License-Identifier: Apache-2.0
//
// For tests with a database as their parameter: lists of tests show its name.
#pragma once

#include <ostream>

#include "spd/generators.h"

namespace snell::spd {

inline void PrintTo(const Database& database, std::ostream* out) { *out << database.name; }

}  // namespace snell::spd
