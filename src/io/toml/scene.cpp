// SPDX-License-Identifier: Apache-2.0
//
// The walk through a native scene: what is referred to is read before what refers to it.
#include "io/toml/scene.h"

#include <fmt/format.h>

#include <memory>
#include <set>
#include <utility>

#include "io/toml/document.h"
#include "io/toml/groups.h"
#include "io/toml/reader.h"
#include "io/toml/sections.h"

namespace snell::io {

namespace {

class SceneReader {
 public:
  SceneReader(Reader& reader, const Document& document) : reader_(reader), document_(document) {}

  void Read(const WarningSink& warn) {
    ReadSettings();
    ReadCameras();
    ReadTextures();
    ReadMaterials();
    ReadGroups();
    CheckGroups(reader_, groups_);
    reader_.ThrowFindings();

    // Large files are loaded only when the rest is known to be right
    for (Diagnostic& error : reader_.meshes.Load(reader_.scene.meshes, reader_.limits, warn))
      reader_.Report(std::move(error.message), std::move(error.place), std::move(error.hint));
    reader_.inclusions.Load(reader_, warn);
    PlaceEnvironment(reader_, document_.environment, environment_);
    for (Group& group : groups_)
      for (Member& member : group.members)
        if (member.included) ReplaceMaterials(reader_, *member.included);
    reader_.ThrowFindings();
    PlaceAll(reader_, groups_);
    reader_.ThrowFindings();
    WarnOfSheets();
    reader_.EmitWarnings(warn);
  }

 private:
  void ReadSettings() {
    RenderDraft render;
    if (ReadTable(reader_, RenderSection(), document_.render, render))
      reader_.scene.settings = render.settings;
    ReadTable(reader_, EnvironmentSection(), document_.environment, environment_);
  }

  void ReadCameras() {
    std::set<std::string> names;
    for (const Fields& fields : document_.cameras) {
      CameraDraft draft;
      ReadTable(reader_, CameraSection(), fields, draft);
      if (!draft.camera.name.empty() && !names.insert(draft.camera.name).second)
        reader_.Report(fmt::format("two cameras have the name {}", QuotedName(draft.camera.name)),
                       fields.PlaceOf("name"));
      reader_.scene.cameras.push_back(draft.camera);
    }
  }

  // A faulty definition keeps its name, so that no reference to it is reported as well
  void ReadTextures() {
    for (const auto& [name, fields] : document_.textures) {
      TextureDraft draft;
      draft.texture.name = name;
      ReadTable(reader_, TextureSection(), fields, draft);
      reader_.textures.emplace(name, int(reader_.scene.textures.size()));
      reader_.scene.textures.push_back(std::move(draft.texture));
    }
  }

  void ReadMaterials() {
    for (const auto& [name, fields] : document_.materials)
      reader_.materials.emplace(name, AddMaterial(reader_, name, fields));
  }

  // The first group is the scene itself.
  void ReadGroups() {
    groups_.resize(1);
    groups_[0].place = {reader_.files.front()};
    for (const auto& [name, fields] : document_.groups) {
      reader_.groups.emplace(name, int(groups_.size()));
      groups_.push_back({name, fields.place, {}, {}});
    }
    ReadMembers(document_.objects, document_.lights, groups_[0]);
    for (std::size_t i = 0; i < document_.groups.size(); ++i)
      ReadGroup(document_.groups[i].fields, groups_[i + 1]);
  }

  void ReadGroup(const Fields& fields, Group& group) {
    for (const Node::Entry& entry : fields.entries)
      if (entry.name != "object" && entry.name != "light")
        ReportUnknownKey(reader_, GroupSection(), entry, fields.title);
    const std::string path = fmt::format("group.{}", Printable(group.name));
    ReadMembers(TablesOf(reader_, fmt::format("[[{}.object]]", path), fields.Find("object")),
                TablesOf(reader_, fmt::format("[[{}.light]]", path), fields.Find("light")), group);
  }

  void ReadMembers(const std::vector<Fields>& objects, const std::vector<Fields>& lights,
                   Group& group) {
    group.members.reserve(objects.size());
    for (const Fields& fields : objects) {
      ObjectDraft draft;
      draft.object.place = fields.place;
      if (!ReadTable(reader_, ObjectSection(), fields, draft)) continue;
      const auto placed = reader_.groups.find(draft.group);
      group.members.push_back(
          {std::move(draft.object), draft.meshes,
           placed == reader_.groups.end() || draft.group.empty() ? -1 : placed->second,
           draft.included.number < 0 ? nullptr
                                     : std::make_shared<IncludedFile>(std::move(draft.included))});
    }
    for (const Fields& fields : lights) {
      LightDraft draft;
      if (ReadTable(reader_, LightSection(), fields, draft))
        group.lights.push_back({std::move(draft), fields.place});
    }
  }

  // Rays that enter a surface without an inside never leave it.
  void WarnOfSheets() {
    std::set<std::string> warned;
    for (const scene::Object& object : reader_.scene.objects) {
      const scene::Material& material = reader_.scene.materials[std::size_t(object.material)];
      const bool wanders = material.physical && material.physical->subsurfaceWeight.value > 0;
      if (!(material.Refractive() || wanders) || material.thin || !IsSheet(object.geometry))
        continue;
      if (!warned.insert(ToString(object.place)).second) continue;
      reader_.Warn(fmt::format("the material {} {}, but this object has no inside",
                               QuotedName(material.name),
                               wanders           ? "lets light wander below the surface"
                               : material.volume ? "is a volume"
                                                 : "refracts"),
                   object.place, "set 'thin = true' in the material, or use a closed shape");
    }
  }

  bool IsSheet(const scene::Geometry& geometry) const {
    if (const auto* cone = std::get_if<scene::Cone>(&geometry)) return !cone->capped;
    if (const auto* mesh = std::get_if<scene::MeshGeometry>(&geometry))
      return reader_.scene.meshes[std::size_t(mesh->mesh)].triangles.size() == 1;
    return std::holds_alternative<scene::Disk>(geometry) ||
           std::holds_alternative<scene::Rectangle>(geometry);
  }

  Reader& reader_;
  const Document& document_;
  EnvironmentDraft environment_;
  std::vector<Group> groups_;
};

// Says that a file is being read while it lives.
class OpenScope {
 public:
  OpenScope(Inclusion& inclusion, const std::filesystem::path& path) : inclusion_(inclusion) {
    std::error_code ignored;
    inclusion_.open.push_back(std::filesystem::weakly_canonical(path, ignored).string());
  }
  ~OpenScope() { inclusion_.open.pop_back(); }
  OpenScope(const OpenScope&) = delete;
  OpenScope& operator=(const OpenScope&) = delete;

 private:
  Inclusion& inclusion_;
};

}  // namespace

Contents ReadToml(const std::filesystem::path& path, const ReadOptions& options,
                  const WarningSink& warn) {
  Reader reader(path, options);
  const OpenScope scope(*reader.inclusion, path);
  const Document document = ReadDocument(reader, path);
  SceneReader(reader, document).Read(warn);
  return {std::move(reader.scene), reader.animated};
}

}  // namespace snell::io
