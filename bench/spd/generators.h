// SPDX-License-Identifier: Apache-2.0
//
// The Standard Procedural Databases of Haines 1987 ("A proposal for standard graphics environments", IEEE
// CG&A 7(11)): seven scenes that programs make in any size, published with the numbers of rays that a
// classic ray tracer follows in them. Written anew from the published descriptions; geometry, colours, views
// and lights are those of release 3.14, so that the counts hold. Each function returns the text of an NFF
// file and throws Error for a size out of range. Lengths have no unit.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace snell::spd {

std::string Balls(int size);  // spheres with nine smaller ones on each, `size` levels deep
std::string Gears(int size);  // size³ meshed gears, some of glass
std::string Mount(int size);  // a fractal mountain of 2·4^size triangles, four balls of glass
std::string Rings(int size);  // a pyramid of `size` layers of dodecahedra made of rings
std::string Teapot(
    int size);  // Newell's teapot, size² quadrilaterals a patch, on a chequered floor
std::string Tetra(int size);  // Sierpinski's tetrahedron of 4^size triangles
std::string Tree(int size);   // a tree that forks `size` times

// What the release's documentation says of a database at its usual size.
struct Published {
  int primitives;  // polygons, patches, spheres, cones
  int lights;
  std::int64_t eyeHitRays;  // of 513 × 513, one through each pixel corner
  std::int64_t reflectedRays;
  std::int64_t refractedRays;
  std::int64_t shadowRays;
};

struct Database {
  std::string_view name;
  std::string (*generate)(int size);
  int usualSize;
  int largestSize;  // a few million primitives
  std::string_view contents;
  Published published;
};

// All seven, by name.
const std::vector<Database>& Databases();

// Throws Error, with a hint, if there is no database of this name.
const Database& DatabaseNamed(std::string_view name);

}  // namespace snell::spd
