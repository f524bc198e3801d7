// SPDX-License-Identifier: Apache-2.0
//
// Parts of the group of samplers. A line of the table is the least p-value of up to eight tests; all together the table
// would reject what is right in one of some fifty runs, were its numbers not the same in every run.
#pragma once

#include "selftest/check.h"

namespace snell::selftest {

constexpr double SamplerSignificance = 1e-4;

Check LikelySampler(std::string name, double pValue);

void LightSamplers(const CheckSink& sink);
void CameraSamplers(const CheckSink& sink);

}  // namespace snell::selftest
