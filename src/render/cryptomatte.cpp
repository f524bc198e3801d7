// SPDX-License-Identifier: Apache-2.0
#include "render/cryptomatte.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <map>

namespace snell::render {

namespace {

constexpr std::size_t Ranks = 6;  // two to a layer

std::uint32_t Block(std::string_view bytes) {
  std::uint32_t block = 0;
  for (std::size_t i = bytes.size(); i-- > 0;)
    block = (block << 8) | std::uint32_t(std::uint8_t(bytes[i]));
  return block;
}

std::uint32_t Scrambled(std::uint32_t block) {
  return std::rotl(block * 0xcc9e2d51u, 15) * 0x1b873593u;
}

// A text as JSON; names are UTF-8.
std::string InJson(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    if (static_cast<unsigned char>(c) < ' ')
      quoted += fmt::format("\\u{:04x}", int(c));
    else
      quoted += c;
  }
  return quoted + "\"";
}

}  // namespace

std::uint32_t MurmurHash3(std::string_view text) {
  std::uint32_t hash = 0;
  std::string_view rest = text;
  for (; rest.size() >= 4; rest.remove_prefix(4))
    hash = std::rotl(hash ^ Scrambled(Block(rest.substr(0, 4))), 13) * 5 + 0xe6546b64u;
  hash ^= Scrambled(Block(rest)) ^ std::uint32_t(text.size());
  hash = (hash ^ (hash >> 16)) * 0x85ebca6bu;
  hash = (hash ^ (hash >> 13)) * 0xc2b2ae35u;
  return hash ^ (hash >> 16);
}

std::uint32_t CryptomatteId(std::string_view name) {
  const std::uint32_t hash = MurmurHash3(name);
  const std::uint32_t exponent = (hash >> 23) & 255;
  return exponent == 0 || exponent == 255 ? hash ^ (1u << 23) : hash;
}

void Coverage::Add(std::uint32_t id) { Add(id, 1); }

void Coverage::Add(std::uint32_t id, std::uint32_t count) {
  for (auto& [known, sum] : counts_) {
    if (known == id) {
      sum += count;
      return;
    }
  }
  counts_.emplace_back(id, count);
}

void Coverage::Add(const Coverage& other) {
  for (const auto& [id, count] : other.counts_) Add(id, count);
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> Coverage::Ranked() const {
  auto ranked = counts_;
  std::ranges::sort(ranked, [](const auto& a, const auto& b) {
    return a.second != b.second ? a.second > b.second : a.first < b.first;
  });
  return ranked;
}

void AddCryptomatte(const std::string& name, const std::vector<std::string>& names,
                    const std::vector<Coverage>& coverages,
                    const std::vector<std::uint32_t>& samples, image::Layers& layers) {
  // Pairs of id and coverage, the greatest first
  const std::size_t first = layers.layers.size();
  for (std::size_t i = 0; i < Ranks / 2; ++i) {
    image::Layer layer{fmt::format("{}{:02}", name, i), {"R", "G", "B", "A"}, false, {}};
    layer.values.resize(coverages.size() * 4);
    layers.layers.push_back(std::move(layer));
  }
  for (std::size_t pixel = 0; pixel < coverages.size(); ++pixel) {
    const auto ranked = coverages[pixel].Ranked();
    for (std::size_t rank = 0; rank < std::min(ranked.size(), Ranks); ++rank) {
      float* const pair =
          &layers.layers[first + rank / 2].values[pixel * 4 + (rank % 2 == 0 ? 0 : 2)];
      pair[0] = std::bit_cast<float>(ranked[rank].first);
      pair[1] = float(double(ranked[rank].second) / double(samples[pixel]));
    }
  }

  // What the ids stand for, under the first digits of the hash of the layers' name
  const std::string key = fmt::format("{:08x}", CryptomatteId(name)).substr(0, 7);
  const std::string prefix = "cryptomatte/" + key + "/";
  std::map<std::string, std::uint32_t> manifest;
  for (const std::string& each : names) manifest.emplace(each, CryptomatteId(each));
  std::string json;
  for (const auto& [each, id] : manifest)
    json += fmt::format("{}{}:\"{:08x}\"", json.empty() ? "{" : ",", InJson(each), id);
  layers.metadata.emplace_back(prefix + "name", name);
  layers.metadata.emplace_back(prefix + "hash", "MurmurHash3_32");
  layers.metadata.emplace_back(prefix + "conversion", "uint32_to_float32");
  layers.metadata.emplace_back(prefix + "manifest", json.empty() ? "{}" : json + "}");
}

}  // namespace snell::render
