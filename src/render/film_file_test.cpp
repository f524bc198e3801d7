// SPDX-License-Identifier: Apache-2.0
//
// Film files: what is saved comes back to the bit; a file that is damaged anywhere gives one error.
#include "render/film_file.h"

#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <random>

#include "support/scratch_folder.h"
#include "util/error.h"

namespace snell::render {
namespace {

using kernel::Spectrum;

Film Noisy(PixelRect rect, std::uint32_t first, std::uint32_t count) {
  Film film(rect, first);
  std::mt19937 random(first);
  for (int y = rect.y0; y < rect.y1; ++y) {
    for (int x = rect.x0; x < rect.x1; ++x) {
      for (std::uint32_t i = 0; i < count; ++i)
        film.Add(x, y, first + i, Spectrum(float(random() % 1000) / 300.0f, 0.1f, 1e-6f));
      film.At(x, y).goal = count + std::uint32_t(x % 2);
    }
  }
  film.origin() = {{{"camera", "#1234"}, {"max depth", "8"}}, {{"scene", "a=b\nc"}}};
  return film;
}

class FilmFile : public testing::Test, protected test::ScratchFolder {
 protected:
  std::string ErrorOf(const std::string& name) {
    try {
      LoadFilm(Path(name));
      return "";
    } catch (const Error& error) {
      EXPECT_EQ(error.diagnostics().size(), 1u);
      EXPECT_EQ(error.diagnostics()[0].place.file, Path(name));
      return error.diagnostics()[0].message;
    }
  }
};

TEST_F(FilmFile, BringsBackEveryBit) {
  Film film = Noisy({3, 5, 20, 9}, 7, 30);
  film.merged() = {{{3, 5, 20, 9}, 7, 9}, {{3, 5, 20, 9}, 100, 128}};
  SaveFilm(film, Path("a.snell-film"));
  const Film back = LoadFilm(Path("a.snell-film"));
  EXPECT_EQ(back.rect(), film.rect());
  EXPECT_EQ(back.firstSample(), 7u);
  ASSERT_EQ(back.pixels().size(), film.pixels().size());
  EXPECT_EQ(std::memcmp(back.pixels().data(), film.pixels().data(), film.MemoryBytes()), 0);
  EXPECT_EQ(back.origin().samples, film.origin().samples);
  EXPECT_EQ(back.origin().notes, (Properties{{"scene", "a=b?c"}}));
  ASSERT_EQ(back.merged().size(), 2u);
  EXPECT_EQ(back.merged()[1].rect, film.rect());
  EXPECT_EQ(back.merged()[1].first, 100u);
  EXPECT_EQ(back.merged()[1].last, 128u);
  // The same film gives the same bytes, and nothing else is left in the folder
  SaveFilm(back, Path("b.snell-film"));
  EXPECT_EQ(Read("a.snell-film").size(), Read("b.snell-film").size());
  EXPECT_EQ(Files().size(), 2u);
}

TEST_F(FilmFile, NoticesDamageAnywhere) {
  SaveFilm(Noisy({0, 0, 3, 2}, 0, 9), Path("good"));
  const std::string good = Read("good");
  for (std::size_t i = 0; i < good.size(); ++i) {
    for (const int change : {1, 0x80}) {
      std::string bad = good;
      bad[i] = char(bad[i] ^ change);
      Write("bad", bad);
      EXPECT_NE(ErrorOf("bad"), "") << "byte " << i;
    }
  }
}

TEST_F(FilmFile, NoticesThatAPartIsMissing) {
  SaveFilm(Noisy({0, 0, 3, 2}, 0, 9), Path("good"));
  const std::string good = Read("good");
  for (std::size_t size = 0; size < good.size(); ++size) {
    Write("bad", good.substr(0, size));
    EXPECT_NE(ErrorOf("bad").find("incomplete"), std::string::npos) << size << ErrorOf("bad");
  }
  Write("bad", good + "x");
  EXPECT_EQ(ErrorOf("bad"), "the film file has 1 bytes too many");
}

TEST_F(FilmFile, SaysWhatIsWrong) {
  EXPECT_EQ(ErrorOf("none"), "cannot read the file: No such file or directory");
  Write("text", std::string(100, 'a'));
  EXPECT_EQ(ErrorOf("text"), "not a film file");
  std::filesystem::create_directory(Path("folder"));
  EXPECT_EQ(ErrorOf("folder"), "not a regular file");
  SaveFilm(Noisy({0, 0, 3, 2}, 0, 9), Path("good"));
  std::string bytes = Read("good");
  bytes[8] = 9;
  Write("newer", bytes);
  EXPECT_EQ(ErrorOf("newer"), "the film file has version 9 of its format; this program knows 2");
  bytes = Read("good");
  bytes[bytes.size() - 20] ^= 1;
  Write("flipped", bytes);
  EXPECT_EQ(ErrorOf("flipped"), "the film file is damaged: the checksum of its pixels is wrong");
}

TEST_F(FilmFile, RefusesPixelsThatNoRenderMakes) {
  const auto expectNonsense = [&](const std::function<void(Film&)>& spoil) {
    Film film = Noisy({0, 0, 3, 2}, 5, 9);
    spoil(film);
    SaveFilm(film, Path("odd"));
    EXPECT_EQ(ErrorOf("odd"), "the film file's pixels make no sense");
  };
  expectNonsense([](Film& film) { film.At(1, 1).count = 0; });
  expectNonsense([](Film& film) { film.At(1, 1).halfCount = 12; });
  expectNonsense([](Film& film) { film.At(1, 1).goal = 3; });
  expectNonsense([](Film& film) { film.At(1, 1).goal = 0xffffffffu; });
  expectNonsense([](Film& film) {
    film.At(1, 1).squares = {};
    film.At(1, 1).squares.Add(-1);
  });
}

TEST(FilmOrigin, DifferencesAreToldInWords) {
  const FilmOrigin a{{{"camera", "#12"}, {"max depth", "8"}, {"seed", "0"}}, {{"scene", "x"}}};
  const FilmOrigin b{{{"camera", "#34"}, {"max depth", "16"}, {"seed", "0"}}, {{"scene", "y"}}};
  EXPECT_EQ(Difference(a, a), "");
  EXPECT_EQ(Difference(a, b), "another camera; max depth 8, not 16");
  EXPECT_EQ(Difference(a, {}), "another camera; max depth 8, not none; seed 0, not none");
  EXPECT_EQ(Difference({}, {{{"seed", "0"}}, {}}), "seed none, not 0");
}

}  // namespace
}  // namespace snell::render
