// SPDX-License-Identifier: Apache-2.0
//
// Members of the JSON objects that tinygltf leaves as they are: extensions. What is absent, of another
// type or not finite has the default.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "io/gltf/model.h"

namespace snell::io {

class GltfValue {
 public:
  // Of nothing: every member has its default.
  GltfValue() : value_(nullptr) {}
  explicit GltfValue(const tinygltf::Value& value) : value_(&value) {}
  // The extension of that name.
  GltfValue(const tinygltf::ExtensionMap& extensions, const std::string& name) {
    const auto found = extensions.find(name);
    value_ = found == extensions.end() ? nullptr : &found->second;
  }

  explicit operator bool() const { return value_ && value_->IsObject(); }

  GltfValue Object(const std::string& key) const;
  int Integer(const std::string& key, int fallback = -1) const;
  std::size_t Size(const std::string& key, std::size_t fallback = 0) const;  // 0 if negative
  double Number(const std::string& key, double fallback) const;
  bool Bool(const std::string& key, bool fallback) const;
  // Of an array: its objects, and whether it has a number
  std::vector<GltfValue> Objects(const std::string& key) const;
  bool Lists(const std::string& key, int number) const;
  std::string Text(const std::string& key) const;
  // An array of as many numbers as `fallback` has.
  std::vector<double> Numbers(const std::string& key, std::vector<double> fallback) const;
  glm::vec3 Vector(const std::string& key, glm::vec3 fallback) const;

 private:
  const tinygltf::Value* Member(const std::string& key) const;

  const tinygltf::Value* value_ = nullptr;
};

}  // namespace snell::io
