// SPDX-License-Identifier: Apache-2.0
//
// snell info: what is in a scene and what it takes.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "api/snell.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/load_options.h"
#include "cli/values.h"
#include "util/file.h"
#include "util/json.h"
#include "util/text.h"

namespace snell::cli {

namespace {

constexpr const char* Details =
    "Lists cameras, lights, materials, textures, meshes and objects, with the bounds of the "
    "scene and the memory that a render of it takes. Of an EXR picture it lists the layers.";

constexpr std::size_t ShownItems = 20;  // of each list, for people

struct InfoArguments {
  std::string scene;
  LoadArguments load;
  bool json = false;
};

std::string ItemText(const SceneInfo::Item& item) {
  std::string text = "             ";
  if (!item.name.empty()) text += item.name + ": ";
  text += item.kind;
  if (!item.detail.empty()) text += ", " + item.detail;
  return text + "\n";
}

// A heading with the number of things, and the things.
std::string ListText(const std::string& heading, const std::vector<SceneInfo::Item>& items) {
  std::string text = fmt::format("  {:<9}  {}\n", heading, items.size());
  const std::size_t shown = items.size() > ShownItems + 1 ? ShownItems : items.size();
  for (std::size_t i = 0; i < shown; ++i) text += ItemText(items[i]);
  if (shown < items.size())
    text += fmt::format("             and {} more\n", WithCommas(items.size() - shown));
  return items.empty() ? "" : text;
}

std::string ObjectsText(const SceneInfo& info) {
  std::vector<std::string> kinds;
  for (const auto& [kind, count] : info.objectsByKind)
    kinds.push_back(fmt::format("{} {}", kind, WithCommas(count)));
  std::string text = fmt::format("  objects    {}", WithCommas(info.objects));
  if (!kinds.empty()) text += fmt::format(": {}", fmt::join(kinds, ", "));
  text += "\n";
  if (info.instancedTriangles > 0) {
    text += fmt::format("  triangles  {} stored, {} seen", WithCommas(info.meshTriangles),
                        WithCommas(info.instancedTriangles));
    if (info.finerTriangles > 0)
      text += fmt::format("; {} in finer meshes", WithCommas(info.finerTriangles));
    text += "\n";
  }
  return text;
}

std::string BoundsText(const SceneInfo& info) {
  if (!info.bounded) return "  bounds     none\n";
  const auto& a = info.lower;
  const auto& b = info.upper;
  return fmt::format(
      "  bounds     {:.6g} {:.6g} {:.6g} to {:.6g} {:.6g} {:.6g}, {:.6g} × {:.6g} × {:.6g} m\n",
      a[0], a[1], a[2], b[0], b[1], b[2], b[0] - a[0], b[1] - a[1], b[2] - a[2]);
}

std::string InfoText(const SceneInfo& info) {
  std::string text = info.name + "\n";
  text += fmt::format("  picture    {} × {}, {} per pixel, {}\n", info.width, info.height,
                      Plural(std::uint64_t(info.spp), "sample"), info.integrator);
  text += ListText("cameras", info.cameras);
  if (info.cameras.empty()) text += "  cameras    none; everything is framed\n";
  text += ListText("lights", info.lights);
  text += ListText("materials", info.materials);
  text += ListText("textures", info.textures);
  text += ListText("meshes", info.meshes);
  text += ObjectsText(info) + BoundsText(info);
  return text + fmt::format("  memory     scene {}, textures {}, BVH {}; built in {}\n",
                            ByteSize(info.sceneBytes), ByteSize(info.textureBytes),
                            ByteSize(info.bvhBytes), Duration(info.buildSeconds));
}

void AddItems(JsonWriter& json, const char* name, const std::vector<SceneInfo::Item>& items) {
  json.BeginArray(name);
  for (const SceneInfo::Item& item : items) {
    json.BeginObject("");
    json.Add("name", item.name);
    json.Add("kind", item.kind);
    json.Add("detail", item.detail);
    json.End();
  }
  json.End();
}

void AddPoint(JsonWriter& json, const char* name, const std::array<double, 3>& point) {
  json.BeginArray(name);
  for (const double coordinate : point) json.Add("", coordinate);
  json.End();
}

std::string InfoJson(const SceneInfo& info) {
  JsonWriter json;
  json.Add("scene", info.name);
  json.Add("width", info.width);
  json.Add("height", info.height);
  json.Add("samples_per_pixel", info.spp);
  json.Add("integrator", info.integrator);
  AddItems(json, "cameras", info.cameras);
  AddItems(json, "lights", info.lights);
  AddItems(json, "materials", info.materials);
  AddItems(json, "textures", info.textures);
  AddItems(json, "meshes", info.meshes);
  json.Add("objects", info.objects);
  json.BeginObject("objects_by_kind");
  for (const auto& [kind, count] : info.objectsByKind) json.Add(kind, count);
  json.End();
  json.Add("triangles_stored", info.meshTriangles);
  json.Add("triangles_seen", info.instancedTriangles);
  json.Add("triangles_finer", info.finerTriangles);
  if (info.bounded) {
    json.BeginObject("bounds");
    AddPoint(json, "lower", info.lower);
    AddPoint(json, "upper", info.upper);
    json.End();
  }
  json.BeginObject("bytes");
  json.Add("scene", info.sceneBytes);
  json.Add("textures", info.textureBytes);
  json.Add("bvh", info.bvhBytes);
  json.End();
  json.Add("build_seconds", info.buildSeconds);
  return json.Finish();
}

// The channels of an EXR by layers, which are what stands before the last point.
std::string PictureText(const std::string& name, const PictureInfo& info) {
  std::map<std::string, std::string> layers;
  for (const auto& [channel, type] : info.channels) {
    const std::size_t point = channel.rfind('.');
    const std::string layer = point == channel.npos ? "the picture" : channel.substr(0, point);
    const std::string letter = point == channel.npos ? channel : channel.substr(point + 1);
    layers[layer] += fmt::format("{}{} ({})", layers[layer].empty() ? "" : ", ", letter, type);
  }
  std::string text = fmt::format("{}\n  picture    {} × {}\n  layers     {}\n", name, info.width,
                                 info.height, layers.size());
  for (const auto& [layer, channels] : layers)
    text += fmt::format("             {}: {}\n", layer, channels);
  return text;
}

std::string PictureJson(const std::string& name, const PictureInfo& info) {
  JsonWriter json;
  json.Add("picture", name);
  json.Add("width", info.width);
  json.Add("height", info.height);
  json.BeginObject("channels");
  for (const auto& [channel, type] : info.channels) json.Add(channel, type);
  json.End();
  return json.Finish();
}

int RunInfo(const InfoArguments& arguments) {
  if (LowerExtension(arguments.scene) == "exr") {
    const PictureInfo info = InspectPicture(arguments.scene);
    PrintOut(arguments.json ? PictureJson(arguments.scene, info)
                            : Printable(PictureText(arguments.scene, info)));
    return Succeeded;
  }
  const SceneInfo info = Inspect(Load(arguments.scene, arguments.load, PrintWarning));
  for (const std::string& warning : info.warnings) PrintWarning({warning, {arguments.scene}});
  PrintOut(arguments.json ? InfoJson(info) : Printable(InfoText(info)));
  return Succeeded;
}

}  // namespace

void AddInfoCommand(Program& program) {
  const auto arguments = std::make_shared<InfoArguments>();
  CLI::App& command = AddCommand<InfoArguments>(program, "info", "Tell what is in a scene", Details,
                                                arguments, RunInfo);
  AddArgument(command, "SCENE", arguments->scene,
              "A scene or a mesh (" + KnownSceneExtensions() + ")");
  command.option_defaults()->group("Form");
  AddFlag(command, "--json", arguments->json, "As JSON, with everything in full");
  AddLoadOptions(command, arguments->load);
}

}  // namespace snell::cli
