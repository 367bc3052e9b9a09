#pragma once

#include "FieldGrid.h"
#include "ScalarType.h"

#include <array>
#include <cstddef>

namespace palpate
{
/// Samples of one channel, owned by the caller: a box of a grid's nodes, i fastest, and one value
/// for all nodes outside the box.
struct FieldSamples
{
  const void* Data = nullptr;
  ScalarType Type = ScalarType::Float64;
  std::array<int, 3> StartIndex{};
  std::array<int, 3> Size{};
  double Outside = 0.0;

  std::size_t Count() const noexcept
  {
    return static_cast<std::size_t>(this->Size[0]) * static_cast<std::size_t>(this->Size[1]) *
           static_cast<std::size_t>(this->Size[2]);
  }
  /// Offset of node (start + (i, j, k)).
  std::size_t Offset(int i, int j, int k) const noexcept
  {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(this->Size[1]) +
            static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(this->Size[0]) +
           static_cast<std::size_t>(i);
  }
};

/// One sample for every node of the grid.
template <typename T>
FieldSamples SamplesOfGrid(const T* samples, const FieldGrid& grid) noexcept
{
  return {samples, ScalarTypeOf<T>(), {0, 0, 0}, grid.Size(), 0.0};
}
} // namespace palpate
