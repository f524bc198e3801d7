// SPDX-License-Identifier: Apache-2.0
//
// Numbers that a texture may vary: a number, the name of a texture, whose red channel counts, or a table that says which
// channel and a factor.
#include "io/toml/sections.h"

namespace snell::io {

using scene::ScalarInput;

const SectionOf<ScalarInput>& ChannelSection() {
  static const SectionOf<ScalarInput> section(
      "channel", "channel of a texture",
      "A texture's channel with a factor; stands where a material takes a number.",
      {Field("texture", &ScalarInput::texture, TextureName(), "The texture.")
           .Required()
           .Not({"name", "type"}),
       Field("channel", &ScalarInput::channel,
             Choice<int>({{"red", 0}, {"green", 1}, {"blue", 2}, {"alpha", 3}}), "Its channel."),
       Field("factor", &ScalarInput::value, Number(NotNegative), "The factor.")
           .Standard("`1`")
           .Not({"scale", "value"})});
  return section;
}

Type<ScalarInput> NumberOrTexture(Range range, const std::string& unit) {
  Type<ScalarInput> type;
  const Type<float> number = Number(range, unit);
  type.expected = number.expected + " or a texture";
  type.unit = unit;
  type.schema = R"({"anyOf": [)" + number.schema +
                R"(, {"type": "string"}, {"$ref": "#/definitions/channel"}]})";
  type.example = "{ texture = \"marble\", channel = \"green\" }";
  type.read = [number](Reader& reader, const Node& value, ScalarInput& input) {
    ScalarInput result{1};
    if (value.String()) {
      if (!ReadTexture(reader, value, result.texture)) return false;
    } else if (value.IsTable()) {
      if (!ReadTable(reader, ChannelSection(), Fields("channel of a texture", value), result))
        return false;
    } else if (!number.read(reader, value, result.value)) {
      return false;
    }
    input = result;
    return true;
  };
  type.write = [number](const ScalarInput& input) {
    return input.texture < 0 ? number.write(input.value) : std::string();
  };
  return type;
}

}  // namespace snell::io
