// SPDX-License-Identifier: Apache-2.0
//
// Keys of point and spot lights that shine as measured: the file, and how the lamp is turned.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "io/ies/ies.h"
#include "io/toml/sections.h"
#include "util/file.h"

namespace snell::io {

using glm::dvec3;

Keys<LightDraft> ProfileKeys() {
  return {Field("ies", &LightDraft::profileFile, SceneFile("lamp.ies"),
                "A photometric file (IES LM-63) of how the lamp shines by direction. Its vertical "
                "angle 0 is `direction`; hanging down, its horizontal angle 0 is +x and 90° is −z.")
              .Standard("the same in all directions")
              .Not({"profile", "photometry", "ies_file"}),
          Field("ies_rotation", &LightDraft::profileRotation, Degrees({-360, 360}),
                "Turns the lamp of `ies` about its axis, counter-clockwise seen from behind.")};
}

// The file's table among the scene's. A file that several lamps share is read once.
static int LoadProfile(Reader& reader, const std::filesystem::path& file) {
  std::vector<scene::LightProfile>& profiles = reader.scene.profiles;
  const auto known = std::ranges::find(profiles, file.string(), &scene::LightProfile::name);
  if (known == profiles.end()) {
    profiles.push_back(ReadIes(ReadFile(file), file.string()));
    return int(profiles.size()) - 1;
  }
  return int(known - profiles.begin());
}

// The horizontal angles 0 and 90° of a lamp that hangs down, tilted to its direction by the shortest way, and turned.
static void SetFrame(scene::Light& light, double rotation) {
  const dvec3 axis = glm::normalize(dvec3(light.direction));
  dvec3 u(1, 0, 0), v(0, 0, -1);
  const double cosine = -axis.y;
  if (cosine > -1 + 1e-9) {
    const dvec3 turn = glm::cross(dvec3(0, -1, 0), axis);
    const auto tilted = [&](const dvec3& w) {
      return w * cosine + glm::cross(turn, w) + turn * (glm::dot(turn, w) / (1 + cosine));
    };
    u = tilted(u);
    v = tilted(v);
  } else {
    v = -v;  // upside down
  }
  light.edgeU = vec3(u * std::cos(rotation) + v * std::sin(rotation));
  light.edgeV = vec3(v * std::cos(rotation) - u * std::sin(rotation));
}

void FinishProfile(Reader& reader, const Fields& fields, LightDraft& draft) {
  if (draft.profileFile.empty()) {
    const bool isPoint = draft.light.kind == scene::LightKind::Point;
    for (const char* key : {"ies_rotation", "direction", "look_at"}) {
      if (fields.Find(key) && (isPoint || std::string_view(key) == "ies_rotation"))
        reader.Warn(fmt::format("'{}' has no effect without 'ies'", key), fields.PlaceOf(key));
    }
    return;
  }
  try {
    draft.light.profile = LoadProfile(reader, draft.profileFile);
  } catch (const Error& error) {
    const Diagnostic& first = error.diagnostics().front();
    const std::string line =
        first.place.line > 0 ? fmt::format("line {}: ", first.place.line) : std::string();
    reader.Report(fmt::format("the photometric file cannot be used: {}{}", line, first.message),
                  fields.PlaceOf("ies"), first.hint);
    return;
  }
  const scene::LightProfile& profile = reader.scene.profiles[std::size_t(draft.light.profile)];
  if (!fields.Find("intensity"))
    draft.light.strength = *std::ranges::max_element(profile.intensities);
  SetFrame(draft.light, double(draft.profileRotation));
}

}  // namespace snell::io
