// SPDX-License-Identifier: Apache-2.0
//
// How one sample of a pixel came about: the rays of its path or tree, what each met, which light it found there, and the
// terms that the sample's radiance is the sum of. All places and directions are in the world, metres.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "kernel/types.h"

namespace snell::explain {

// What a ray reads from a texture where it meets a surface.
struct TextureRead {
  std::string texture;
  kernel::vec2 uv{0};
  kernel::vec4 value{0};
};

// One light that was looked for from a surface or a point in a medium.
struct LightTry {
  std::string light;
  std::string outcome;  // "lit", or why not
  std::string blocker;  // the first object between, if that is why
  kernel::vec3 start{0};
  kernel::vec3 wi{0};  // unit direction to the light
  float distance = 0;  // that the shadow ray went, or would have gone
  float pick = 1;      // the probability of choosing this light
  float pdf = 0;       // of wi, per solid angle; 0 of what rays cannot meet by chance
  float weight = 1;    // of multiple importance sampling, or of this one of several samples
  kernel::Spectrum irradiance{0};  // on a surface that faces it
  kernel::Spectrum f{0};           // what is scattered from it to the ray's origin, with the cosine
  float bsdfPdf = 0;               // of the surface's own samples in that direction
  kernel::Spectrum passed{0};      // the share that arrives
};

// What a ray met.
struct Surface {
  std::string object;
  std::string material;
  std::string place;  // of the object in the scene's file, "scene.toml:12"; may be empty
  std::string part;   // "triangle 7" or "sphere"
  kernel::vec3 p{0};
  kernel::vec3 n{0};   // geometric unit normal, to the outside
  kernel::vec3 ns{0};  // shading normal, before maps turn it
  kernel::vec2 uv{0};
  bool fromOutside = true;
  // Where it is a boundary between media
  bool refracts = false;
  float nearIor = 1;  // on the ray's side
  float eta = 1;      // beyond it, relative to that
  float fresnel = 0;  // reflectance of a smooth boundary
  bool totalReflection = false;
};

// How a path goes on from a surface.
struct Way {
  std::string lobe;
  float pdf =
      0;  // per solid angle; of smooth lobes, the probability of the lobe; 0: there was none
  kernel::Spectrum weight{0};
};

struct Segment {
  int parent = -1;   // that it branched off from or goes on from
  std::string kind;  // "camera", "reflected", …
  kernel::vec3 o{0};
  kernel::vec3 d{0};
  float length = 0;                // as far as it went; infinite if it met nothing
  std::vector<std::string> media;  // the objects that it runs in, outermost first
  kernel::Spectrum weight{0};      // what light counts in the pixel that its end sends back
  std::optional<Surface> surface;  // none: it left the scene, or a medium scattered it
  bool scattered = false;          // by a medium
  std::vector<TextureRead> reads;
  std::vector<std::string> notes;  // what else happened at its end
  std::vector<LightTry> lights;
  std::optional<Way> way;
  std::vector<int> terms;  // that were found at its end
};

// Something that was added to the sample.
struct Contribution {
  kernel::Spectrum L{0};
  std::string source;  // "the light 'lamp'", "the background", …
  bool held = false;   // a limit to indirect light has made it less
  int ray = 0;         // at whose end
};

struct Explanation {
  std::string scene;
  std::string integrator;
  int width = 0;
  int height = 0;
  int x = 0;
  int y = 0;
  std::uint32_t sample = 0;
  kernel::Spectrum radiance{0};  // as a render has it: the terms' sum in their order, to the bit
  std::vector<Segment> rays;     // the first is the camera's
  std::vector<Contribution> terms;
};

// As a tree to read in a terminal,
std::string ToText(const Explanation& explanation);
// as data,
std::string ToJson(const Explanation& explanation);
// as a drawing from above and from the side,
std::string ToSvg(const Explanation& explanation);
// and as lines that a viewer of glTF shows over the scene; coloured by kind.
std::string ToGltf(const Explanation& explanation);

}  // namespace snell::explain
