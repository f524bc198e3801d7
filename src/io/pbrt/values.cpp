// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/values.h"

#include <algorithm>
#include <glm/common.hpp>

#include "io/mesh/text.h"
#include "util/file.h"

namespace snell::io {

using scene::Spectrum;

static constexpr std::uint64_t MaxSpectrumBytes = 1 << 24;

float Largest(const Spectrum& color) { return std::max({color.x, color.y, color.z}); }
float Mean(const Spectrum& color) { return (color.x + color.y + color.z) / 3; }
Spectrum Albedo(const Spectrum& color) { return glm::clamp(color, 0.0f, 1.0f); }

double PbrtSpectrum::At(double nanometres) const {
  if (table) return table->At(nanometres);
  return double(nanometres < 490 ? rgb.z : nanometres < 580 ? rgb.y : rgb.x);
}

Spectrum PbrtSpectrum::Factor() const {
  if (!table) return glm::max(rgb, Spectrum(0.0f));
  return ReflectanceColor([&](double wavelength) { return table->At(wavelength); });
}

Spectrum PbrtSpectrum::Light() const {
  if (!table) return glm::max(rgb, Spectrum(0.0f));
  return LightColor([&](double wavelength) { return table->At(wavelength); });
}

// A spectrum by its name or by a file's.
static std::optional<PbrtSpectrum> FindSpectrum(const std::string& name, const Place& place,
                                                PbrtContext& context) {
  PbrtSpectrum spectrum;
  if (const PbrtTable* table = NamedTable(name)) {
    spectrum.table = *table;
    return spectrum;
  }
  if (const auto light = NamedLight(name)) {
    spectrum.rgb = *light;
    return spectrum;
  }
  const auto known = context.spectrumFiles.find(name);
  if (known != context.spectrumFiles.end()) {
    spectrum.table = known->second;
    return spectrum;
  }
  if (const auto path = context.files.Find(context.folder, name)) {
    spectrum.table = ParseTable(ReadFile(*path, MaxSpectrumBytes), path->string());
    context.spectrumFiles.emplace(name, *spectrum.table);
    return spectrum;
  }
  context.findings.Add("spectrum", "neither known by name nor found as a file: left out", name,
                       place);
  return {};
}

std::optional<PbrtSpectrum> SpectrumOf(const PbrtParameters& parameters, std::string_view name,
                                       PbrtContext& context) {
  const PbrtParameter* found = parameters.Find(
      name,
      {PbrtType::Spectrum, PbrtType::Rgb, PbrtType::Blackbody, PbrtType::Float, PbrtType::Integer});
  if (!found) return {};
  const std::vector<double>& numbers = found->numbers;
  const auto require = [&](bool condition) {
    if (!condition) throw Error("the parameter has too few or too many values", found->place);
  };
  PbrtSpectrum spectrum;
  switch (found->type) {
    case PbrtType::Rgb: {
      require(numbers.size() == 3);
      const glm::dvec3 rgb(numbers[0], numbers[1], numbers[2]);
      const bool isRec709 = context.colorSpace.red == image::Chromaticities().red;
      spectrum.rgb = Spectrum(isRec709 ? rgb : image::ToRec709(context.colorSpace) * rgb);
      break;
    }
    case PbrtType::Blackbody:
      // pbrt-v2 and v3 give a second number, the scale
      require(numbers.size() == 1 || numbers.size() == 2);
      spectrum.rgb = LightColor([&](double nm) { return BlackbodyRadiance(nm, numbers[0]); });
      if (numbers.size() == 2) spectrum.rgb *= float(std::max(numbers[1], 0.0));
      break;
    case PbrtType::Spectrum:
      if (!found->strings.empty()) {
        require(found->strings.size() == 1 && numbers.empty());
        return FindSpectrum(found->strings[0], found->place, context);
      }
      spectrum.table = MakeTable(numbers, found->place);
      break;
    default: require(numbers.size() == 1); spectrum.rgb = Spectrum(float(numbers[0]));
  }
  return spectrum;
}

Spectrum AlbedoOf(const PbrtParameters& parameters, std::string_view name, const Spectrum& absent,
                  PbrtContext& context) {
  const auto spectrum = SpectrumOf(parameters, name, context);
  return spectrum ? Albedo(spectrum->Factor()) : absent;
}

}  // namespace snell::io
