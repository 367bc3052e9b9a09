#pragma once

#include "BrickLayout.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate
{
/// A set of a brick's cells, one bit each, i fastest, then j, then k: bit n % 64 of word n / 64. So
/// a word holds a slice of cells across k, and a byte of it a row along i.
struct CellSet
{
  static constexpr std::size_t WordCount =
      std::size_t{BrickLayout::Cells} * BrickLayout::Cells * BrickLayout::Cells / 64;
  std::array<std::uint64_t, WordCount> Words;

  void Fill(bool isIn) { this->Words.fill(isIn ? ~std::uint64_t{0} : 0); }
};
} // namespace palpate
