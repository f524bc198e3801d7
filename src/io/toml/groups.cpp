// SPDX-License-Identifier: Apache-2.0
#include "io/toml/groups.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/toml/place_included.h"
#include "util/text.h"

namespace snell::io {

namespace {

// Counts what each group comes to before anything is placed: a chain of groups that hold the next one
// twice grows by powers of two.
class GroupCounter {
 public:
  GroupCounter(Reader& reader, const std::vector<Group>& groups)
      : reader_(reader),
        groups_(groups),
        counts_(groups.size(), 0),
        states_(groups.size(), State::New) {}

  // False if something was reported.
  bool Count() { return Visit(0, 0, groups_[0].place) && Fits(); }

  std::uint64_t operator[](int group) const { return counts_[std::size_t(group)]; }

 private:
  enum class State { New, Open, Done };

  bool Visit(int index, int depth, const Place& from) {
    State& state = states_[std::size_t(index)];
    const Group& group = groups_[std::size_t(index)];
    if (state == State::Done) return true;
    if (state == State::Open)
      return Fail(fmt::format("the group {} holds itself", QuotedName(group.name)), from);
    if (depth > MaxGroupDepth)
      return Fail(fmt::format("groups are nested more than {} deep", MaxGroupDepth), from);
    state = State::Open;
    std::uint64_t count = group.lights.size();
    for (const Member& member : group.members) {
      if (member.group >= 0 && !Visit(member.group, depth + 1, member.object.place)) return false;
      count = std::min(count + CountOf(member), reader_.limits.objects + 1);
    }
    counts_[std::size_t(index)] = count;
    state = State::Done;
    return true;
  }

  std::uint64_t CountOf(const Member& member) const {
    if (member.group >= 0) return counts_[std::size_t(member.group)];
    if (member.meshes >= 0) return std::uint64_t(reader_.meshes.MeshesOf(member.meshes).count);
    if (!member.included) return 1;
    const scene::Scene& file = reader_.inclusions[member.included->number];
    return file.objects.size() + file.lights.size() + file.cameras.size();
  }

  bool Fits() {
    if (counts_[0] <= reader_.limits.objects) return true;
    return Fail(fmt::format("with all groups placed the scene has more than {} objects and lights",
                            WithCommas(reader_.limits.objects)),
                groups_[0].place, LiftedBy(&ReadLimits::objects));
  }

  bool Fail(std::string message, const Place& place, std::string hint = {}) {
    reader_.Report(std::move(message), place, std::move(hint));
    return false;
  }

  Reader& reader_;
  const std::vector<Group>& groups_;
  std::vector<std::uint64_t> counts_;
  std::vector<State> states_;
};

class Placer {
 public:
  Placer(Reader& reader, const std::vector<Group>& groups, const GroupCounter& counts)
      : reader_(reader), groups_(groups), counts_(counts) {}

  void Place(int index, const Surroundings& around) {
    if (counts_[index] == 0) return;
    const Group& group = groups_[std::size_t(index)];
    for (const Member& member : group.members) {
      const Surroundings inner = Inside(around, member);
      if (member.group >= 0)
        Place(member.group, inner);
      else if (member.included)
        PlaceIncluded(reader_, member, inner);
      else
        PlaceObject(member, inner);
    }
    for (const MemberLight& light : group.lights) {
      scene::Light placed;
      if (!PlaceLight(reader_, light.draft, around.toWorld, light.place, placed)) continue;
      placed.name = JoinNames(around.name, placed.name);
      reader_.scene.lights.push_back(std::move(placed));
    }
  }

 private:
  static Surroundings Inside(const Surroundings& around, const Member& member) {
    const scene::Object& object = member.object;
    return {around.toWorld * object.toWorld,
            JoinNames(around.name, object.name),
            object.material >= 0 ? object.material : around.material,
            around.visibleToCamera && object.visibleToCamera,
            around.visibleToSecondary && object.visibleToSecondary,
            around.castsShadow && object.castsShadow,
            MotionWithin(around, object)};
  }

  void PlaceObject(const Member& member, const Surroundings& inner) {
    scene::Object object = member.object;
    object.toWorld = inner.toWorld;
    object.motion = inner.motion;
    object.name = inner.name;
    object.material = inner.material >= 0 ? inner.material : DefaultMaterial(reader_);
    object.visibleToCamera = inner.visibleToCamera;
    object.visibleToSecondary = inner.visibleToSecondary;
    object.castsShadow = inner.castsShadow;
    if (std::string reason; !IsUsable(object.toWorld, reason)) {
      reader_.Report(
          fmt::format("the transforms of the groups around this object cannot be used: {}", reason),
          object.place);
      return;
    }
    if (member.meshes < 0) {
      reader_.scene.objects.push_back(std::move(object));
      return;
    }
    const MeshLibrary::Range range = reader_.meshes.MeshesOf(member.meshes);
    for (int i = 0; i < range.count; ++i) {
      object.geometry = scene::MeshGeometry{range.first + i};
      reader_.scene.objects.push_back(object);
    }
  }

  Reader& reader_;
  const std::vector<Group>& groups_;
  const GroupCounter& counts_;
};

}  // namespace

bool CheckGroups(Reader& reader, const std::vector<Group>& groups) {
  return GroupCounter(reader, groups).Count();
}

void PlaceAll(Reader& reader, const std::vector<Group>& groups) {
  GroupCounter counts(reader, groups);
  if (!counts.Count()) return;
  Placer(reader, groups, counts).Place(0, {});
}

}  // namespace snell::io
