// SPDX-License-Identifier: Apache-2.0
//
// Media, by their coefficients: around all objects, or within a boundary that is not seen (materials of type "volume").
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "io/grid/nanovdb.h"
#include "io/toml/sections.h"
#include "util/file.h"

namespace snell::io {

using scene::Medium;
using scene::OpenPbr;

static Keys<Medium> MediumKeys() {
  const auto coefficient = [](const char* name, Spectrum Medium::*member, const char* unit,
                              const char* text) {
    Type<Spectrum> type = Color(Brightness::Unlimited);
    type.unit = unit;
    return Field(name, member, type, text);
  };
  return {coefficient("absorption", &Medium::absorption, "1/m",
                      "The share of light that a metre absorbs, for thin media.")
              .Not({"sigma_a", "mu_a"}),
          coefficient("scattering", &Medium::scattering, "1/m",
                      "The share of light that a metre turns into other directions.")
              .Not({"sigma_s", "mu_s", "scatter"}),
          Field("density", &Medium::density, Number({0, 1e6}),
                "Multiplies absorption, scattering and glow.")
              .Not({"scale"}),
          Field("anisotropy", &Medium::anisotropy, Number({-0.99, 0.99}),
                "Where light is scattered to (Henyey and Greenstein's g): 1 forward, 0 to all "
                "sides, −1 back.")
              .Not({"g", "phase"}),
          coefficient("glow", &Medium::emission, "W/(sr·m³)",
                      "The radiance that a metre adds, for thin media.")
              .Not({"volume_emission"})};
}

const SectionOf<Medium>& MediumSection() {
  static const SectionOf<Medium> section(
      "medium", "medium", "What fills a space evenly, such as fog and smoke.", MediumKeys());
  return section;
}

Keys<OpenPbr> InteriorKeys() {
  return {Field("transmission_scatter", &OpenPbr::transmissionScatter, Color(Brightness::Unlimited),
                "The share of light that is scattered inside along `transmission_depth`, for "
                "little of it: makes milk of water."),
          Field("transmission_scatter_anisotropy", &OpenPbr::transmissionScatterAnisotropy,
                Number({-1, 1}), "Where it is scattered to: 1 forward, −1 back."),
          Field("subsurface_weight", &OpenPbr::subsurfaceWeight, Share(),
                "How much of the matt base lets light in, to wander below the surface.")
              .Not({"subsurface", "sss"}),
          Field("subsurface_color", &OpenPbr::subsurfaceColor,
                ColorOrTexture(Brightness::Reflectance), "What a thick body sends back of it."),
          Field("subsurface_radius", &OpenPbr::subsurfaceRadius, Number(Positive, "m"),
                "How far light gets between two scatterings."),
          Field("subsurface_radius_scale", &OpenPbr::subsurfaceRadiusScale,
                Color(Brightness::Reflectance), "The share of that for red, green and blue."),
          Field("subsurface_scatter_anisotropy", &OpenPbr::subsurfaceScatterAnisotropy,
                Number({-1, 1}), "Where light is scattered to there: 1 forward, −1 back.")};
}

// Take the grid from its file into the scene.
static void LoadGrid(Reader& reader, const Fields& fields, MaterialDraft& draft) {
  if (draft.gridFile.empty()) {
    if (fields.Find("grid_name"))
      reader.Warn("'grid_name' has no effect without 'grid'", fields.PlaceOf("grid_name"));
    return;
  }
  try {
    // A grid that several materials show is read once
    const std::string file = draft.gridFile.string();
    const std::string name = draft.gridName.empty() ? file : file + ':' + draft.gridName;
    std::vector<scene::DensityGrid>& grids = reader.scene.grids;
    const auto known = std::ranges::find(grids, name, &scene::DensityGrid::name);
    draft.volume.grid = int(known - grids.begin());
    if (known != grids.end()) return;
    grids.push_back(ReadNanoVdb(ReadFile(draft.gridFile), file, draft.gridName));
    grids.back().name = name;
  } catch (const Error& error) {
    const Diagnostic& first = error.diagnostics().front();
    reader.Report(fmt::format("the grid cannot be read: {}", first.message), fields.PlaceOf("grid"),
                  first.hint);
  }
}

static void FinishVolume(Reader& reader, const Fields& fields, MaterialDraft& draft) {
  for (const char* key : {"ior", "thin", "emission", "attenuation_color", "attenuation_distance"}) {
    if (!fields.Find(key)) continue;
    reader.Warn(fmt::format("'{}' has no effect on a volume, whose boundary is not seen", key),
                fields.PlaceOf(key));
  }
  LoadGrid(reader, fields, draft);
  draft.material.thin = false;
  draft.material.transparency = {Spectrum(1.0f)};
  draft.material.volume = draft.volume;
}

static Keys<MaterialDraft> GridKeys() {
  return {Field("grid", &MaterialDraft::gridFile, SceneFile("cloud.nvdb"),
                "A NanoVDB file of densities, in the object's space, that multiply absorption, "
                "scattering and glow.")
              .Standard("the same density everywhere")
              .Not({"file", "vdb", "density_grid"}),
          Field("grid_name", &MaterialDraft::gridName, Text("density"), "Of a grid in the file.")
              .Standard("the first one")};
}

VariantOf<MaterialDraft> VolumeMaterial() {
  return VariantOf<MaterialDraft>(
             "volume", "A boundary that is not seen, filled with a medium; for closed shapes.",
             Join<MaterialDraft>({Within(&MaterialDraft::volume, MediumKeys()), GridKeys()}))
      .Begin([](MaterialDraft& draft) { draft.material.priority = -1; })
      .Checked(FinishVolume);
}

}  // namespace snell::io
