// SPDX-License-Identifier: Apache-2.0
//
// Oracles for light transport: scenes whose pictures are known in closed form, and samplers against their own
// densities. Each group renders or samples anew; together they take some seconds on a few cores.
#pragma once

#include "selftest/check.h"

namespace snell::selftest {

struct Group {
  const char* name;
  const char* meaning;  // one line
  void (*run)(const CheckSink& sink);
};

// In the order in which they run.
const std::vector<Group>& Groups();

// The groups themselves
void Furnaces(const CheckSink& sink);
void ClosedRooms(const CheckSink& sink);
void Luminaires(const CheckSink& sink);
void Samplers(const CheckSink& sink);
void Reciprocity(const CheckSink& sink);
void PublishedScenes(const CheckSink& sink);

}  // namespace snell::selftest
