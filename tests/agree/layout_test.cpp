// SPDX-License-Identifier: Apache-2.0
//
// The records of src/kernel/types.h as glslc lays them out in buffers against C++'s layout: every member's
// name, type and offset, and the distance between elements of arrays, read back from the SPIR-V.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <set>

#include "agree/spirv.h"
#include "gpu/records.h"
#include "kernel/aov.h"
#include "kernel/types.h"

namespace snell::agree {

namespace {

using namespace kernel;

// What GLSL calls a type.
template <class T>
const char* NameInGlsl();

#define SNELL_GLSL_NAME(type)      \
  template <>                      \
  const char* NameInGlsl<type>() { \
    return #type;                  \
  }
SNELL_GLSL_NAME(float)
SNELL_GLSL_NAME(int)
SNELL_GLSL_NAME(uint)
SNELL_GLSL_NAME(vec2)
SNELL_GLSL_NAME(vec3)
SNELL_GLSL_NAME(uvec2)
SNELL_GLSL_NAME(uvec3)
SNELL_GLSL_NAME(Camera)
SNELL_GLSL_NAME(ColorSource)
SNELL_GLSL_NAME(ScalarSource)
SNELL_GLSL_NAME(Environment)
SNELL_GLSL_NAME(Medium)
SNELL_GLSL_NAME(RayCounts)
SNELL_GLSL_NAME(TraceTree)
SNELL_GLSL_NAME(Transform)
#undef SNELL_GLSL_NAME
template <>
const char* NameInGlsl<float[FilterQuantileCount]>() {
  static const std::string name = fmt::format("float[{}]", FilterQuantileCount);
  return name.c_str();
}

template <>
const char* NameInGlsl<Spectrum[MaxLightGroups]>() {
  return "vec3[16]";
}

template <>
const char* NameInGlsl<uint[RoleCount]>() {
  return "uint[26]";
}

template <>
const char* NameInGlsl<uint[12]>() {
  return "uint[12]";
}
template <>
const char* NameInGlsl<uint[8]>() {
  return "uint[8]";
}

struct Record {
  std::size_t size;
  std::vector<SpirvMember> members;
};

#define MEMBER(type, member) \
  SpirvMember { #member, NameInGlsl < decltype(type::member)>(), offsetof(type, member) }

// What C++ makes of the records that stand in buffers.
std::map<std::string, Record> RecordsInCpp() {
  return {
      {"Transform",
       {sizeof(Transform),
        {MEMBER(Transform, x), MEMBER(Transform, y), MEMBER(Transform, z),
         MEMBER(Transform, origin), MEMBER(Transform, rowX), MEMBER(Transform, rowY),
         MEMBER(Transform, rowZ)}}},
      {"ColorSource",
       {sizeof(ColorSource), {MEMBER(ColorSource, value), MEMBER(ColorSource, texture)}}},
      {"Object",
       {sizeof(Object),
        {MEMBER(Object, material), MEMBER(Object, mask), MEMBER(Object, light),
         MEMBER(Object, motion), MEMBER(Object, motionSteps), MEMBER(Object, toWorld),
         MEMBER(Object, emitters)}}},
      {"MotionKey",
       {sizeof(MotionKey),
        {MEMBER(MotionKey, x), MEMBER(MotionKey, y), MEMBER(MotionKey, z),
         MEMBER(MotionKey, origin)}}},
      {"Shape",
       {sizeof(Shape),
        {MEMBER(Shape, kind), MEMBER(Shape, object), MEMBER(Shape, mapped), MEMBER(Shape, a),
         MEMBER(Shape, b), MEMBER(Shape, c), MEMBER(Shape, toWorld)}}},
      {"Triangle",
       {sizeof(Triangle),
        {MEMBER(Triangle, v0), MEMBER(Triangle, v1), MEMBER(Triangle, v2),
         MEMBER(Triangle, mesh)}}},
      {"Mesh",
       {sizeof(Mesh),
        {MEMBER(Mesh, object), MEMBER(Mesh, normals), MEMBER(Mesh, uvs), MEMBER(Mesh, uvs1),
         MEMBER(Mesh, tangents), MEMBER(Mesh, colors), MEMBER(Mesh, steps), MEMBER(Mesh, stride)}}},
      {"Instance",
       {sizeof(Instance),
        {MEMBER(Instance, object), MEMBER(Instance, root), MEMBER(Instance, firstTriangle),
         MEMBER(Instance, triangleCount), MEMBER(Instance, toWorld)}}},
      {"Texture",
       {sizeof(Texture),
        {MEMBER(Texture, kind), MEMBER(Texture, space), MEMBER(Texture, colorA),
         MEMBER(Texture, colorB), MEMBER(Texture, turbulence), MEMBER(Texture, octaves),
         MEMBER(Texture, smoothEdges), MEMBER(Texture, toSpace), MEMBER(Texture, image),
         MEMBER(Texture, uvSet), MEMBER(Texture, wrapU), MEMBER(Texture, wrapV),
         MEMBER(Texture, lookup), MEMBER(Texture, texelDensity)}}},
      {"Image",
       {sizeof(Image),
        {MEMBER(Image, firstWord), MEMBER(Image, encoding), MEMBER(Image, width),
         MEMBER(Image, height), MEMBER(Image, levels)}}},
      {"ScalarSource",
       {sizeof(ScalarSource), {MEMBER(ScalarSource, value), MEMBER(ScalarSource, channel)}}},
      {"Physical",
       {sizeof(Physical),
        {MEMBER(Physical, baseColor),
         MEMBER(Physical, metalness),
         MEMBER(Physical, specularWeight),
         MEMBER(Physical, specularColor),
         MEMBER(Physical, roughness),
         MEMBER(Physical, transmission),
         MEMBER(Physical, transmissionColor),
         MEMBER(Physical, coatWeight),
         MEMBER(Physical, coatRoughness),
         MEMBER(Physical, coatIor),
         MEMBER(Physical, fuzzWeight),
         MEMBER(Physical, fuzzColor),
         MEMBER(Physical, fuzzRoughness),
         MEMBER(Physical, diffuseRoughness),
         MEMBER(Physical, anisotropy),
         MEMBER(Physical, anisotropyModel),
         MEMBER(Physical, anisotropyMapped),
         MEMBER(Physical, anisotropyAxis),
         MEMBER(Physical, coatColor),
         MEMBER(Physical, coatDarkening),
         MEMBER(Physical, coatAnisotropy),
         MEMBER(Physical, coatNormalScale),
         MEMBER(Physical, filmWeight),
         MEMBER(Physical, filmThickness),
         MEMBER(Physical, filmThicknessLeast),
         MEMBER(Physical, filmIor),
         MEMBER(Physical, diffuseTransmission),
         MEMBER(Physical, diffuseTransmissionColor),
         MEMBER(Physical, metalColor),
         MEMBER(Physical, subsurface),
         MEMBER(Physical, subsurfaceColor),
         MEMBER(Physical, subsurfaceExtinction),
         MEMBER(Physical, subsurfaceAnisotropy),
         MEMBER(Physical, tintByBase),
         MEMBER(Physical, metalByBase)}}},
      {"Medium",
       {sizeof(Medium),
        {MEMBER(Medium, extinction), MEMBER(Medium, scattering), MEMBER(Medium, emission),
         MEMBER(Medium, anisotropy), MEMBER(Medium, grid)}}},
      {"Grid",
       {sizeof(Grid),
        {MEMBER(Grid, toObject), MEMBER(Grid, bricks), MEMBER(Grid, firstWord),
         MEMBER(Grid, greatest)}}},
      {"Term",
       {sizeof(Term),
        {MEMBER(Term, kind), MEMBER(Term, normalized), MEMBER(Term, exponent),
         MEMBER(Term, color)}}},
      {"Material",
       {sizeof(Material), {MEMBER(Material, lightGroup),   MEMBER(Material, firstTerm),
                           MEMBER(Material, termCount),    MEMBER(Material, reflection),
                           MEMBER(Material, refractive),   MEMBER(Material, thin),
                           MEMBER(Material, priority),     MEMBER(Material, ior),
                           MEMBER(Material, dispersion),   MEMBER(Material, inside),
                           MEMBER(Material, container),    MEMBER(Material, emission),
                           MEMBER(Material, reflectivity), MEMBER(Material, transparency),
                           MEMBER(Material, physical),     MEMBER(Material, closure),
                           MEMBER(Material, textured),     MEMBER(Material, textures),
                           MEMBER(Material, singleSided),  MEMBER(Material, alphaMode),
                           MEMBER(Material, opacity),      MEMBER(Material, alphaCutoff),
                           MEMBER(Material, normalScale),  MEMBER(Material, bumpMap),
                           MEMBER(Material, bumpScale)}}},
      {"Light",
       {sizeof(Light),
        {MEMBER(Light, kind),      MEMBER(Light, group),       MEMBER(Light, falloff),
         MEMBER(Light, samples),   MEMBER(Light, emission),    MEMBER(Light, position),
         MEMBER(Light, direction), MEMBER(Light, edgeU),       MEMBER(Light, edgeV),
         MEMBER(Light, radius),    MEMBER(Light, area),        MEMBER(Light, cosInner),
         MEMBER(Light, cosOuter),  MEMBER(Light, oneMinusCos), MEMBER(Light, factor),
         MEMBER(Light, range),     MEMBER(Light, found),       MEMBER(Light, nextSun),
         MEMBER(Light, node),      MEMBER(Light, next),        MEMBER(Light, profile)}}},
      {"Emitter",
       {sizeof(Emitter),
        {MEMBER(Emitter, primitive), MEMBER(Emitter, instance), MEMBER(Emitter, node),
         MEMBER(Emitter, area)}}},
      {"LightNode",
       {sizeof(LightNode),
        {MEMBER(LightNode, center), MEMBER(LightNode, radius), MEMBER(LightNode, axis),
         MEMBER(LightNode, cosThetaO), MEMBER(LightNode, cosThetaE), MEMBER(LightNode, power),
         MEMBER(LightNode, reach), MEMBER(LightNode, flags), MEMBER(LightNode, first),
         MEMBER(LightNode, parent)}}},
      {"Environment",
       {sizeof(Environment),
        {MEMBER(Environment, bottom), MEMBER(Environment, top), MEMBER(Environment, sinBottom),
         MEMBER(Environment, sinTop), MEMBER(Environment, ior), MEMBER(Environment, group),
         MEMBER(Environment, visible), MEMBER(Environment, map), MEMBER(Environment, scale),
         MEMBER(Environment, turn), MEMBER(Environment, dull), MEMBER(Environment, density),
         MEMBER(Environment, share), MEMBER(Environment, tables), MEMBER(Environment, firstSun)}}},
      {"Camera",
       {sizeof(Camera),
        {MEMBER(Camera, kind), MEMBER(Camera, inside), MEMBER(Camera, resolution),
         MEMBER(Camera, position), MEMBER(Camera, right), MEMBER(Camera, up),
         MEMBER(Camera, forward), MEMBER(Camera, extent), MEMBER(Camera, center),
         MEMBER(Camera, rim), MEMBER(Camera, aperture), MEMBER(Camera, focus),
         MEMBER(Camera, blades), MEMBER(Camera, bladeAngle), MEMBER(Camera, motion),
         MEMBER(Camera, motionSteps)}}},
      {"RenderParams",
       {sizeof(RenderParams),
        {MEMBER(RenderParams, camera),
         MEMBER(RenderParams, environment),
         MEMBER(RenderParams, ambient),
         MEMBER(RenderParams, ambientByGroup),
         MEMBER(RenderParams, aovs),
         MEMBER(RenderParams, lightCount),
         MEMBER(RenderParams, lightNodeCount),
         MEMBER(RenderParams, firstDirectional),
         MEMBER(RenderParams, lightSampling),
         MEMBER(RenderParams, tintedShadows),
         MEMBER(RenderParams, maxDepth),
         MEMBER(RenderParams, moving),
         MEMBER(RenderParams, maxVolumeDepth),
         MEMBER(RenderParams, maxDiffuseDepth),
         MEMBER(RenderParams, maxSpecularDepth),
         MEMBER(RenderParams, maxTransmissionDepth),
         MEMBER(RenderParams, caustics),
         MEMBER(RenderParams, surroundings),
         MEMBER(RenderParams, minContribution),
         MEMBER(RenderParams, clampIndirect),
         MEMBER(RenderParams, seed),
         MEMBER(RenderParams, independentSamples),
         MEMBER(RenderParams, samplesLog2),
         MEMBER(RenderParams, coneWidth),
         MEMBER(RenderParams, coneSpread),
         MEMBER(RenderParams, filterQuantiles)}}},
      {"AovSample",
       {sizeof(AovSample),
        {MEMBER(AovSample, start), MEMBER(AovSample, seen), MEMBER(AovSample, object),
         MEMBER(AovSample, depth), MEMBER(AovSample, position), MEMBER(AovSample, uv),
         MEMBER(AovSample, described), MEMBER(AovSample, albedo), MEMBER(AovSample, normal),
         MEMBER(AovSample, group), MEMBER(AovSample, direct), MEMBER(AovSample, groups)}}},
      {"TraceNode",
       {sizeof(TraceNode),
        {MEMBER(TraceNode, origin), MEMBER(TraceNode, exponents), MEMBER(TraceNode, planes),
         MEMBER(TraceNode, child)}}},
      {"TraceTriangle",
       {sizeof(TraceTriangle),
        {MEMBER(TraceTriangle, v0), MEMBER(TraceTriangle, v1), MEMBER(TraceTriangle, v2),
         MEMBER(TraceTriangle, index), MEMBER(TraceTriangle, mask)}}},
      {"TraceTree",
       {sizeof(TraceTree),
        {MEMBER(TraceTree, root), MEMBER(TraceTree, instance), MEMBER(TraceTree, mask),
         MEMBER(TraceTree, slack)}}},
      {"TraceWorld",
       {sizeof(TraceWorld), {MEMBER(TraceWorld, tree), MEMBER(TraceWorld, unboundedCount)}}},
      {"SampleRequest",
       {sizeof(SampleRequest), {MEMBER(SampleRequest, pixel), MEMBER(SampleRequest, index)}}},
      {"RayCounts",
       {sizeof(RayCounts),
        {MEMBER(RayCounts, camera), MEMBER(RayCounts, reflected), MEMBER(RayCounts, refracted),
         MEMBER(RayCounts, shadow)}}},
      {"SampleResult",
       {sizeof(SampleResult),
        {MEMBER(SampleResult, L), MEMBER(SampleResult, held), MEMBER(SampleResult, rays),
         MEMBER(SampleResult, dropped)}}},
      {"vec2", {sizeof(vec2), {}}},
      {"vec3", {sizeof(vec3), {}}},
      {"vec4", {sizeof(vec4), {}}},
      {"uint", {sizeof(uint), {}}},
      {"float", {sizeof(float), {}}},
  };
}

#undef MEMBER

// The same list as text, which a failure shows whole.
std::string Describe(const std::vector<SpirvMember>& members) {
  std::string text;
  for (const SpirvMember& member : members)
    text += fmt::format("{:4} {} {}\n", member.offset, member.type, member.name);
  return text;
}

SpirvLayouts WhittedLayouts() { return ReadLayouts(ReadSpirv(SNELL_WHITTED_SPIRV)); }

TEST(Layout, MembersStandWhereCppPutsThem) {
  std::map<std::string, Record> records = RecordsInCpp();
  std::size_t found = 0;
  for (const SpirvStruct& record : WhittedLayouts().structs) {
    if (record.block) continue;
    ASSERT_TRUE(records.contains(record.name)) << record.name << " is not in this test's table";
    EXPECT_EQ(Describe(record.members), Describe(records[record.name].members)) << record.name;
    ++found;
  }
  EXPECT_GE(found, records.size() - 5) << "the shader's buffers lack a record of the table";
}

TEST(Layout, ElementsFollowAtTheSizeOfTheRecord) {
  std::map<std::string, Record> records = RecordsInCpp();
  std::set<std::string> elements;
  for (const SpirvRuntimeArray& array : WhittedLayouts().arrays) {
    ASSERT_TRUE(records.contains(array.element)) << array.element;
    EXPECT_EQ(array.stride, records[array.element].size) << array.element;
    elements.insert(array.element);
  }
  EXPECT_EQ(elements.size(), 26u) << "kinds of arrays in src/gpu/shaders/buffers.glsl";
}

TEST(Layout, BuffersBeginWithTheirContent) {
  for (const SpirvStruct& block : WhittedLayouts().structs) {
    if (!block.block) continue;
    ASSERT_EQ(block.members.size(), 1u) << block.name;
    EXPECT_EQ(block.members[0].offset, 0u) << block.name;
  }
}

}  // namespace

}  // namespace snell::agree
