// SPDX-License-Identifier: Apache-2.0
#include "cpu/albedo_tables.h"

#include <algorithm>

#include "cpu/wavelength_table.h"
#include "kernel/albedo.h"

namespace snell::cpu {

using namespace kernel;

namespace {

constexpr float Albedos[] = {
#include "albedos.inc"  // by integrate_albedos.cpp
};
static_assert(std::size(Albedos) == WAVELENGTH_TABLE);

std::vector<float> Tables() {
  std::vector<float> tables(AlbedoCount);
  std::ranges::copy(Albedos, tables.begin());
  FillWavelengthTable(std::span(tables).subspan(WAVELENGTH_TABLE, 4 * WavelengthNodes));
  return tables;
}

}  // namespace

const std::vector<float>& AlbedoTables() {
  static const std::vector<float> tables = Tables();
  return tables;
}

}  // namespace snell::cpu
