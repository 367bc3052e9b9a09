#pragma once

#include "FieldHit.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/// A rendered image of a field: rows from the bottom up.
struct FieldImage
{
  int Width = 0;
  int Height = 0;
  std::vector<std::uint8_t> Colors; ///< RGBA, premultiplied by the opacity
  std::vector<float> Depths;        ///< of the nearest surface, 1 if there is none
  std::vector<FieldHit> Hits;       ///< the nearest surface, world; empty unless requested

  void Resize(int width, int height, bool keepsHits)
  {
    this->Width = width;
    this->Height = height;
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    this->Colors.resize(4 * count);
    this->Depths.resize(count);
    this->Hits.resize(keepsHits ? count : 0);
  }
  /// Removes surfaces from pixels column0 <= column < column1 and row0 <= row < row1.
  void Clear(int column0, int column1, int row0, int row1) noexcept
  {
    for (int row = row0; row < row1; ++row)
    {
      const std::size_t first = this->Pixel(column0, row);
      const auto count = static_cast<std::size_t>(column1 - column0);
      std::fill_n(this->Colors.begin() + static_cast<std::ptrdiff_t>(4 * first), 4 * count, 0);
      std::fill_n(this->Depths.begin() + static_cast<std::ptrdiff_t>(first), count, 1.0F);
      if (!this->Hits.empty())
      {
        std::fill_n(this->Hits.begin() + static_cast<std::ptrdiff_t>(first), count, FieldHit());
      }
    }
  }
  /// Clears colour and depth of a pixel; its hit is kept.
  void Clear(std::size_t pixel) noexcept
  {
    std::fill_n(this->Colors.begin() + static_cast<std::ptrdiff_t>(4 * pixel), 4, 0);
    this->Depths[pixel] = 1.0F;
  }
  std::size_t Pixel(int column, int row) const noexcept
  {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(this->Width) +
           static_cast<std::size_t>(column);
  }
};
} // namespace palpate
