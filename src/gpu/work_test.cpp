// SPDX-License-Identifier: Apache-2.0
#include "gpu/work.h"

#include <gtest/gtest.h>

#include <map>

namespace snell::gpu {

namespace {

// Pixels of a part of a picture that want different numbers of samples.
render::Film FilmWithGoals() {
  render::Film film({5, 3, 50, 30}, 7);
  std::uint32_t i = 0;
  for (render::Film::Pixel& pixel : film.pixels()) {
    pixel.count = i % 3;
    pixel.goal = pixel.count + i % 5;
    ++i;
  }
  return film;
}

TEST(Work, GivesEachSampleOnceInOrder) {
  render::Film film = FilmWithGoals();
  for (const std::uint32_t limit : {Work::LeastLimit, 1000u, 100000u}) {
    Work work(film);
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> next;
    for (Batch batch = work.Next(limit); !batch.requests.empty(); batch = work.Next(limit)) {
      EXPECT_LE(batch.requests.size(), limit);
      for (const kernel::SampleRequest& request : batch.requests) {
        const std::uint32_t x = request.pixel.x, y = request.pixel.y;
        const auto [known, isNew] = next.try_emplace({x, y}, 7 + film.At(int(x), int(y)).count);
        EXPECT_EQ(request.index, known->second++);
      }
    }
    for (int y = 3; y < 30; ++y) {
      for (int x = 5; x < 50; ++x) {
        const render::Film::Pixel& pixel = film.At(x, y);
        const auto given = next.find({std::uint32_t(x), std::uint32_t(y)});
        EXPECT_EQ(given == next.end() ? 7 + pixel.count : given->second, 7 + pixel.goal);
      }
    }
  }
}

TEST(Work, GivesATileOneShareOfABatch) {
  const render::Film film = FilmWithGoals();
  Work work(film);
  const Batch batch = work.Next(1500);
  std::size_t end = 0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> tiles;
  for (const TileShare& share : batch.shares) {
    EXPECT_EQ(share.first, end);
    end = share.last;
    const kernel::uvec2 first = batch.requests[share.first].pixel;
    for (std::size_t i = share.first; i < share.last; ++i) {
      EXPECT_EQ((batch.requests[i].pixel.x - 5) / 16, (first.x - 5) / 16);
      EXPECT_EQ((batch.requests[i].pixel.y - 3) / 16, (first.y - 3) / 16);
    }
    EXPECT_EQ(++tiles[std::pair((first.x - 5) / 16, (first.y - 3) / 16)], 1);
  }
  EXPECT_EQ(end, batch.requests.size());
}

}  // namespace

}  // namespace snell::gpu
