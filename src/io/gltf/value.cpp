// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/value.h"

#include <cmath>
#include <utility>

namespace snell::io {

const tinygltf::Value* GltfValue::Member(const std::string& key) const {
  return *this && value_->Has(key) ? &value_->Get(key) : nullptr;
}

GltfValue GltfValue::Object(const std::string& key) const {
  const tinygltf::Value* member = Member(key);
  return member && member->IsObject() ? GltfValue(*member) : GltfValue();
}

int GltfValue::Integer(const std::string& key, int fallback) const {
  const double number = Number(key, fallback);
  return number == std::floor(number) && std::abs(number) <= 0x7fffffff ? int(number) : fallback;
}

std::size_t GltfValue::Size(const std::string& key, std::size_t fallback) const {
  const double number = Number(key, double(fallback));
  return number >= 0 && number < 9e15 ? std::size_t(number) : 0;
}

double GltfValue::Number(const std::string& key, double fallback) const {
  const tinygltf::Value* member = Member(key);
  if (!member || !member->IsNumber()) return fallback;
  const double number = member->GetNumberAsDouble();
  return std::isfinite(float(number)) ? number : fallback;
}

bool GltfValue::Bool(const std::string& key, bool fallback) const {
  const tinygltf::Value* member = Member(key);
  return member && member->IsBool() ? member->Get<bool>() : fallback;
}

std::vector<GltfValue> GltfValue::Objects(const std::string& key) const {
  std::vector<GltfValue> objects;
  const tinygltf::Value* member = Member(key);
  if (!member || !member->IsArray()) return objects;
  for (std::size_t i = 0; i < member->ArrayLen(); ++i) objects.emplace_back(member->Get(int(i)));
  return objects;
}

bool GltfValue::Lists(const std::string& key, int number) const {
  const tinygltf::Value* member = Member(key);
  if (!member || !member->IsArray()) return false;
  for (std::size_t i = 0; i < member->ArrayLen(); ++i) {
    const tinygltf::Value& element = member->Get(int(i));
    if (element.IsNumber() && element.GetNumberAsDouble() == number) return true;
  }
  return false;
}

std::string GltfValue::Text(const std::string& key) const {
  const tinygltf::Value* member = Member(key);
  return member && member->IsString() ? member->Get<std::string>() : std::string();
}

std::vector<double> GltfValue::Numbers(const std::string& key, std::vector<double> fallback) const {
  const tinygltf::Value* member = Member(key);
  if (!member || member->ArrayLen() != fallback.size()) return fallback;
  std::vector<double> numbers;
  for (std::size_t i = 0; i < fallback.size(); ++i) {
    const tinygltf::Value& number = member->Get(int(i));
    if (!number.IsNumber() || !std::isfinite(float(number.GetNumberAsDouble()))) return fallback;
    numbers.push_back(number.GetNumberAsDouble());
  }
  return numbers;
}

glm::vec3 GltfValue::Vector(const std::string& key, glm::vec3 fallback) const {
  const std::vector<double> v =
      Numbers(key, {double(fallback.x), double(fallback.y), double(fallback.z)});
  return {float(v[0]), float(v[1]), float(v[2])};
}

}  // namespace snell::io
