#pragma once

#include "BrickLayout.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate
{
/// A set of a brick's cells, a bit for each, i fastest, then j, then k: bit n % 64 of word n / 64.
/// Bricks of 4, 8 and 16 cells along an axis take the first 1, 8 and 64 words; the others mean
/// nothing and are not set.
struct CellSet
{
  static constexpr std::size_t MostWords = MostBrickCells * MostBrickCells * MostBrickCells / 64;
  std::array<std::uint64_t, MostWords> Words;

  static constexpr std::size_t WordsOf(int shift) { return std::size_t{1} << (3 * shift - 6); }

  void Fill(int shift, bool isIn)
  {
    const std::size_t words = WordsOf(shift);
    for (std::size_t word = 0; word < words; ++word)
    {
      this->Words[word] = isIn ? ~std::uint64_t{0} : 0;
    }
  }
};

/// How a brick's rows of cells, those along i, lie in the words of its sets.
struct CellRows
{
  int Shift;

  /// That lie in one word, of one slice.
  int InWord() const noexcept { return this->Shift == 2 ? 4 : 64 >> this->Shift; }
  std::size_t WordOf(int j, int k) const noexcept
  {
    return static_cast<std::size_t>(this->FirstBit(j, k)) >> 6;
  }
  int BitInWord(int j, int k) const noexcept { return this->FirstBit(j, k) & 63; }

private:
  int FirstBit(int j, int k) const noexcept { return ((k << this->Shift) + j) << this->Shift; }
};
} // namespace palpate
