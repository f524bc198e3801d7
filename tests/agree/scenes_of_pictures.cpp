// SPDX-License-Identifier: Apache-2.0
//
// Pictures as textures in every encoding, wrap and filter, physical materials, and maps of opacity, normals and
// heights, on meshes with every attribute.
#include "agree/scene_builder.h"
#include "agree/scenes.h"

namespace snell::agree {

namespace {

using scene::vec2;
using scene::vec4;

// Diagonal bands of colour, with alpha that falls from left to right; sizes that are no powers of two.
scene::Image Bands(bool srgb, bool floats) {
  scene::Image image;
  image.name = "bands";
  image.width = 21;
  image.height = 13;
  image.srgb = srgb;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const int texel[4] = {(x * 37 + y * 11) % 256, (x * 5 + y * 53) % 256, (x + y) % 3 * 100,
                            255 - x * 12};
      for (const int channel : texel) {
        if (floats) {
          image.floats.push_back(float(channel) / 100.0f);
        } else {
          image.bytes.push_back(std::uint8_t(channel));
        }
      }
    }
  }
  return image;
}

scene::Texture Showing(int image, scene::Wrap wrap, scene::TextureFilter filter, int uvSet = 0) {
  scene::Texture texture;
  texture.kind = scene::TextureKind::Image;
  texture.image = image;
  texture.wrapU = wrap;
  texture.wrapV = wrap;
  texture.filter = filter;
  texture.uvSet = uvSet;
  texture.placement = Move({0.3f, -0.2f, 0}) * Turn(20, vec3(0, 0, 1)) * Scale({0.6f, 0.7f, 1});
  return texture;
}

// A sheet in the xy plane, slightly bent, with every attribute that a vertex may have.
scene::Mesh FullSheet() {
  scene::Mesh mesh;
  mesh.positions = {{-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0.1f}, {0.5f, 0.5f, 0}, {-0.5f, 0.5f, 0.1f}};
  mesh.normals = {{-0.1f, 0, 0.99f}, {0.1f, 0, 0.99f}, {0.1f, 0.1f, 0.98f}, {0, 0, 1}};
  mesh.uvs = {vec2(0, 0), vec2(2, 0), vec2(2, 2), vec2(0, 2)};
  mesh.uvs1 = {vec2(0, 1), vec2(0, 0), vec2(1, 0), vec2(1, 1)};
  mesh.tangents = {vec4(1, 0, 0, 1), vec4(1, 0, 0, 1), vec4(0.9f, 0.1f, 0, 1), vec4(1, 0, 0, 1)};
  mesh.colors = {vec4(1, 1, 1, 1), vec4(1, 0.5f, 0.5f, 1), vec4(0.5f, 1, 0.5f, 0.8f),
                 vec4(0.5f, 0.5f, 1, 1)};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

scene::Scene Pictures() {
  SceneBuilder builder("Pictures", vec3(0, 0, 7), vec3(0));
  builder.Add(PointLight(vec3(-3, 4, 8), 300));
  const int images[3] = {builder.Add(Bands(true, false)), builder.Add(Bands(false, false)),
                         builder.Add(Bands(false, true))};
  const scene::Wrap wraps[3] = {scene::Wrap::Repeat, scene::Wrap::Clamp, scene::Wrap::Mirror};
  const scene::TextureFilter filters[3] = {
      scene::TextureFilter::Nearest, scene::TextureFilter::Linear, scene::TextureFilter::Mipmap};
  const scene::MeshGeometry sheet{builder.Add(FullSheet())};
  for (int i = 0; i < 27; ++i) {
    scene::Material material = Matte(Spectrum(0.9f));
    material.terms[1].color.texture =
        builder.Add(Showing(images[i / 9], wraps[i % 3], filters[i / 3 % 3], i % 2));
    const Affine place = Move({float(i % 7) * 0.8f - 2.4f, float(i / 7) * 1.2f - 1.8f, 0}) *
                         Turn(float(i) * 7 - 90, vec3(1, 0.2f, 0)) * Scale(vec3(0.8f));
    if (i % 4 == 0) {
      builder.Place(scene::Sphere{vec3(0), 0.4f}, builder.Add(material), place);
    } else {
      builder.Place(sheet, builder.Add(material), place);
    }
  }
  return builder.Finish();
}

scene::Material Physical(Spectrum base, float metalness, float roughness) {
  scene::Material material;
  material.physical.emplace();
  material.physical->baseColor.value = base;
  material.physical->baseMetalness.value = metalness;
  material.physical->specularRoughness.value = roughness;
  return material;
}

scene::Scene PhysicalMaterials() {
  SceneBuilder builder("PhysicalMaterials", vec3(0, 1.5f, 8), vec3(0, 0.4f, 0));
  builder.Add(PointLight(vec3(4, 6, 5), 400));
  builder.Add(AmbientLight(0.3f));
  builder.environment().top = {0.4f, 0.5f, 0.7f};
  const int image = builder.Add(Bands(false, false));
  const int texture =
      builder.Add(Showing(image, scene::Wrap::Repeat, scene::TextureFilter::Mipmap));
  scene::Material materials[8];
  for (scene::Material& material : materials) material = Physical({0.7f, 0.4f, 0.2f}, 0, 0.4f);
  materials[0].physical->baseMetalness.value = 1;
  materials[1].physical->specularRoughness = {0.8f, texture, 1};
  materials[1].physical->baseMetalness = {1, texture, 2};
  materials[2].physical->coatWeight.value = 1;
  materials[3].physical->fuzzWeight.value = 0.8f;
  materials[4] = Physical({0.9f, 1.0f, 0.95f}, 0, 0);
  materials[4].physical->transmissionWeight.value = 1;
  materials[4].physical->transmissionDepth = 0.5f;
  materials[4].physical->transmissionColor.value = {0.3f, 0.8f, 0.5f};
  materials[5].physical->specularWeight.value = 0;
  materials[5].physical->emission.value = {0.1f, 0.2f, 0.3f};
  materials[6] = Physical({1, 1, 1}, 0, 0.1f);
  materials[6].physical->transmissionWeight.value = 0.7f;
  materials[6].thin = true;
  materials[7].physical->baseColor = {Spectrum(0.9f), texture};
  for (int i = 0; i < 8; ++i)
    builder.Place(scene::Sphere{vec3(float(i % 4) * 1.4f - 2.1f, float(i / 4) * 1.4f, 0), 0.6f},
                  builder.Add(materials[i]));
  builder.Floor(-0.6f);
  return builder.Finish();
}

// Films, brushed metal and coats with normals of their own, on round and flat surfaces, with and without textures.
scene::Scene Layers() {
  SceneBuilder builder("Layers", vec3(0, 1, 8), vec3(0, 0.2f, 0));
  builder.Add(PointLight(vec3(4, 6, 5), 400));
  builder.environment() = {{0.2f, 0.15f, 0.1f}, {0.5f, 0.6f, 0.8f}, -0.5f, 1, 1};
  const int image = builder.Add(Bands(false, false));
  const int texture =
      builder.Add(Showing(image, scene::Wrap::Repeat, scene::TextureFilter::Linear));
  scene::Material materials[9];
  for (scene::Material& material : materials) material = Physical({0.7f, 0.4f, 0.2f}, 0, 0.4f);
  materials[0] = Physical({0.9f, 0.6f, 0.3f}, 1, 0.3f);
  materials[0].physical->specularColor.value = {0.8f, 0.9f, 1.0f};
  materials[0].physical->thinFilmWeight.value = 1;
  materials[1].physical->thinFilmWeight = {0.8f, texture, 0};
  materials[1].physical->thinFilmThickness = {0.9f, texture, 1};
  materials[1].physical->thinFilmThicknessLeast = 0.2f;
  materials[2] = Physical({1, 1, 1}, 0, 0.1f);
  materials[2].physical->transmissionWeight.value = 1;
  materials[2].physical->thinFilmWeight.value = 1;
  materials[2].physical->transmissionTintedByBase = true;
  materials[3] = Physical({0.8f, 0.8f, 0.9f}, 1, 0.4f);
  materials[3].physical->specularRoughnessAnisotropy.value = 0.8f;
  materials[3].physical->anisotropyRotation = 0.7f;
  materials[4] = Physical({0.8f, 0.7f, 0.9f}, 1, 0.2f);
  materials[4].physical->specularRoughnessAnisotropy = {0.7f, texture, 2};
  materials[4].physical->anisotropyOfGltf = true;
  materials[4].physical->anisotropyMapped = true;
  materials[5].physical->coatWeight.value = 1;
  materials[5].physical->coatColor = {Spectrum(0.9f, 0.5f, 0.5f), texture};
  materials[5].physical->coatRoughness.value = 0.3f;
  materials[5].physical->coatRoughnessAnisotropy = 0.6f;
  materials[5].physical->coatNormal = {texture, 0.5f, true};
  materials[5].normalMap = {texture, 0.5f, false};
  materials[6] = Physical({1, 1, 1}, 0, 0);
  materials[6].physical->transmissionWeight.value = 1;
  materials[6].physical->transmissionDispersionScale = 1;
  materials[7].physical->transmissionWeight.value = 0.8f;
  materials[7].physical->transmissionColor = {Spectrum(0.5f, 0.9f, 0.9f), texture};
  materials[7].physical->fuzzWeight.value = 0.5f;
  materials[7].physical->specularWeight.value = 1.5f;
  materials[7].thin = true;
  materials[8].physical->emission.value = {0.3f, 0.2f, 0.1f};
  materials[8].physical->coatWeight.value = 0.8f;
  materials[8].physical->coatColor.value = {0.9f, 0.6f, 0.3f};
  materials[8].physical->fuzzWeight.value = 0.3f;
  materials[8].physical->diffuseTransmissionWeight = {0.5f, texture, 0};
  materials[8].physical->diffuseTransmissionColor = {Spectrum(0.9f), texture};
  const scene::MeshGeometry octahedron{builder.Add(SmoothOctahedron())};
  for (int i = 0; i < 9; ++i) {
    const int index = builder.Add(materials[i]);
    const vec3 place(float(i % 3) * 1.7f - 1.7f, float(i / 3) * 1.5f - 1.2f, 0);
    if (i % 2 == 0) {
      builder.Place(scene::Sphere{place, 0.7f}, index);
    } else {
      builder.Place(octahedron, index, Move(place) * Scale(vec3(0.8f)));
    }
  }
  builder.Floor(-2);
  return builder.Finish();
}

scene::Scene MapsOnSheets() {
  SceneBuilder builder("MapsOnSheets", vec3(0, 0, 6), vec3(0));
  builder.Add(PointLight(vec3(3, 4, 6), 300));
  builder.environment().top = {0.3f, 0.3f, 0.3f};
  const int image = builder.Add(Bands(false, false));
  const int linear = builder.Add(Showing(image, scene::Wrap::Repeat, scene::TextureFilter::Linear));
  const scene::MeshGeometry sheet{builder.Add(FullSheet())};
  for (int i = 0; i < 8; ++i) {
    scene::Material material = i < 4 ? Physical(Spectrum(0.8f), 0, 0.5f) : Matte(Spectrum(0.8f));
    if (i % 2 == 0) material.normalMap = {linear, 0.8f, i == 2};
    if (i % 4 == 1) material.bumpMap = {linear, 0.05f, false};
    if (i % 4 == 3) material.alphaMode = scene::AlphaMode::Mask;
    if (i % 4 == 2) material.alphaMode = scene::AlphaMode::Blend;
    material.opacity = {1, linear, 3};
    material.doubleSided = i != 5;
    const int index = builder.Add(material);
    const float x = float(i % 4) * 1.2f - 1.8f, y = float(i / 4) * 1.4f - 0.7f;
    builder.Place(sheet, index,
                  Move({x, y, 0}) * Turn(i == 5 ? 150.0f : 0.0f, vec3(0, 1, 0)) *
                      Scale({i == 3 ? -1.0f : 1.0f, 1, 1}));
  }
  const int lamp = builder.Add(Matte({0.8f, 0.3f, 0.1f}));
  builder.Place(scene::Rectangle{vec3(-3, -2, -1), vec3(6, 0, 0), vec3(0, 4, 0)}, lamp);
  return builder.Finish();
}

}  // namespace

std::vector<scene::Scene> ScenesOfPictures() {
  return {Pictures(), PhysicalMaterials(), Layers(), MapsOnSheets()};
}

}  // namespace snell::agree
