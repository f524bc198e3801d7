// SPDX-License-Identifier: Apache-2.0
//
// The analytic shapes of [[object]], one variant each, and what their measures must be to span a surface.
#include <fmt/format.h>

#include <glm/geometric.hpp>

#include "io/toml/sections.h"

namespace snell::io {

using glm::dvec3;
using scene::Box;
using scene::Cone;
using scene::Disk;
using scene::Plane;
using scene::Rectangle;
using scene::Sphere;
using scene::Torus;

// --- Checks -------------------------------------------------------------------------------------------------

// Reports at the first of the keys that is given.
static void Complain(Reader& reader, const Fields& fields, std::initializer_list<const char*> keys,
                     const std::string& message) {
  Place place = fields.place;
  for (const char* key : keys) {
    if (!fields.Find(key)) continue;
    place = fields.PlaceOf(key);
    break;
  }
  reader.Report(fmt::format("{} in {}", message, fields.title), place);
}

static void CheckDisk(Reader& reader, const Fields& fields, ObjectDraft& draft) {
  const auto& disk = std::get<Disk>(draft.object.geometry);
  if (disk.innerRadius >= disk.radius)
    Complain(reader, fields, {"inner_radius"},
             fmt::format("'inner_radius' is not less than 'radius' ({})", disk.radius));
}

static void CheckRectangle(Reader& reader, const Fields& fields, ObjectDraft& draft) {
  const auto& rectangle = std::get<Rectangle>(draft.object.geometry);
  if (HaveNoArea(rectangle.edgeU, rectangle.edgeV))
    Complain(reader, fields, {"edge_v", "edge_u"}, "'edge_u' and 'edge_v' are parallel");
}

static void CheckBox(Reader& reader, const Fields& fields, ObjectDraft& draft) {
  const auto& box = std::get<Box>(draft.object.geometry);
  for (int axis = 0; axis < 3; ++axis) {
    if (box.lower[axis] < box.upper[axis]) continue;
    return Complain(reader, fields, {"max", "min"},
                    fmt::format("'max' is not greater than 'min' along {}", "xyz"[axis]));
  }
}

static void CheckCone(Reader& reader, const Fields& fields, ObjectDraft& draft) {
  const auto& cone = std::get<Cone>(draft.object.geometry);
  if (cone.base == cone.top)
    Complain(reader, fields, {"top", "base"}, "'base' and 'top' are the same point");
  if (cone.radius == 0 && cone.topRadius == 0)
    Complain(reader, fields, {"radius"}, "'radius' and 'top_radius' are both 0");
}

static void CheckCylinder(Reader& reader, const Fields& fields, ObjectDraft& draft) {
  auto& cone = std::get<Cone>(draft.object.geometry);
  cone.topRadius = cone.radius;
  CheckCone(reader, fields, draft);
}

static void CheckTorus(Reader& reader, const Fields& fields, ObjectDraft& draft) {
  const auto& torus = std::get<Torus>(draft.object.geometry);
  if (torus.minorRadius > torus.majorRadius)
    Complain(reader, fields, {"minor_radius", "major_radius"},
             fmt::format("'minor_radius' ({}) is greater than 'major_radius' ({})",
                         torus.minorRadius, torus.majorRadius));
}

static void CheckTriangleShape(Reader& reader, const Fields& fields, ObjectDraft& draft) {
  const std::size_t before = reader.findings();
  CheckTriangle(reader, fields, draft.mesh);
  if (reader.findings() == before) draft.meshes = reader.meshes.Add(BuildMesh(draft.mesh));
}

// --- Keys that several shapes share -------------------------------------------------------------------------

template <class Shape>
static KeyOf<Shape> CenterKey() {
  return Field("center", &Shape::center, Point(), "The centre.")
      .Not({"position", "centre", "pos", "origin"});
}

template <class Shape>
static KeyOf<Shape> NormalKey() {
  return Field("normal", &Shape::normal, Direction(), "Straight out of the surface.")
      .Not({"axis", "up", "direction"});
}

template <class Shape>
static KeyOf<Shape> RadiusKey() {
  return Field("radius", &Shape::radius, Number(Positive, "m"), "The radius.")
      .Not({"r", "size", "diameter", "outer_radius"});
}

// Both ends of cylinder and cone, and what closes them.
static Keys<Cone> EndKeys() {
  return {Field("base", &Cone::base, Point(), "Centre of the lower end.")
              .Not({"bottom", "center", "from", "start"}),
          Field("top", &Cone::top, Point(), "Centre of the upper end.")
              .Not({"to", "apex", "end", "height", "length"}),
          Field("capped", &Cone::capped, Boolean(), "Whether disks close the ends.")
              .Not({"caps", "closed"})};
}

// --- The shapes ---------------------------------------------------------------------------------------------

// The variant of an object whose geometry is a Shape.
template <class Shape>
static VariantOf<ObjectDraft> ShapeOf(const char* name, const char* text, const Keys<Shape>& keys) {
  const auto at = [](ObjectDraft& draft) -> Shape& {
    return std::get<Shape>(draft.object.geometry);
  };
  return VariantOf<ObjectDraft>(name, text, Within<ObjectDraft, Shape>(at, keys))
      .Begin([](ObjectDraft& draft) { draft.object.geometry = Shape(); });
}

static VariantOf<ObjectDraft> PlaneShape() {
  const auto point = Field("point", &Plane::point, Point(), "A point of the plane.")
                         .Not({"center", "position", "origin"});
  return ShapeOf<Plane>("plane", "An infinite plane.", {point, NormalKey<Plane>()});
}

static VariantOf<ObjectDraft> DiskShape() {
  const auto hole = Field("inner_radius", &Disk::innerRadius, Number(NotNegative, "m"),
                          "Radius of the hole in the middle.")
                        .Example("0.5")
                        .Not({"hole"});
  return ShapeOf<Disk>("disk", "A flat disk, or a ring with a hole.",
                       {CenterKey<Disk>(), NormalKey<Disk>(), RadiusKey<Disk>(), hole})
      .Checked(CheckDisk);
}

static VariantOf<ObjectDraft> RectangleShape() {
  return ShapeOf<Rectangle>(
             "rectangle", "A flat parallelogram; its normal is `edge_u` × `edge_v`.",
             {Field("corner", &Rectangle::corner, Point(), "One corner.")
                  .Not({"center", "position", "origin"}),
              Field("edge_u", &Rectangle::edgeU, NotZero("m"), "From the corner to the next.")
                  .Not({"u"}),
              Field("edge_v", &Rectangle::edgeV, NotZero("m"), "From the corner to the other next.")
                  .Not({"v"})})
      .Checked(CheckRectangle);
}

static VariantOf<ObjectDraft> TriangleShape() {
  return VariantOf<ObjectDraft>("triangle", "A single triangle.",
                                Within(&ObjectDraft::mesh, TriangleKeys()))
      .Checked(CheckTriangleShape);
}

static VariantOf<ObjectDraft> BoxShape() {
  return ShapeOf<Box>(
             "box", "A block along the axes.",
             {Field("min", &Box::lower, Point(), "The corner with the least coordinates.")
                  .Example("[-2, -1, -3]")
                  .Not({"lower", "from", "corner", "center", "size"}),
              Field("max", &Box::upper, Point(), "The corner with the greatest coordinates.")
                  .Not({"upper", "to"})})
      .Checked(CheckBox);
}

static VariantOf<ObjectDraft> ConeShape() {
  const Keys<Cone> radii = {
      Field("radius", &Cone::radius, Number(NotNegative, "m"), "Radius of the lower end.")
          .Not({"r", "base_radius", "bottom_radius"}),
      Field("top_radius", &Cone::topRadius, Number(NotNegative, "m"), "Radius of the upper end.")};
  return ShapeOf<Cone>("cone", "A cone, or a frustum if neither radius is 0.",
                       Join<Cone>({EndKeys(), radii}))
      .Checked(CheckCone);
}

static VariantOf<ObjectDraft> TorusShape() {
  const auto axis =
      Field("axis", &Torus::axis, Direction(), "Straight through the hole.").Not({"normal"});
  const auto major = Field("major_radius", &Torus::majorRadius, Number(Positive, "m"),
                           "From the centre to the middle of the tube.")
                         .Not({"radius"});
  const auto minor =
      Field("minor_radius", &Torus::minorRadius, Number(Positive, "m"), "Radius of the tube.")
          .Not({"tube_radius", "thickness"})
          .Example("0.125");
  return ShapeOf<Torus>("torus", "A ring.", {CenterKey<Torus>(), axis, major, minor})
      .Checked(CheckTorus);
}

std::vector<VariantOf<ObjectDraft>> ShapeVariants() {
  return {ShapeOf<Sphere>("sphere", "A ball.", {CenterKey<Sphere>(), RadiusKey<Sphere>()}),
          PlaneShape(),
          TriangleShape(),
          RectangleShape(),
          DiskShape(),
          BoxShape(),
          ShapeOf<Cone>("cylinder", "A round tube between two points.",
                        Join<Cone>({EndKeys(), {RadiusKey<Cone>()}}))
              .Checked(CheckCylinder),
          ConeShape(),
          TorusShape()};
}

}  // namespace snell::io
