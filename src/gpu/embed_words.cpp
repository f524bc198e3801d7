// SPDX-License-Identifier: Apache-2.0
//
// Writes a file's 32-bit words as text that C++ includes: "embed_words FROM TO".
#include <cstdint>
#include <cstdio>

int main(int argc, char** argv) {
  std::FILE* const from = argc == 3 ? std::fopen(argv[1], "rb") : nullptr;
  std::FILE* const to = from ? std::fopen(argv[2], "w") : nullptr;
  if (!to) return 1;
  std::uint32_t word = 0;
  for (unsigned count = 1; std::fread(&word, sizeof word, 1, from) == 1; ++count)
    std::fprintf(to, count % 8 == 0 ? "0x%xu,\n" : "0x%xu,", word);
  const bool isWhole = std::feof(from) && !std::ferror(to);
  std::fclose(from);
  return std::fclose(to) == 0 && isWhole ? 0 : 1;
}
