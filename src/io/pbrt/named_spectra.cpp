// SPDX-License-Identifier: Apache-2.0
//
// The spectra that pbrt knows by name. Complex indices of refraction n + ik: silver, gold and brass as in
// scene/measured.h; copper, Hagemann, Gudat and Kunz 1974; aluminium, Smith, Shiles and Inokuti 1985; magnesium oxide, Stephens and Malitson 1952; titanium dioxide, DeVore 1951. Glass: catalogues of Schott and
// Hikari. Illuminants: CIE 15:2004, tables T.3 and T.8.1.
#include <algorithm>
#include <array>
#include <map>

#include "io/pbrt/spectra.h"
#include "scene/measured.h"

namespace snell::io {
namespace {

struct Metal {
  std::string_view name;
  std::vector<std::array<double, 3>> rows;  // nanometres, n, k
};

const std::array<Metal, 4>& Metals() {
  static const std::array<Metal, 4> metals = {{
      {"Al",
       {{375, 0.43, 4.54},
        {400, 0.49, 4.86},
        {450, 0.62, 5.47},
        {500, 0.77, 6.08},
        {550, 0.96, 6.69},
        {600, 1.20, 7.26},
        {650, 1.47, 7.79},
        {700, 1.83, 8.31},
        {750, 2.40, 8.62}}},
      {"Cu",
       {{387.5, 1.232, 2.07},
        {413.3, 1.184, 2.21},
        {442.8, 1.169, 2.36},
        {476.9, 1.152, 2.50},
        {516.6, 1.121, 2.60},
        {539.1, 1.037, 2.59},
        {563.6, 0.826, 2.60},
        {590.4, 0.468, 2.81},
        {619.9, 0.272, 3.24},
        {652.5, 0.214, 3.67},
        {670.2, 0.215, 3.86}}},
      {"MgO", {{400, 1.761, 0}, {500, 1.745, 0}, {600, 1.736, 0}, {700, 1.731, 0}}},
      {"TiO2", {{430, 2.871, 0}, {500, 2.711, 0}, {600, 2.605, 0}, {700, 2.550, 0}}},
  }};
  return metals;
}

struct Glass {
  std::string_view name;
  double ior;
  float abbe;
};
constexpr std::array<Glass, 8> Glasses = {{{"glass-BK7", 1.5168, 64.2f},
                                           {"glass-BAF10", 1.6700, 47.1f},
                                           {"glass-FK51A", 1.4866, 84.5f},
                                           {"glass-LASF9", 1.8503, 32.2f},
                                           {"glass-F5", 1.6034, 38.0f},
                                           {"glass-SF5", 1.6727, 32.2f},
                                           {"glass-SF10", 1.7283, 28.5f},
                                           {"glass-SF11", 1.7847, 25.8f}}};

struct Illuminant {
  std::string_view name;
  glm::dvec2 xy;
};
const std::array<Illuminant, 18> Illuminants = {{{"stdillum-A", {0.44758, 0.40745}},
                                                 {"stdillum-D50", {0.34567, 0.35851}},
                                                 {"stdillum-D55", {0.33243, 0.34744}},
                                                 {"stdillum-D65", {0.31272, 0.32903}},
                                                 {"stdillum-D75", {0.29903, 0.31488}},
                                                 {"illum-acesD60", {0.32168, 0.33767}},
                                                 {"stdillum-F1", {0.3131, 0.3371}},
                                                 {"stdillum-F2", {0.3721, 0.3751}},
                                                 {"stdillum-F3", {0.4091, 0.3941}},
                                                 {"stdillum-F4", {0.4402, 0.4031}},
                                                 {"stdillum-F5", {0.3138, 0.3452}},
                                                 {"stdillum-F6", {0.3779, 0.3882}},
                                                 {"stdillum-F7", {0.3129, 0.3292}},
                                                 {"stdillum-F8", {0.3458, 0.3586}},
                                                 {"stdillum-F9", {0.3741, 0.3727}},
                                                 {"stdillum-F10", {0.3458, 0.3588}},
                                                 {"stdillum-F11", {0.3805, 0.3769}},
                                                 {"stdillum-F12", {0.4370, 0.4042}}}};

std::map<std::string, PbrtTable, std::less<>> MakeTables() {
  std::map<std::string, PbrtTable, std::less<>> tables;
  for (const Metal& metal : Metals()) {
    const std::string name = "metal-" + std::string(metal.name);
    PbrtTable &eta = tables[name + "-eta"], &k = tables[name + "-k"];
    for (const auto& [wavelength, n, extinction] : metal.rows) {
      eta.wavelengths.push_back(wavelength);
      eta.values.push_back(n);
      k.wavelengths.push_back(wavelength);
      k.values.push_back(extinction);
    }
  }
  const auto measured = [&](const char* symbol, const char* name) {
    const std::string prefix = std::string("metal-") + symbol;
    PbrtTable &eta = tables[prefix + "-eta"], &k = tables[prefix + "-k"];
    for (const scene::IndexSample& sample : scene::FindMetal(name)->samples) {
      eta.wavelengths.push_back(sample.nanometres);
      eta.values.push_back(sample.n);
      k.wavelengths.push_back(sample.nanometres);
      k.values.push_back(sample.k);
    }
  };
  measured("Ag", "silver");
  measured("Au", "gold");
  measured("CuZn", "brass");
  const auto add = [&](const Glass& glass) {
    tables[std::string(glass.name)] = {{587.6}, {glass.ior}};
  };
  for (const Glass& glass : Glasses) add(glass);
  return tables;
}

}  // namespace

const PbrtTable* NamedTable(std::string_view name) {
  static const std::map<std::string, PbrtTable, std::less<>> tables = MakeTables();
  const auto entry = tables.find(name);
  return entry == tables.end() ? nullptr : &entry->second;
}

float AbbeNumber(std::string_view name) {
  const auto* glass = std::ranges::find(Glasses, name, &Glass::name);
  return glass == Glasses.end() ? 0 : glass->abbe;
}

std::optional<scene::Spectrum> NamedLight(std::string_view name) {
  const auto* light = std::ranges::find(Illuminants, name, &Illuminant::name);
  if (light == Illuminants.end()) return {};
  return LightColor(light->xy);
}

}  // namespace snell::io
