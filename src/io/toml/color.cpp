// SPDX-License-Identifier: Apache-2.0
//
// The ways to write a colour (toml_types.h). Linear Rec.709 in the record; "#rrggbb" is decoded by the
// transfer function of IEC 61966-2-1.
#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "io/toml/sections.h"
#include "io/toml/types.h"

namespace snell::io {

static const char* const ColorForms = "colours are [r, g, b], one number or \"#rrggbb\"";

static Range RangeOf(Brightness brightness) {
  return brightness == Brightness::Reflectance ? Range{0, 1} : NotNegative;
}

static double DecodeSrgb(int byte) {
  const double encoded = byte / 255.0;
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

// "#rrggbb" or "#rgb".
static std::optional<Spectrum> ParseHex(std::string_view text) {
  const bool isShort = text.size() == 4;
  if (!isShort && text.size() != 7) return std::nullopt;
  double channels[3];
  for (std::size_t i = 0; i < 3; ++i) {
    int byte = 0;
    for (std::size_t digit = 0; digit < 2; ++digit) {
      const char c = text[isShort ? 1 + i : 1 + 2 * i + digit];
      const std::size_t value =
          std::string_view("0123456789abcdef").find(char(c | ('A' <= c && c <= 'F' ? 32 : 0)));
      if (value == std::string_view::npos) return std::nullopt;
      byte = 16 * byte + int(value);
    }
    channels[i] = DecodeSrgb(byte);
  }
  return Spectrum(float(channels[0]), float(channels[1]), float(channels[2]));
}

// A colour that is no texture.
static bool ReadColor(Reader& reader, const Node& value, Range range, const std::string& expected,
                      Spectrum& color) {
  if (value.Number()) {
    double grey = 0;
    if (!ReadNumber(reader, value, range, "a number" + range.Words(), grey)) return false;
    color = Spectrum(float(grey));
    return true;
  }
  if (const auto text = value.String()) {
    const auto parsed = text->starts_with('#') ? ParseHex(*text) : std::nullopt;
    if (parsed) color = *parsed;
    if (!parsed)
      reader.Report(fmt::format("'{}': {} is no colour", reader.key, QuotedName(*text)),
                    value.place(), ColorForms);
    return parsed.has_value();
  }
  if (!value.IsArray()) return reader.Refuse(value, expected, ColorForms);
  double c[3];
  if (!ReadNumbers(reader, value, range, "3 numbers", c, 3)) return false;
  color = Spectrum(float(c[0]), float(c[1]), float(c[2]));
  return true;
}

static std::string WriteColor(const Spectrum& color) {
  if (color.x == color.y && color.y == color.z) return ToToml(color.x);
  return fmt::format("[{}, {}, {}]", ToToml(color.x), ToToml(color.y), ToToml(color.z));
}

Type<Spectrum> Color(Brightness brightness) {
  const bool reflectance = brightness == Brightness::Reflectance;
  Type<Spectrum> type;
  type.expected = reflectance ? "a colour from 0 to 1" : "a colour";
  type.schema = reflectance ? R"({"$ref": "#/definitions/reflectance"})"
                            : R"({"$ref": "#/definitions/color"})";
  type.example = "[0.25, 0.5, 0.75]";
  type.read = [brightness, expected = type.expected](Reader& reader, const Node& value,
                                                     Spectrum& color) {
    return ReadColor(reader, value, RangeOf(brightness), expected, color);
  };
  type.write = WriteColor;
  return type;
}

Type<ColorInput> ColorOrTexture(Brightness brightness) {
  const bool reflectance = brightness == Brightness::Reflectance;
  Type<ColorInput> type;
  type.expected = reflectance ? "a colour from 0 to 1 or a texture" : "a colour or a texture";
  type.schema = reflectance ? R"({"$ref": "#/definitions/reflectanceOrTexture"})"
                            : R"({"$ref": "#/definitions/colorOrTexture"})";
  type.example = "{ texture = \"marble\", tint = \"#c08040\" }";
  type.read = [brightness, expected = type.expected](Reader& reader, const Node& value,
                                                     ColorInput& input) {
    ColorInput result{Spectrum(1.0f)};
    const auto text = value.String();
    if (text && !text->starts_with('#')) {
      if (!ReadTexture(reader, value, result.texture)) return false;
    } else if (value.IsTable()) {
      if (!ReadTintedTexture(reader, value, brightness, result)) return false;
    } else if (!ReadColor(reader, value, RangeOf(brightness), expected, result.value)) {
      return false;
    }
    input = result;
    return true;
  };
  type.write = [](const ColorInput& input) {
    return input.texture < 0 ? WriteColor(input.value) : std::string();
  };
  return type;
}

}  // namespace snell::io
