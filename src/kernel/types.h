// SPDX-License-Identifier: Apache-2.0
//
// Every record that crosses from the host to a device, and the records that the kernel passes about. All
// fields are 32 bits wide or vectors of such, so that C++'s layout and Vulkan's scalar block layout agree
// (tests/agree reads the layout back from the SPIR-V). Units: docs/conventions.md.
//
// Longer than 400 lines because a reader of buffers wants all records in one place.
#ifndef SNELL_KERNEL_TYPES_H
#define SNELL_KERNEL_TYPES_H

#include "kernel/dialect.h"

KERNEL_BEGIN

// An affine map with its inverse. A point p maps to x·p.x + y·p.y + z·p.z + origin; a world point q maps
// back to the dots of the rows with (q − origin), which loses no precision far from the world's origin.
struct Transform {
  vec3 x;
  vec3 y;
  vec3 z;
  vec3 origin;
  vec3 rowX;
  vec3 rowY;
  vec3 rowZ;
};

struct Ray {
  vec3 o;
  vec3 d;      // need not have unit length
  float time;  // when it looks: 0 as the shutter opens, 1 as it closes
};

// Where something is at one of several moments that follow each other evenly while the shutter is open: the columns of
// an affine map. In between, the map changes linearly. Of a camera: right, up, forward and its position.
struct MotionKey {
  vec3 x;
  vec3 y;
  vec3 z;
  vec3 origin;
};

// Which rays see an object; bits of Object::mask.
CONST uint MASK_CAMERA = 1u;     // rays from the camera
CONST uint MASK_SECONDARY = 2u;  // reflected and refracted rays
CONST uint MASK_SHADOW = 4u;     // shadow rays: the object blocks all light
CONST uint MASK_TINT = 8u;       // shadow rays: the object lets some light through
CONST uint MASK_INSIDE = 16u;    // the search for what a point is inside of
CONST uint MASK_ALL = 31u;

// What the primitives of one [[object]] share.
struct Object {
  uint material;
  uint mask;
  uint light;        // the area light that this surface is, or None
  uint motion;       // its first key, whose maps take the place of toWorld; None: it stands still
  uint motionSteps;  // between keys
  Transform toWorld;
  uint emitters;  // if it glows: this and a primitive's index give its emitter
};

CONST uint SHAPE_SPHERE = 0u;  // radius a around the origin of toWorld, whose axes are a rotation
CONST uint SHAPE_ELLIPSOID = 1u;  // the unit sphere
CONST uint SHAPE_PLANE = 2u;      // y = 0, normal +y
CONST uint SHAPE_DISK = 3u;       // y = 0, outer radius 1, inner radius a
CONST uint SHAPE_RECTANGLE = 4u;  // y = 0, x and −z in [0, 1]
CONST uint SHAPE_BOX = 5u;        // [−1, 1]³
CONST uint SHAPE_FRUSTUM = 6u;  // around +y, radius a at y = 0 and b at y = c; closed by two disks
CONST uint SHAPE_TUBE = 7u;     // a frustum without the disks
CONST uint SHAPE_TORUS = 8u;    // around +y, radius a to the middle of a tube of radius b

// An analytic shape in its own space. If its object moves, `toWorld` leads to the object's space only.
struct Shape {
  uint kind;
  uint object;
  uint mapped;  // 1: textures ask for its coordinates; 0: these, and tangents, may be left 0
  float a;
  float b;
  float c;
  Transform toWorld;
};

struct Triangle {
  uint v0;  // indices into the positions
  uint v1;
  uint v2;
  uint mesh;
};

// What the triangles of one mesh share.
struct Mesh {
  uint object;   // for a mesh in world space; instances name their own
  uint normals;  // added to a vertex's index gives its normal's; None: flat
  uint uvs;      // the same for its texture coordinates
  uint uvs1;     // for its second set of them
  uint tangents;
  uint colors;
  uint steps;   // between the keys of its shape while the shutter is open; 0: it keeps its shape
  uint stride;  // from a vertex to the same one at the next key: of positions, normals, tangents
};

// A mesh in its own space, placed in the world; if its object moves, by the object's motion.
struct Instance {
  uint object;
  uint root;  // of the mesh in the device's search structure
  uint firstTriangle;
  uint triangleCount;
  Transform toWorld;
};

// What a device's search for the nearest surface returns: ids only. `instance` is INSTANCE_SHAPE for an
// analytic shape (`primitive` is its index), None for a triangle in world space, else an instance's index.
CONST uint INSTANCE_SHAPE = 0xfffffffeu;
struct Hit {
  uint primitive;  // None: nothing was hit
  uint instance;
};

// A colour or a texture of colours.
struct ColorSource {
  Spectrum value;
  uint texture;  // None: the value holds everywhere; else it multiplies the texture
};

// A number, times one channel of a texture.
struct ScalarSource {
  float value;
  uint channel;  // 0 red … 3 alpha
};

CONST uint TEXTURE_CHECKER = 0u;
CONST uint TEXTURE_STRIPES = 1u;
CONST uint TEXTURE_GRADIENT = 2u;
CONST uint TEXTURE_MARBLE = 3u;
CONST uint TEXTURE_WOOD = 4u;
CONST uint TEXTURE_IMAGE = 5u;

CONST uint SPACE_UV = 0u;
CONST uint SPACE_OBJECT = 1u;
CONST uint SPACE_WORLD = 2u;

CONST uint WRAP_REPEAT = 0u;
CONST uint WRAP_CLAMP = 1u;
CONST uint WRAP_MIRROR = 2u;

CONST uint LOOKUP_NEAREST = 0u;
CONST uint LOOKUP_LINEAR = 1u;
CONST uint LOOKUP_MIPMAP = 2u;

struct Texture {
  uint kind;
  uint space;
  Spectrum colorA;
  Spectrum colorB;
  float turbulence;   // how far noise moves the pattern
  uint octaves;       // of the noise
  uint smoothEdges;   // 1: a soft transition between the colours, 0: a sharp one
  Transform toSpace;  // places the pattern in its space; the kernel uses the inverse
  uint image;
  uint uvSet;  // 0 or 1
  uint wrapU;
  uint wrapV;
  uint lookup;
  float texelDensity;  // texels along one unit of uv space
};

CONST uint IMAGE_BYTES = 0u;   // a word a texel, red in the lowest byte
CONST uint IMAGE_SRGB = 1u;    // the same, with red, green and blue encoded
CONST uint IMAGE_FLOATS = 2u;  // four words a texel

// A picture with its levels of detail (scene_image.h).
struct Image {
  uint firstWord;
  uint encoding;
  uint width;
  uint height;
  uint levels;
};

CONST uint TERM_AMBIENT = 0u;
CONST uint TERM_DIFFUSE = 1u;
CONST uint TERM_PHONG = 2u;
CONST uint TERM_BLINN = 3u;

// One shader term of a classic material's stack.
struct Term {
  uint kind;
  uint normalized;  // 1: the specular lobe is scaled to conserve energy
  float exponent;
  ColorSource color;
};

CONST uint REFLECTION_CONSTANT = 0u;  // the reflectivity at every angle
CONST uint REFLECTION_FRESNEL = 1u;   // the reflectivity times Fresnel's reflectance for the ior
CONST uint REFLECTION_SCHLICK = 2u;   // the reflectivity at normal incidence, 1 at grazing

// What a material's textures are for: the places in Material::textures.
CONST uint ROLE_OPACITY = 0u;
CONST uint ROLE_NORMAL = 1u;
CONST uint ROLE_EMISSION = 2u;
CONST uint ROLE_REFLECTIVITY = 3u;
CONST uint ROLE_TRANSPARENCY = 4u;
CONST uint ROLE_BASE_COLOR = 5u;
CONST uint ROLE_METALNESS = 6u;
CONST uint ROLE_SPECULAR_WEIGHT = 7u;
CONST uint ROLE_SPECULAR_COLOR = 8u;
CONST uint ROLE_ROUGHNESS = 9u;
CONST uint ROLE_TRANSMISSION = 10u;
CONST uint ROLE_COAT_WEIGHT = 11u;
CONST uint ROLE_COAT_ROUGHNESS = 12u;
CONST uint ROLE_FUZZ_WEIGHT = 13u;
CONST uint ROLE_FUZZ_COLOR = 14u;
CONST uint ROLE_FUZZ_ROUGHNESS = 15u;
CONST uint ROLE_ANISOTROPY = 16u;
CONST uint ROLE_TRANSMISSION_COLOR = 17u;
CONST uint ROLE_COAT_COLOR = 18u;
CONST uint ROLE_COAT_NORMAL = 19u;
CONST uint ROLE_FILM_WEIGHT = 20u;
CONST uint ROLE_FILM_THICKNESS = 21u;
CONST uint ROLE_DIFFUSE_TRANSMISSION = 22u;
CONST uint ROLE_DIFFUSE_TRANSMISSION_COLOR = 23u;
CONST uint ROLE_SUBSURFACE = 24u;
CONST uint ROLE_SUBSURFACE_COLOR = 25u;
CONST uint RoleCount = 26u;

// How roughness and anisotropy make the widths of the microfacets' normals.
CONST uint ANISOTROPY_OPENPBR = 0u;
CONST uint ANISOTROPY_GLTF = 1u;

// A physical (OpenPBR) material. The classic integrator shows a part of it (physical.h).
struct Physical {
  Spectrum baseColor;
  ScalarSource metalness;
  ScalarSource specularWeight;
  Spectrum specularColor;
  ScalarSource roughness;
  ScalarSource transmission;
  Spectrum transmissionColor;
  ScalarSource coatWeight;
  ScalarSource coatRoughness;
  float coatIor;
  ScalarSource fuzzWeight;
  Spectrum fuzzColor;
  ScalarSource fuzzRoughness;
  // What only the path tracer shows
  float diffuseRoughness;
  ScalarSource anisotropy;
  uint anisotropyModel;
  uint anisotropyMapped;  // 1: its texture's red and green are the direction, from −1 to 1
  vec2 anisotropyAxis;    // cosine and sine of the angle from the tangent to the direction
  Spectrum coatColor;     // what is left of light that crosses the coat twice, at normal incidence
  float coatDarkening;
  float coatAnisotropy;
  vec2 coatNormalScale;
  ScalarSource filmWeight;
  ScalarSource filmThickness;  // micrometres
  float filmThicknessLeast;    // where the texture is 0
  float filmIor;
  ScalarSource diffuseTransmission;
  Spectrum diffuseTransmissionColor;
  Spectrum metalColor;
  ScalarSource subsurface;
  Spectrum subsurfaceColor;
  Spectrum subsurfaceExtinction;  // per metre
  float subsurfaceAnisotropy;
  uint tintByBase;   // 1: the base's colour tints what is transmitted
  uint metalByBase;  // 1: the base colour's texture multiplies the metal's, too
};

// Densities at the points of a lattice (scene_grid.h).
struct Grid {
  Transform toObject;  // from the lattice to the space of the object that it fills
  uvec3 bricks;        // along the axes; each is of 8³ points
  uint firstWord;      // of the bricks' table, among the words of images
  float greatest;      // of all densities
};

// What fills a space. Absorbs what extinction has more than scattering.
struct Medium {
  Spectrum extinction;  // per metre
  Spectrum scattering;  // per metre
  Spectrum emission;    // W/(sr·m³)
  float anisotropy;     // the mean cosine of the angle of deflection
  uint grid;            // densities that all of it is multiplied by, or None: it is even
};

CONST uint ALPHA_OPAQUE = 0u;
CONST uint ALPHA_MASK = 1u;   // there or not
CONST uint ALPHA_BLEND = 2u;  // by parts

struct Material {
  uint lightGroup;  // of its emission
  uint firstTerm;
  uint termCount;
  uint reflection;
  uint refractive;  // 1: some light passes
  uint thin;        // 1: a sheet without inside
  int priority;     // of the inside where objects overlap; the higher wins
  float ior;        // at 587.6 nm
  float
      dispersion;  // Cauchy's B, µm²: how the index grows with the inverse square of the wavelength
  Medium inside;
  uint container;  // 1: a boundary that is not seen, around a medium
  Spectrum emission;
  Spectrum reflectivity;
  Spectrum transparency;
  uint physical;  // None: classic
  uint
      closure;  // what the path tracer takes the material for, one of the physical ones; None: black
  uint textured;             // 1: some role has a texture
  uint textures[RoleCount];  // by role; None: there is none. They multiply the values
  uint singleSided;          // 1: backs let everything pass but shadow rays
  uint alphaMode;
  ScalarSource opacity;
  float alphaCutoff;
  vec2 normalScale;
  uint bumpMap;     // a texture, or None
  float bumpScale;  // metres from black to white
};

CONST uint LIGHT_POINT = 0u;
CONST uint LIGHT_SPOT = 1u;
CONST uint LIGHT_DIRECTIONAL = 2u;
CONST uint LIGHT_RECTANGLE = 3u;
CONST uint LIGHT_TRIANGLE = 4u;
CONST uint LIGHT_DISK = 5u;
CONST uint LIGHT_SPHERE = 6u;

CONST uint FALLOFF_NONE = 0u;
CONST uint FALLOFF_LINEAR = 1u;
CONST uint FALLOFF_INVERSE_SQUARE = 2u;

// Groups of sources whose light is told apart (aov.h); 0 is of all that are in none.
CONST uint MaxLightGroups = 16u;

struct Light {
  uint kind;
  uint group;  // its light group
  uint falloff;
  uint samples;       // shadow rays per camera sample
  Spectrum emission;  // W/sr (point, spot), W/m² (directional) or W/(sr·m²) (areas)
  vec3 position;      // the centre; a corner of rectangle and triangle
  vec3 direction;     // that the light travels in; an area's normal
  vec3 edgeU;      // edges of rectangle and triangle, half-axes of a disk; of a profile, the unit
  vec3 edgeV;      // vectors to the horizontal angles 0 and 90°
  float radius;    // of a sphere, or of a point or spot light with soft shadows
  float area;      // m²; of rectangle, triangle, disk
  float cosInner;  // spot: full intensity within
  float cosOuter;  // spot: nothing outside
  float oneMinusCos;  // directional: of half its angular size
  float factor;       // of the linear falloff
  float range;        // metres; 0: unlimited
  uint found;         // 1: rays that meet its surface, or its disc, see what SampleLi samples
  uint nextSun;       // the next directional light that has a disc in the sky, or None
  uint node;          // its leaf in the light tree, or None
  uint next;          // directional: the next such light, or None
  uint profile;  // point, spot: its intensities by direction among the words of images, or None
};

// A triangle or a shape that glows, for the path tracer to sample.
struct Emitter {
  uint primitive;  // as in Hit
  uint instance;
  uint node;   // its leaf in the light tree; None: met by chance alone
  float area;  // m²; of a sphere, of its silhouette
};

CONST uint LIGHT_NODE_LEAF = 1u;
CONST uint LIGHT_NODE_TWO_SIDED = 2u;

// Sources of light that lie together, with bounds of where they are and whither they shine (light_tree.h).
struct LightNode {
  vec3 center;  // of a sphere around them
  float radius;
  vec3 axis;        // of a cone around the sources' normals,
  float cosThetaO;  // its half angle,
  float cosThetaE;  // and how far from its normal a source shines, at most 90°
  vec3 power;       // intensity, as a share of all, by falloff: none, linear, inverse square
  float reach;      // the largest range, metres; 0: unlimited
  uint flags;
  uint first;   // of its two children, which lie side by side; of a leaf: the source
  uint parent;  // of the root: 0
};

CONST uint LIGHTS_BY_TREE = 0u;
CONST uint LIGHTS_BY_POWER = 1u;

CONST uint CAUSTICS_FULL = 0u;
// Mirrors and glass that throw light onto rough surfaces are blurred, or do not.
CONST uint CAUSTICS_REGULARIZED = 1u;
CONST uint CAUSTICS_NONE = 2u;

// The background, by direction: from `bottom` to `top` over the sine of the elevation, or a map.
struct Environment {
  Spectrum bottom;
  Spectrum top;
  float sinBottom;
  float sinTop;
  float ior;       // of the space around the scene
  uint group;      // its light group
  uint visible;    // 1: rays from the camera see it
  uint map;        // a picture of all directions (environment.h), or None
  Spectrum scale;  // radiance of the map's 1, W/(sr·m²)
  float turn;      // of the map about the y axis, in whole turns, counter-clockwise from above
  float dull;      // the map's brightness that is left to chance (environment.h)
  float density;   // of sampling, per solid angle, by a weight of 1; 0: it is not sampled
  float share;     // of the samples of light that go to the map
  uint tables;     // in the texels, for sampling (scene_environment.h)
  uint firstSun;   // the first directional light that has a disc in the sky, or None
};

CONST uint CAMERA_PINHOLE = 0u;
CONST uint CAMERA_ORTHOGRAPHIC = 1u;
CONST uint CAMERA_PANORAMA = 2u;  // azimuth and elevation (equirectangular)
CONST uint CAMERA_EQUIDISTANT =
    3u;  // fisheyes: what is at the angle θ from the axis lies θ from the middle,
CONST uint CAMERA_EQUISOLID = 4u;      // 2 sin(θ/2),
CONST uint CAMERA_STEREOGRAPHIC = 5u;  // or 2 tan(θ/2)

struct Camera {
  uint kind;
  uint inside;  // 1: rays may start within refractive objects
  uvec2 resolution;
  vec3 position;
  vec3 right;  // unit vectors
  vec3 up;
  vec3 forward;
  // Half the width and height of what is seen, and its middle: of the plane at distance 1 (pinhole), in metres
  // (orthographic), in radians (panorama) or in distances from the axis (fisheyes)
  vec2 extent;
  vec2 center;
  float rim;  // fisheyes: the distance from the axis beyond which no light arrives
  // The thin lens of pinhole and orthographic cameras
  vec2 aperture;     // half its width and height, metres; 0: everything is sharp
  float focus;       // distance along `forward` of the plane that is sharp, metres
  uint blades;       // corners of the aperture, on the ellipse; 0: it is round
  float bladeAngle;  // of its first corner from `right`, radians
  uint motion;       // its first key; None: it stands still
  uint motionSteps;
};

// Entries of the pixel filter's quantile function: 32 to the octave from 2⁻²⁴ to ½, and one more.
CONST uint FilterQuantileCount = 738u;

// Everything of a render that is one value.
struct RenderParams {
  Camera camera;
  Environment environment;
  Spectrum ambient;  // sum of the ambient lights, W/(sr·m²)
  Spectrum ambientByGroup[MaxLightGroups];
  uint aovs;  // light groups, if samples tell more than their radiance (aov.h); else 0
  uint lightCount;
  uint lightNodeCount;        // 0: there is no light tree
  uint firstDirectional;      // the first directional light, or None
  uint lightSampling;         // how the path tracer chooses among the tree's sources
  uint tintedShadows;         // 1: some object is marked MASK_TINT
  uint maxDepth;              // 1: only rays from the camera
  uint moving;                // 1: something moves while the shutter is open
  uint maxVolumeDepth;        // scatterings in media along a path,
  uint maxDiffuseDepth;       // its diffuse reflections,
  uint maxSpecularDepth;      // those by mirrors, smooth or glossy,
  uint maxTransmissionDepth;  // and how often it passes through surfaces
  uint caustics;
  Medium surroundings;    // around all objects; only the path tracer shows it
  float minContribution;  // branches that can add less than this are cut
  float clampIndirect;  // the path tracer's limit to what one find of indirect light adds; 0: none
  uint seed;
  uint independentSamples;  // 1: the path tracer takes random numbers in place of a sequence
  uint
      samplesLog2;  // a power of two of samples per pixel, of which the path tracer makes one set; 0 to 20
  float coneWidth;   // of camera rays: their diameter at the start, in metres,
  float coneSpread;  // and how it grows with the distance
  float filterQuantiles[FilterQuantileCount];  // pixels; scene_filter.h
};

// The refractive objects that a point is inside of, outermost first.
CONST uint MaxNestedMedia = 8u;
struct MediumStack {
  uint count;
  uint object[8];
};

// Rays by kind, for statistics.
struct RayCounts {
  uint camera;
  uint reflected;
  uint refracted;
  uint shadow;
};

KERNEL_END

#endif
