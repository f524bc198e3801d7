// SPDX-License-Identifier: Apache-2.0
#include "render/cryptomatte.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace snell::render {
namespace {

// Published values of the hash.
TEST(Cryptomatte, HashesAsMurmurHash3) {
  EXPECT_EQ(MurmurHash3(""), 0u);
  EXPECT_EQ(MurmurHash3("hello"), 0x248bfa47u);
  EXPECT_EQ(MurmurHash3("hello, world"), 0x149bbb7fu);
  EXPECT_EQ(MurmurHash3("The quick brown fox jumps over the lazy dog"), 0x2e4ff723u);
}

// Names and ids in the manifests of the sample pictures that come with the specification.
TEST(Cryptomatte, IdsAreThoseOfTheSamplePictures) {
  EXPECT_EQ(CryptomatteId("bunny"), 0x13851a76u);
  EXPECT_EQ(CryptomatteId("bush"), 0xf763d090u);
  EXPECT_EQ(CryptomatteId("flowerA.flowerA_petal1.:1015"), 0x914754e4u);
  EXPECT_EQ(CryptomatteId("flowerA.flowerA_petal1.:134"), 0xdbc045b9u);
  // The hash has no exponent; as a float it would be denormal
  EXPECT_EQ(CryptomatteId("flowerA.flowerA_petal1.:2261"), 0x00af91aeu);
}

TEST(Cryptomatte, IdsAreNormalFloats) {
  for (int i = 0; i < 20000; ++i)
    EXPECT_TRUE(std::isnormal(std::bit_cast<float>(CryptomatteId("object_" + std::to_string(i)))));
}

TEST(Cryptomatte, LayersHoldTheGreatestCoverages) {
  std::vector<Coverage> coverages(2);
  for (std::uint32_t id = 1; id <= 8; ++id) coverages[0].Add(id, id);
  coverages[1].Add(7, 3);
  coverages[1].Add(7);
  image::Layers layers;
  AddCryptomatte("crypto_object", {"a\"b", "bunny"}, coverages, {36, 8}, layers);
  ASSERT_EQ(layers.layers.size(), 3u);
  EXPECT_EQ(layers.layers[2].name, "crypto_object02");
  for (std::size_t rank = 0; rank < 6; ++rank) {
    const float* pair = &layers.layers[rank / 2].values[rank % 2 * 2];
    EXPECT_EQ(std::bit_cast<std::uint32_t>(pair[0]), 8 - rank);
    EXPECT_FLOAT_EQ(pair[1], float(8 - rank) / 36);
  }
  EXPECT_EQ(layers.layers[0].values[5], 0.5f);
  EXPECT_EQ(layers.layers[0].values[7], 0.0f);
  EXPECT_EQ(layers.metadata[0].second, "crypto_object");
  EXPECT_EQ(layers.metadata[3].first.substr(19), "/manifest");
  EXPECT_EQ(layers.metadata[3].second.find("\"bunny\":\"13851a76\"}"),
            layers.metadata[3].second.size() - 19);
  EXPECT_EQ(layers.metadata[3].second.rfind("{\"a\\\"b\":\"", 0), 0u);
}

}  // namespace
}  // namespace snell::render
