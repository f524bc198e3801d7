// SPDX-License-Identifier: Apache-2.0
//
// Finer meshes: `subdivision` of objects, creases of inline meshes, and `displacement` of materials.
#include "io/toml/sections.h"

namespace snell::io {

using scene::Displacement;
using scene::EdgeTarget;
using scene::Subdivision;
using scene::SubdivisionBoundary;
using scene::SubdivisionScheme;

static Keys<EdgeTarget> TargetKeys(const char* standard) {
  return {Field("edge_pixels", &EdgeTarget::pixels, Number(Positive, "pixels"),
                "How long edges of the finer mesh may be in the picture.")
              .Standard(standard)
              .Not({"shading_rate", "dicing_rate", "edge_size"}),
          Field("edge_length", &EdgeTarget::length, Number(Positive, "m"),
                "How long they may be on the surface.")
              .Standard("any length")};
}

const SectionOf<Subdivision>& SubdivisionSection() {
  const auto schemes = Choice<SubdivisionScheme>(
      {{"catmull-clark", SubdivisionScheme::CatmullClark}, {"loop", SubdivisionScheme::Loop}});
  const auto boundaries =
      Choice<SubdivisionBoundary>({{"edge-and-corner", SubdivisionBoundary::EdgeAndCorner},
                                   {"edge-only", SubdivisionBoundary::EdgeOnly},
                                   {"none", SubdivisionBoundary::None}});
  static const SectionOf<Subdivision> section =
      SectionOf<Subdivision>(
          "subdivision", "subdivision",
          "Makes a mesh the smooth surface that it is the cage of. Polygons of the file count as "
          "such.",
          Join<Subdivision>(
              {{Field("scheme", &Subdivision::scheme, schemes,
                      "Catmull and Clark's, for quadrilaterals and any polygons, or Loop's, for "
                      "triangles.")
                    .Standard("\"catmull-clark\""),
                Field("levels", &Subdivision::levels, Integer(0, 10),
                      "How often each face is cut in four.")
                    .Not({"level", "iterations", "subdivisions"}),
                Field(
                    "boundary", &Subdivision::boundary, boundaries,
                    "Whether the surface's boundary runs through the mesh's corners, rounds them, "
                    "or the outermost faces are only a frame.")
                    .Not({"interpolate_boundary"})},
               Within(&Subdivision::target, TargetKeys("by `levels`"))}))
          .OnlyOne({{"levels"}, {"edge_pixels"}, {"edge_length"}});
  return section;
}

const SectionOf<CreaseDraft>& CreaseSection() {
  const auto vertices = ListOf(Integer(0, std::numeric_limits<int>::max()), "indices", 1);
  static const SectionOf<CreaseDraft> section = SectionOf<CreaseDraft>(
      "crease", "crease",
      "Edges that stay sharp when the mesh is subdivided; a single vertex is a corner.",
      {Field("vertices", &CreaseDraft::vertices, vertices,
             "Indices of positions: a chain of edges, or one corner.")
           .Required()
           .Example("[0, 1, 2]")
           .Not({"edge", "edges", "vertex"}),
       Field("sharpness", &CreaseDraft::sharpness, Number({0, 10}),
             "For how many levels the edges stay sharp; 10: for ever.")
           .Not({"weight"})});
  return section;
}

static void FinishDisplacement(Reader&, const Fields& fields, Displacement& displacement) {
  if (fields.Find("edge_length")) displacement.target.pixels = 0;
}

const SectionOf<Displacement>& DisplacementSection() {
  static const SectionOf<Displacement> section =
      SectionOf<Displacement>(
          "displacement", "displacement",
          "Moves the surface of meshes along its normal by a texture of heights.",
          Join<Displacement>(
              {{Field("texture", &Displacement::texture, TextureName(),
                      "The heights: the brighter, the higher. Of type `image`, with `data = true`.")
                    .Required()
                    .Not({"map", "file"}),
                Field("channel", &Displacement::channel,
                      Choice<int>({{"red", 0}, {"green", 1}, {"blue", 2}, {"alpha", 3}}),
                      "Of the texture."),
                Field("height", &Displacement::scale, Number(Any, "m"), "From black to white.")
                    .Not({"scale", "strength", "amount"}),
                Field("middle", &Displacement::middle, Number(Any),
                      "The value that stays where it is.")
                    .Not({"midlevel", "offset"})},
               Within(&Displacement::target, TargetKeys("2"))}))
          .OnlyOne({{"edge_pixels"}, {"edge_length"}})
          .Checked(FinishDisplacement);
  return section;
}

}  // namespace snell::io
