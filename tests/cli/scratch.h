// SPDX-License-Identifier: Apache-2.0
//
// Tests that run the program in a folder of their own, and small scenes to put into it.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "child.h"
#include "support/scratch_folder.h"

namespace snell::test {

class InScratchFolder : public testing::Test, protected ScratchFolder {
 protected:
  // Run the program there.
  Result Run(const std::vector<std::string>& arguments, Surroundings surroundings = {}) const {
    if (surroundings.folder.empty()) surroundings.folder = folder_;
    return RunSnell(arguments, surroundings);
  }
};

// Two spheres that reflect each other and refract, on a plane, under two lights: 48 × 32 pixels, one sample.
inline std::string SpheresScene(const std::string& resolution = "48 32") {
  return "b 0.1 0.2 0.4\nv\nfrom 2.1 1.7 1.3\nat 0 0 0\nup 0 0 1\nangle 30\nhither "
         "0.01\nresolution " +
         resolution +
         "\nl 4 3 2\nl 1 -4 4\nf 1 0.75 0.3 0.8 0.2 20 0 1\np 4\n6 6 -0.5\n-6 6 -0.5\n-6 -6 -0.5\n"
         "6 -6 -0.5\nf 0.9 0.7 0.6 0.3 0.5 30 0 1\ns 0 0 0 0.5\nf 1 1 1 0.1 0.5 30 0.8 1.5\n"
         "s 0.5 0.5 0.3 0.2\n";
}

// More samples than anybody waits for; stopped by signals.
inline const std::vector<std::string> EndlessRender = {
    "render", "spheres.nff", "--spp", "100000000", "-o", "a.png", "--size", "320"};

}  // namespace snell::test
