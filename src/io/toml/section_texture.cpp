// SPDX-License-Identifier: Apache-2.0
//
// [texture.NAME]: procedural patterns, their looks without any key, and how colours refer to them.
#include <fmt/format.h>

#include <glm/matrix.hpp>

#include "io/images.h"
#include "io/toml/sections.h"
#include "util/file.h"

namespace snell::io {

using scene::TextureKind;
using scene::TextureSpace;

// --- Looks --------------------------------------------------------------------------------------------------

static void BeginChecker(TextureDraft& draft) { draft.texture.kind = TextureKind::Checker; }

static void BeginStripes(TextureDraft& draft) { draft.texture.kind = TextureKind::Stripes; }

static void BeginGradient(TextureDraft& draft) { draft.texture.kind = TextureKind::Gradient; }

static void BeginMarble(TextureDraft& draft) {
  draft.texture.kind = TextureKind::Marble;
  draft.texture.space = TextureSpace::Object;
  draft.texture.colorA = Spectrum(0.8f, 0.78f, 0.74f);
  draft.texture.colorB = Spectrum(0.12f, 0.13f, 0.16f);
  draft.texture.turbulence = 1.5f;
  draft.texture.octaves = 6;
}

static void BeginWood(TextureDraft& draft) {
  draft.texture.kind = TextureKind::Wood;
  draft.texture.space = TextureSpace::Object;
  draft.texture.colorA = Spectrum(0.52f, 0.3f, 0.13f);
  draft.texture.colorB = Spectrum(0.26f, 0.12f, 0.045f);
  draft.texture.turbulence = 0.4f;
  draft.texture.octaves = 4;
  draft.placement.scale = Affine(0.12);
  draft.placement.scale[3][3] = 1;
}

static void BeginImage(TextureDraft& draft) {
  draft.texture.kind = TextureKind::Image;
  draft.texture.colorA = draft.texture.colorB = Spectrum(1.0f);
}

// --- The section --------------------------------------------------------------------------------------------

static void FinishTexture(Reader& reader, const Fields& fields, TextureDraft& draft) {
  // A list of steps stands in place of a kind's own placement too
  const bool hasSteps = fields.Find("transform");
  draft.texture.placement = hasSteps ? draft.placement.steps : draft.placement.Matrix();
  std::string reason;
  if (!IsUsable(draft.texture.placement, reason))
    reader.Report(fmt::format("the transform of {} cannot be used: {}", fields.title, reason),
                  fields.place);
}

static void LoadPicture(Reader& reader, const Fields& fields, TextureDraft& draft) {
  if (draft.file.empty()) return;
  const Place place = fields.PlaceOf("file");
  try {
    const ImageUse use = draft.data ? ImageUse::Data : ImageUse::Color;
    reader.scene.images.push_back(DecodeTexels(ReadWithin(draft.file, reader.limits),
                                               draft.file.string(), use, reader.limits));
    draft.texture.image = int(reader.scene.images.size()) - 1;
  } catch (const Error& error) {
    for (const Diagnostic& cause : error.diagnostics())
      reader.Report(
          fmt::format("cannot use the picture {}: {}", ToString(cause.place), cause.message), place,
          cause.hint);
  }
}

static Keys<TextureDraft> PictureKeys() {
  using scene::Texture;
  using scene::TextureFilter;
  using scene::Wrap;
  const auto wraps =
      Choice<Wrap>({{"repeat", Wrap::Repeat}, {"clamp", Wrap::Clamp}, {"mirror", Wrap::Mirror}});
  const auto filters = Choice<TextureFilter>({{"nearest", TextureFilter::Nearest},
                                              {"linear", TextureFilter::Linear},
                                              {"mipmap", TextureFilter::Mipmap}});
  return Join<TextureDraft>(
      {{Field("file", &TextureDraft::file, SceneFile("bricks.png"),
              "The picture: PNG, JPEG, WebP, OpenEXR or Radiance HDR, in the scene's folder.")
            .Required()
            .Not({"path", "filename", "image"}),
        Field("data", &TextureDraft::data, Boolean(),
              "The numbers are measures, as in maps of normals and heights, and no colours.")
            .Not({"raw", "linear"})},
       Within(&TextureDraft::texture,
              {Field("wrap_u", &Texture::wrapU, wraps, "How it goes on to left and right.")
                   .Not({"wrap", "wrap_s"}),
               Field("wrap_v", &Texture::wrapV, wraps, "How it goes on above and below."),
               Field("filter", &Texture::filter, filters,
                     "Between its texels: `mipmap` also averages those that fall into one pixel.")
                   .Not({"interpolation"})})});
}

static Keys<scene::Texture> CommonKeys() {
  const auto spaces = Choice<TextureSpace>(
      {{"uv", TextureSpace::Uv}, {"object", TextureSpace::Object}, {"world", TextureSpace::World}});
  return {Field("space", &scene::Texture::space, spaces,
                "What the pattern sticks to: the surface's own coordinates, the object's (it moves "
                "with the object), or the world's.")
              .Not({"mapping", "coordinates"})};
}

static Keys<TextureDraft> PatternKeys(const Keys<scene::Texture>& more) {
  using scene::Texture;
  Keys<Texture> keys = {
      Field("color_a", &Texture::colorA, Color(Brightness::Reflectance), "The ground colour.")
          .Not({"color", "color1", "color_1", "a"}),
      Field("color_b", &Texture::colorB, Color(Brightness::Reflectance), "The other colour.")
          .Not({"color2", "color_2", "b"})};
  keys.insert(keys.end(), more.begin(), more.end());
  return Within(&TextureDraft::texture, keys);
}

static KeyOf<scene::Texture> SmoothKey() {
  return Field("smooth", &scene::Texture::smooth, Boolean(),
               "Soft transitions in place of sharp ones.");
}

static Keys<TextureDraft> NoiseKeys() {
  using scene::Texture;
  return PatternKeys(
      {Field("turbulence", &Texture::turbulence, Number(NotNegative),
             "How far noise moves the pattern, in periods.")
           .Not({"noise", "distortion"}),
       Field("octaves", &Texture::octaves, Integer(1, 16), "How many layers of ever finer noise.")
           .Not({"layers", "detail"}),
       SmoothKey()});
}

const SectionOf<TextureDraft>& TextureSection() {
  using Kind = VariantOf<TextureDraft>;
  static const SectionOf<TextureDraft> section =
      SectionOf<TextureDraft>(
          "texture", "[texture.NAME]",
          "A pattern of two colours, placed so that one unit is one period, or a picture. Its name "
          "can stand "
          "where a material takes a colour. Each type is also ready for use under its own name: "
          "`diffuse = \"marble\"`. In `uv`, planes are measured in metres, triangles by their own "
          "coordinates, and all other shapes from 0 to 1: for a ball with many squares, scale the "
          "pattern down or use `space = \"object\"`.",
          Join<TextureDraft>({Within(&TextureDraft::texture, CommonKeys()),
                              Within(&TextureDraft::placement, PlacementKeys())}))
          .Variants(
              "type",
              {Kind("checker", "Cubes (squares on a surface) of side 1, in turns.", PatternKeys({}))
                   .Begin(BeginChecker),
               Kind("stripes", "Stripes across x; one of each colour in a unit.",
                    PatternKeys({SmoothKey()}))
                   .Begin(BeginStripes),
               Kind("gradient", "From `color_a` at y = 0 to `color_b` at y = 1.", PatternKeys({}))
                   .Begin(BeginGradient),
               Kind("marble", "Veins across x, moved about by noise.", NoiseKeys())
                   .Begin(BeginMarble),
               Kind("wood", "Year rings around the y axis, one in a unit.", NoiseKeys())
                   .Begin(BeginWood),
               Kind("image", "A picture from a file, upright in the unit square.", PictureKeys())
                   .Begin(BeginImage)
                   .Checked(LoadPicture)})
          .OnlyOne(PlacementSides)
          .Checked(FinishTexture);
  return section;
}

// --- References ---------------------------------------------------------------------------------------------

bool ReadTexture(Reader& reader, const Node& name, scene::TextureIndex& texture) {
  const auto text = name.String();
  if (!text) return reader.Refuse(name, "the name of a texture");
  if (const auto found = reader.textures.find(*text); found != reader.textures.end()) {
    texture = found->second;
    return true;
  }

  // A kind's own name is the texture of that kind, unless the files define another
  for (const Variant& variant : TextureSection().variants) {
    if (variant.name != *text || variant.name == "image") continue;
    TextureDraft draft;
    variant.begin(&draft);
    draft.texture.name = variant.name;
    draft.texture.placement = draft.placement.Matrix();
    texture = int(reader.scene.textures.size());
    reader.scene.textures.push_back(draft.texture);
    reader.textures.emplace(variant.name, texture);
    return true;
  }

  if (!reader.filesMissing) {
    std::vector<std::string> known = NamesOf(reader.textures);
    for (const Variant& variant : TextureSection().variants) known.push_back(variant.name);
    const std::string suggestion = Suggestion(*text, known);
    reader.Report(fmt::format("unknown texture {}", QuotedName(*text)), name.place(),
                  suggestion.empty()
                      ? "colours are [r, g, b], one number, \"#rrggbb\" or a texture's name"
                      : suggestion);
  }
  return false;
}

Type<scene::TextureIndex> TextureName() {
  Type<scene::TextureIndex> type;
  type.expected = "the name of a texture";
  type.schema = R"({"type": "string"})";
  type.example = "\"wood\"";
  type.read = ReadTexture;
  return type;
}

const SectionOf<Tint>& TintSection() {
  static const SectionOf<Tint> section(
      "tint", "tinted texture",
      "A texture with a colour that multiplies it; stands where a material takes a colour.",
      {Field("texture", &Tint::texture, TextureName(), "The texture.")
           .Required()
           .Not({"name", "type"}),
       Field("tint", &Tint::color, Color(Brightness::Unlimited),
             "The factor; at most 1 where the colour is a reflectance, of any strength for "
             "`emission`.")
           .Not({"color", "factor"})});
  return section;
}

bool ReadTintedTexture(Reader& reader, const Node& table, Brightness brightness,
                       ColorInput& input) {
  Tint tint;
  const Fields fields("tinted texture", table);
  if (!ReadTable(reader, TintSection(), fields, tint)) return false;
  if (const Node::Entry* entry = fields.Find("tint");
      entry && brightness == Brightness::Reflectance) {
    const KeyScope scope(reader, "tint");
    if (!Color(brightness).read(reader, entry->value, tint.color)) return false;
  }
  input = {tint.color, tint.texture};
  return true;
}

}  // namespace snell::io
