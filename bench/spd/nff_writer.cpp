// SPDX-License-Identifier: Apache-2.0
#include "spd/nff_writer.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "spd/generators.h"
#include "util/error.h"

namespace snell::spd {

static constexpr double Degree = 3.14159265358979323846 / 180;

// The counts hold for rays through the 513 × 513 corners of 512 × 512 pixels, in a view whose 45° reach from
// the middle of the first row of these pixels to that of the last. For rays through the middles of 513 rows,
// that is half a pixel more on both sides.
static double CornerAngle() { return 2 * std::atan(std::tan(22.5 * Degree) * 512 / 511) / Degree; }

NffWriter::NffWriter(const char* database, int size, const View& view,
                     std::initializer_list<dvec3> lights) {
  const int largest = DatabaseNamed(database).largestSize;
  if (size < 1 || size > largest)
    throw Error(
        fmt::format("the size of {} must lie between 1 and {}, not {}", database, largest, size));

  text_ = fmt::format("# {} of the Standard Procedural Databases, size {}\n", database, size);
  text_ += "v\nfrom";
  Put(view.from);
  text_ += "\nat";
  Put(view.at);
  text_ += "\nup";
  Put(view.up);
  text_ += "\nangle";
  Put(CornerAngle());
  text_ += "\nhither";
  Put(view.hither);
  text_ += "\nresolution 513 513\nb 0.078 0.361 0.753\n";
  for (const dvec3& light : lights) {
    text_ += "l";
    Put(light);
    text_ += '\n';
  }
}

void NffWriter::SetFill(const Fill& fill) {
  // cosⁿ of the angle is one half
  const double shine = fill.highlightDegrees > 0
                           ? std::log(0.5) / std::log(std::cos(fill.highlightDegrees * Degree))
                           : 0;
  text_ += "f";
  Put(fill.color);
  for (const double value : {fill.diffuse, fill.mirror, shine, fill.transmittance, fill.ior})
    Put(value);
  text_ += '\n';
}

void NffWriter::AddSphere(dvec3 center, double radius) {
  text_ += "s";
  Put(center);
  Put(radius);
  text_ += '\n';
}

void NffWriter::AddCone(dvec3 base, double radius, dvec3 top, double topRadius) {
  text_ += "c";
  Put(base);
  Put(radius);
  Put(top);
  Put(topRadius);
  text_ += '\n';
}

void NffWriter::AddPolygon(std::span<const dvec3> corners) {
  fmt::format_to(std::back_inserter(text_), "p {}\n", corners.size());
  for (const dvec3& corner : corners) {
    Put(corner);
    text_ += '\n';
  }
}

void NffWriter::AddPatch(std::span<const dvec3> corners, std::span<const dvec3> normals) {
  fmt::format_to(std::back_inserter(text_), "pp {}\n", corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    Put(corners[i]);
    Put(normals[i]);
    text_ += '\n';
  }
}

// The shortest text that reads as the same float; what is smaller than the generators' rounding errors is
// zero.
void NffWriter::Put(double value) {
  const char* separator = text_.ends_with('\n') ? "" : " ";
  const float rounded = std::abs(value) < 1e-14 ? 0.0f : float(value);
  fmt::format_to(std::back_inserter(text_), "{}{}", separator, rounded);
}

void NffWriter::Put(dvec3 value) {
  Put(value.x);
  Put(value.y);
  Put(value.z);
}

}  // namespace snell::spd
