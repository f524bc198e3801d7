// SPDX-License-Identifier: Apache-2.0
//
// How surfaces look: pictures, textures and materials, as plain records. A material is classic (terms, added)
// or physical (OpenPBR); both carry the same maps. Part of the scene (scene.h).
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "kernel/types.h"

namespace snell::scene {

using kernel::Spectrum;

// Maps an object's coordinates to the world's; double precision because transforms are nested. The last
// row is 0 0 0 1.
using Affine = glm::dmat4;

// Indices into the Scene's arrays; -1 is none.
using TextureIndex = int;
using MaterialIndex = int;
using MeshIndex = int;
using ImageIndex = int;
using GridIndex = int;

// --- Pictures and textures ------------------------------------------------------------------------------

// A picture for textures, held once however many of them show it. Rows from top to bottom; four channels
// a texel, not premultiplied.
struct Image {
  std::string name;  // of its file, for messages
  int width = 0;
  int height = 0;
  bool srgb = false;  // bytes: red, green and blue are encoded; linear otherwise
  // One of the two is filled
  std::vector<std::uint8_t> bytes;
  std::vector<float> floats;
};

enum class TextureKind { Checker, Stripes, Gradient, Marble, Wood, Image };
enum class TextureSpace { Uv, Object, World };
enum class Wrap { Repeat, Clamp, Mirror };
enum class TextureFilter { Nearest, Linear, Mipmap };

struct Texture {
  std::string name;
  TextureKind kind = TextureKind::Checker;
  TextureSpace space = TextureSpace::Uv;
  Spectrum colorA{0.1f};
  Spectrum colorB{0.9f};
  float turbulence = 0;
  int octaves = 4;
  bool smooth = false;
  // From pattern space, where one unit is one period, to `space`. Of a picture, (0, 0) is the lower left corner
  // and (1, 1) the upper right one.
  Affine placement{1.0};

  // Pictures
  ImageIndex image = -1;
  int uvSet = 0;  // which of the mesh's coordinates, 0 or 1
  Wrap wrapU = Wrap::Repeat;
  Wrap wrapV = Wrap::Repeat;
  TextureFilter filter = TextureFilter::Mipmap;
};

// A colour, or a texture multiplied by a colour.
struct ColorInput {
  Spectrum value{0.0f};
  TextureIndex texture = -1;
};

// A number, or a channel of a texture (0 red … 3 alpha) multiplied by it.
struct ScalarInput {
  float value = 0;
  TextureIndex texture = -1;
  int channel = 0;
};

// A map of normals in tangent space, or of heights.
struct ReliefMap {
  TextureIndex texture = -1;
  float scale = 1;         // normals: of x and y; heights: metres from black to white
  bool flipGreen = false;  // normals: green points down (DirectX)
};

// How long the edges of a finer mesh may be, as seen by the camera and on the surface; 0: any length.
struct EdgeTarget {
  float pixels = 0;
  float length = 0;  // metres

  bool operator==(const EdgeTarget&) const = default;
};

// Moves the surface along its normal by scale · (texture − middle). Meshes are cut into triangles with edges
// of the target's length first (src/tessellate).
struct Displacement {
  TextureIndex texture = -1;
  int channel = 0;      // of the texture, as in ScalarInput
  float scale = 0.1f;   // metres from black to white
  float middle = 0.5f;  // the value that stays where it is
  EdgeTarget target{2, 0};

  bool operator==(const Displacement&) const = default;
};

// --- Media ----------------------------------------------------------------------------------------------

// What fills a space and absorbs and scatters light.
struct Medium {
  Spectrum absorption{0.0f};  // per metre, as the next
  Spectrum scattering{0.0f};
  float density = 1;        // multiplies both, and the glow
  float anisotropy = 0;     // the mean cosine of the angle of deflection, in (−1, 1)
  Spectrum emission{0.0f};  // W/(sr·m³)
  GridIndex grid = -1;      // densities that multiply it all besides; −1: it is even
};

// --- The classic material -------------------------------------------------------------------------------

enum class TermKind { Ambient, Diffuse, Phong, Blinn };

// One shader term of a classic material.
struct Term {
  TermKind kind = TermKind::Diffuse;
  ColorInput color{Spectrum(1.0f)};
  float exponent = 32;      // of the specular terms
  bool normalized = false;  // specular: scaled to conserve energy
};

enum class ReflectionModel { Constant, Fresnel, Schlick };

// --- The physical material ------------------------------------------------------------------------------

// OpenPBR Surface 1.1 (Andersson et al. 2024) by its names and defaults.
struct OpenPbr {
  float baseWeight = 1;
  ColorInput baseColor{Spectrum(0.8f)};
  ScalarInput baseMetalness{0};
  float baseDiffuseRoughness = 0;

  ScalarInput specularWeight{1};
  ColorInput specularColor{Spectrum(1.0f)};
  ScalarInput specularRoughness{0.3f};
  float specularIor = 1.5f;
  ScalarInput specularRoughnessAnisotropy{0};
  bool anisotropyOfGltf =
      false;  // which widths roughness and anisotropy stand for (kernel/microfacet.h)
  bool anisotropyMapped = false;  // the texture's red and green are the direction, from −1 to 1
  float anisotropyRotation = 0;   // radians, from the tangent

  ScalarInput transmissionWeight{0};
  ColorInput transmissionColor{Spectrum(1.0f)};
  bool transmissionTintedByBase = false;  // glTF: the base's colour tints what passes the surface
  float transmissionDepth = 0;            // metres; 0: the colour tints the surface
  Spectrum transmissionScatter{0.0f};
  float transmissionScatterAnisotropy = 0;
  float transmissionDispersionScale = 0;
  float transmissionDispersionAbbeNumber = 20;
  ColorInput diffuseTransmissionColor{
      Spectrum(1.0f)};  // glTF; OpenPBR has it as thin-walled subsurface
  ScalarInput diffuseTransmissionWeight{0};

  ScalarInput subsurfaceWeight{0};
  ColorInput subsurfaceColor{Spectrum(0.8f)};
  float subsurfaceRadius = 1;  // metres
  Spectrum subsurfaceRadiusScale{1.0f, 0.5f, 0.25f};
  float subsurfaceScatterAnisotropy = 0;

  ScalarInput coatWeight{0};
  ColorInput coatColor{Spectrum(1.0f)};
  ScalarInput coatRoughness{0};
  float coatRoughnessAnisotropy = 0;
  float coatIor = 1.6f;
  float coatDarkening = 1;
  ReliefMap coatNormal;

  ScalarInput fuzzWeight{0};
  ColorInput fuzzColor{Spectrum(1.0f)};
  ScalarInput fuzzRoughness{0.5f};

  ScalarInput thinFilmWeight{0};
  ScalarInput thinFilmThickness{0.5f};  // micrometres
  float thinFilmThicknessLeast = 0;     // where the texture is 0
  float thinFilmIor = 1.4f;

  ColorInput emission;  // radiance, W/(sr·m²): emission_color times emission_luminance
};

enum class AlphaMode { Opaque, Mask, Blend };

// The classic material: terms, added; then reflection and refraction (kernel/interface.h has the rule). Where
// there is a physical one, it says all of this, but for what stands below it.
struct Material {
  std::string name;
  std::vector<Term> terms;
  ColorInput emission;  // radiance, W/(sr·m²)
  ColorInput reflectivity;
  ReflectionModel reflection = ReflectionModel::Constant;
  ColorInput transparency;
  float ior = 1.5f;
  bool thin = false;                // a sheet: refracts nothing and has no inside
  Spectrum attenuationColor{1.0f};  // what is left of white light after attenuationDistance
  float attenuationDistance = std::numeric_limits<float>::infinity();  // metres
  int priority = 0;  // where insides overlap, the higher one fills the space

  std::optional<OpenPbr> physical;
  std::optional<Medium> volume;  // a boundary that is not seen, around this

  // Of both kinds
  std::string lightGroup;  // of what it emits, as Light::group
  ReliefMap normalMap;
  ReliefMap bumpMap;
  Displacement displacement;
  ScalarInput opacity{1};
  AlphaMode alphaMode = AlphaMode::Opaque;  // what opacity below 1 means
  float alphaCutoff = 0.5f;                 // Mask: less is a hole
  bool doubleSided = true;                  // false: backs are holes

  bool Refractive() const {
    if (volume) return true;
    if (physical)
      return physical->transmissionWeight.value > 0 ||
             physical->diffuseTransmissionWeight.value > 0 ||
             (thin && physical->subsurfaceWeight.value > 0);
    return transparency.texture >= 0 || transparency.value != Spectrum(0.0f);
  }
};

}  // namespace snell::scene
