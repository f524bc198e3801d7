// SPDX-License-Identifier: Apache-2.0
#include "io/append.h"

#include <iterator>
#include <utility>
#include <vector>

namespace snell::io {
namespace {

// Every texture that a material shows.
template <typename Visit>
void VisitTextures(scene::OpenPbr& m, const Visit& visit) {
  for (scene::ColorInput* input :
       {&m.baseColor, &m.specularColor, &m.transmissionColor, &m.diffuseTransmissionColor,
        &m.subsurfaceColor, &m.coatColor, &m.fuzzColor, &m.emission})
    visit(input->texture);
  for (scene::ScalarInput* input :
       {&m.baseMetalness, &m.specularWeight, &m.specularRoughness, &m.specularRoughnessAnisotropy,
        &m.transmissionWeight, &m.diffuseTransmissionWeight, &m.subsurfaceWeight, &m.coatWeight,
        &m.coatRoughness, &m.fuzzWeight, &m.fuzzRoughness, &m.thinFilmWeight, &m.thinFilmThickness})
    visit(input->texture);
  visit(m.coatNormal.texture);
}

template <typename Visit>
void VisitTextures(scene::Material& material, const Visit& visit) {
  for (scene::Term& term : material.terms) visit(term.color.texture);
  visit(material.emission.texture);
  visit(material.reflectivity.texture);
  visit(material.transparency.texture);
  visit(material.normalMap.texture);
  visit(material.bumpMap.texture);
  visit(material.opacity.texture);
  if (material.physical) VisitTextures(*material.physical, visit);
}

template <typename T>
void MoveBehind(std::vector<T>& from, std::vector<T>& to) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  from.clear();
}

void Shift(int& index, std::size_t by) {
  if (index >= 0) index += int(by);
}

}  // namespace

void AppendResources(scene::Scene& from, scene::Scene& to) {
  for (scene::Texture& texture : from.textures) Shift(texture.image, to.images.size());
  for (scene::Material& material : from.materials)
    VisitTextures(material, [&](int& texture) { Shift(texture, to.textures.size()); });
  for (scene::Material& material : from.materials) {
    if (material.volume) Shift(material.volume->grid, to.grids.size());
  }
  for (scene::Light& light : from.lights) Shift(light.profile, to.profiles.size());
  for (scene::Object& object : from.objects) {
    Shift(object.material, to.materials.size());
    if (auto* mesh = std::get_if<scene::MeshGeometry>(&object.geometry))
      Shift(mesh->mesh, to.meshes.size());
  }
  MoveBehind(from.images, to.images);
  MoveBehind(from.textures, to.textures);
  MoveBehind(from.materials, to.materials);
  MoveBehind(from.grids, to.grids);
  MoveBehind(from.profiles, to.profiles);
  MoveBehind(from.meshes, to.meshes);
}

}  // namespace snell::io
