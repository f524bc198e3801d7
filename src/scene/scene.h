// SPDX-License-Identifier: Apache-2.0
//
// The scene as plain records and indices: what a file says, after names have been resolved and before any
// device has prepared it. Readers fill it (src/io), validation checks it (validate.h), devices flatten it
// (src/cpu/flatten.h). Units and spaces: docs/conventions.md. Records copy and compare for nothing; a
// Scene owns all that it refers to.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "image/view.h"
#include "kernel/types.h"
#include "scene/aov.h"
#include "scene/grid.h"
#include "scene/light_profile.h"
#include "scene/material.h"
#include "util/error.h"

namespace snell::scene {

using kernel::uvec3;
using kernel::vec2;
using kernel::vec3;
using kernel::vec4;

// --- Lights ---------------------------------------------------------------------------------------------

enum class LightKind { Ambient, Directional, Point, Spot, Rectangle, Triangle, Disk, Sphere };
enum class Falloff { None, Linear, InverseSquare };

struct Light {
  std::string name;
  LightKind kind = LightKind::Point;
  std::string group;  // of sources whose light a picture tells apart; "": none
  Spectrum color{1.0f};
  // W/sr (point, spot), W/m² facing the light (directional), W/(sr·m²) (ambient and areas)
  float strength = 1;
  Falloff falloff = Falloff::InverseSquare;
  float falloffFactor = 1;  // linear: irradiance = intensity / (distance · factor)
  float range = 0;          // metres, 0 = unlimited
  int samples = 4;          // shadow rays per camera sample, for lights with an extent
  // Areas are seen by the camera and in mirrors; so is the disc of a directional light, but, unless it is the
  // sun of a sky, not by the classic integrator
  bool visible = true;
  vec3 position{0.0f};  // point, spot; centre of disk and sphere; corner of rectangle and triangle
  vec3 direction{0, -1, 0};  // that the light travels in; the normal of disk; unit length
  vec3 edgeU{1, 0, 0};       // rectangle and triangle; their normal is U × V
  vec3 edgeV{0, 0, -1};
  float radius = 0;      // disk, sphere; point and spot: makes their shadows soft
  float innerAngle = 0;  // spot: half angles from the axis, radians
  float outerAngle = 0;
  float angularSize = 0;  // directional: diameter as seen from the scene, radians
  // Point, spot: how it shines by direction; −1: evenly. With one, `strength` is the greatest intensity, `direction` has
  // the vertical angle 0, and edgeU and edgeV are the horizontal angles 0 and 90°
  int profile = -1;
};

// --- Geometry -------------------------------------------------------------------------------------------

struct Sphere {
  vec3 center{0.0f};
  float radius = 1;
};
struct Plane {  // infinite
  vec3 point{0.0f};
  vec3 normal{0, 1, 0};
};
struct Disk {
  vec3 center{0.0f};
  vec3 normal{0, 1, 0};
  float radius = 1;
  float innerRadius = 0;
};
struct Rectangle {  // a parallelogram; the normal is U × V
  vec3 corner{-0.5f, 0, 0.5f};
  vec3 edgeU{1, 0, 0};
  vec3 edgeV{0, 0, -1};
};
struct Box {
  vec3 lower{-1.0f};
  vec3 upper{1.0f};
};
struct Cone {  // a cylinder if the radii are equal
  vec3 base{0.0f};
  vec3 top{0, 1, 0};
  float radius = 1;
  float topRadius = 0;
  bool capped = true;
};
struct Torus {
  vec3 center{0.0f};
  vec3 axis{0, 1, 0};
  float majorRadius = 1;
  float minorRadius = 0.25f;
};
struct MeshGeometry {
  MeshIndex mesh = -1;
};

using Geometry = std::variant<Sphere, Plane, Disk, Rectangle, Box, Cone, Torus, MeshGeometry>;

enum class SubdivisionScheme { None, CatmullClark, Loop };

// How the limit surface meets the mesh's boundary: not at all, in a smooth curve, or in one that goes through
// the corners.
enum class SubdivisionBoundary { None, EdgeOnly, EdgeAndCorner };

// The mesh stands for the smooth surface that repeated cutting of its faces leads to (src/tessellate).
struct Subdivision {
  SubdivisionScheme scheme = SubdivisionScheme::None;
  SubdivisionBoundary boundary = SubdivisionBoundary::EdgeAndCorner;
  int levels = 2;          // each cuts a face in four; without a target
  EdgeTarget target = {};  // finds the levels

  bool operator==(const Subdivision&) const = default;
};

// An edge of a subdivided mesh that stays sharp, or a corner if its ends are the same: fully from 10 on, for so
// many levels below. The ends are places, for any number of vertices may lie there.
struct Crease {
  vec3 from{0.0f};
  vec3 to{0.0f};
  float sharpness = 10;
};

// Where a mesh's vertices are at a moment of the scene's time, in seconds.
struct MeshKey {
  double time = 0;
  std::vector<vec3> positions;
  std::vector<vec3> normals;   // empty or one for each, as the mesh's
  std::vector<vec4> tangents;  // the same
};

// Triangles over shared vertices. Positions to colours, all but the first are empty or have an entry per position.
// Vertices count counter-clockwise seen from outside; normals, where given, say themselves which side is
// outside. In `uvs`, (0, 0) is a picture's lower left corner. A tangent's w is the sign of the bitangent:
// cross(normal, tangent) · w. Colours are linear and multiply a physical material's base colour, their w its opacity.
struct Mesh {
  std::string name;
  std::vector<vec3> positions;
  std::vector<vec3> normals;
  std::vector<vec2> uvs;
  std::vector<vec2> uvs1;  // the second set
  std::vector<vec4> tangents;
  std::vector<vec4> colors;
  std::vector<uvec3> triangles;
  std::vector<bool>
      joins;  // whether a triangle and the one before it are of one polygon; empty: none
  std::vector<Crease> creases;
  // A mesh that changes its shape has positions, normals and tangents as they are at `time`, and as they are later, by
  // rising time. In between they change evenly; before the first and after the last key they rest (deformation.h)
  double time = 0;
  std::vector<MeshKey> keys;
};

// Where something is at a moment of the scene's time, in seconds.
struct MotionKey {
  double time = 0;
  Affine place{1.0};
};
// By rising time; none: it stands still. Before the first and after the last key it rests. motion.h interpolates.
using Motion = std::vector<MotionKey>;

// One thing in the world. Objects that share a mesh are instances of it.
struct Object {
  std::string name;
  Geometry geometry;
  MaterialIndex material = -1;
  Affine toWorld{1.0};      // where it stands, or begins to move
  Motion motion;            // takes the place of toWorld while the shutter is open
  Subdivision subdivision;  // of meshes
  bool visibleToCamera = true;
  bool visibleToSecondary = true;  // in mirrors and through glass
  bool castsShadow = true;
  Place place;  // in the file it comes from, for messages
};

// --- Camera, surroundings, settings ---------------------------------------------------------------------

enum class CameraKind { Pinhole, Orthographic, Panorama, Fisheye };
enum class FovAxis { Vertical, Horizontal };

// How far from the middle a fisheye shows what is at the angle θ from its axis.
enum class FisheyeProjection {
  Equidistant,    // θ
  Equisolid,      // 2 sin(θ/2)
  Stereographic,  // 2 tan(θ/2)
};

// A thin lens behind an aperture; of pinhole and orthographic cameras.
struct Lens {
  float radius = 0;         // of the aperture, metres; 0: everything is sharp
  float focusDistance = 0;  // along the line of sight, metres
  int blades = 0;           // corners of the aperture, at its radius; 0: it is round
  float bladeRotation =
      0;            // counter-clockwise seen from behind the camera, radians; 0: a corner is on top
  float ratio = 1;  // the aperture's width to its height
};

struct Camera {
  std::string name;
  CameraKind kind = CameraKind::Pinhole;
  vec3 position{0, 0, 5};
  vec3 lookAt{0.0f};
  vec3 up{0, 1, 0};
  float fov = 0.698f;  // pinhole: angle of view; fisheye: across its circle; radians
  FovAxis fovAxis = FovAxis::Vertical;  // pinhole
  float height = 2;                     // orthographic: height of the view, metres
  vec2 shift{0.0f};  // pinhole, orthographic: of the picture's middle, in its widths and heights
  // Panorama: what its left and right edges show, radians to the right of the line of sight, and its lower and
  // upper edges, radians above it
  vec2 longitude{-3.14159265f, 3.14159265f};
  vec2 latitude{-1.57079633f, 1.57079633f};
  FisheyeProjection projection = FisheyeProjection::Equidistant;
  bool fullFrame =
      false;  // fisheye: its circle goes through the corners; else it touches the longer sides
  Lens lens;
  double shutterOpen = 0;  // seconds of the scene's time
  double shutterClose = 0;
  Motion
      motion;  // of its frame: x to the right, y up, z backwards; takes the place of position, lookAt and up
};

// What is seen behind everything, and the index of refraction of the space around the objects.
struct Environment {
  Spectrum bottom{0.0f};
  Spectrum top{0.0f};
  float bottomElevation = -1.5707963f;  // radians; the colour is `bottom` below and `top` above
  float topElevation = 1.5707963f;
  float ior = 1;
  ImageIndex map = -1;          // of all directions (kernel/environment.h), in place of the colours
  Spectrum mapScale{1.0f};      // W/(sr·m²) of its 1
  float rotation = 0;           // of the map: radians about +y, counter-clockwise from above
  int sun = -1;                 // the light that is the sun of a sky; -1: none
  bool visible = true;          // to the camera; mirrors show it in any case
  bool ambient = false;         // its mean is ambient light to the classic integrator
  Medium medium = {};           // around all objects
  std::string lightGroup = {};  // as Light::group
};

enum class Integrator { Whitted, Path };
enum class Sampler { Sobol, Independent };  // of the path tracer
// How the path tracer chooses among sources of light: by what each can bring to the point, or by power alone.
enum class LightSampling { Tree, Power };
// What the path tracer shows of light that mirrors and glass throw onto rough surfaces: all of it, with much noise; with
// them blurred, for little noise and some error; or nothing.
enum class Caustics { Full, Regularized, None };
enum class PixelFilter { Box, Tent, Gaussian, BlackmanHarris };

// What a file may say about how it wants to be rendered; the command line overrides it.
struct RenderSettings {
  static constexpr int Unlimited = std::numeric_limits<int>::max();

  int width = 800;
  int height = 600;
  // What is left open is filled in by the materials (settings.h)
  int spp = 0;  // samples per pixel; 0: open
  std::optional<Integrator> integrator;
  int maxDepth = 16;          // 1: rays from the camera only
  int maxVolumeDepth = 1024;  // scatterings in media along a path
  // Reflections of a kind along a path, and passages through surfaces
  int maxDiffuseDepth = Unlimited;
  int maxSpecularDepth = Unlimited;
  int maxTransmissionDepth = Unlimited;
  Caustics caustics = Caustics::Full;
  float minContribution = 0.002f;  // of a branch to the pixel, below which it is cut
  Sampler sampler = Sampler::Sobol;
  float clampIndirect =
      0;  // path: the most that one find of indirect light adds, W/(sr·m²); 0: any
  PixelFilter filter = PixelFilter::BlackmanHarris;
  float filterRadius = 0;                // pixels; 0: the filter's usual one
  float exposure = 0;                    // stops, for pictures that are not linear
  image::View view = image::View::Srgb;  // of the same
  bool denoise = false;                  // keep what a denoiser wants to know
  bool tintedShadows = true;
  LightSampling lightSampling = LightSampling::Tree;
  std::uint32_t seed = 0;
  AovSet aovs;
};

struct Scene {
  std::string name;  // for messages and metadata: the file's name
  RenderSettings settings;
  std::vector<Camera> cameras;  // the first one is the default; empty: frame everything
  Environment environment;
  std::vector<Light> lights;
  std::vector<Image> images;
  std::vector<Texture> textures;
  std::vector<Material> materials;
  std::vector<DensityGrid> grids;
  std::vector<LightProfile> profiles;
  std::vector<Mesh> meshes;
  std::vector<Object> objects;
};

}  // namespace snell::scene
