// SPDX-License-Identifier: Apache-2.0
//
// Builds the text of an NFF file, entity by entity.
#pragma once

#include <glm/vec3.hpp>
#include <initializer_list>
#include <span>
#include <string>

namespace snell::spd {

using glm::dvec3;

struct View {
  dvec3 from;
  dvec3 at;
  dvec3 up;
  double hither;
};

// Shares of the arriving light.
struct Fill {
  dvec3 color;
  double diffuse = 0;
  double mirror = 0;  // reflections and highlights
  double highlightDegrees =
      0;  // off the mirrored direction, where a highlight has half its strength
  double transmittance = 0;
  double ior = 1;
};

class NffWriter {
 public:
  // Begins with the view, the background that all databases have, and the lights. A reader that sends a ray
  // through the middle of each of 513 × 513 pixels follows the rays of the published counts.
  // Throws Error unless 1 ≤ size ≤ the database's largest.
  NffWriter(const char* database, int size, const View& view, std::initializer_list<dvec3> lights);

  void SetFill(const Fill& fill);
  void AddSphere(dvec3 center, double radius);
  void AddCone(dvec3 base, double radius, dvec3 top, double topRadius);
  void AddPolygon(std::span<const dvec3> corners);
  void AddPolygon(std::initializer_list<dvec3> corners) {
    AddPolygon(std::span(corners.begin(), corners.size()));
  }
  void AddPatch(std::span<const dvec3> corners, std::span<const dvec3> normals);

  std::string Finish() { return std::move(text_); }

 private:
  void Put(double value);
  void Put(dvec3 value);

  std::string text_;
};

}  // namespace snell::spd
