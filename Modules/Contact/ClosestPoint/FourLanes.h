#pragma once

#include <cmath>
#include <cstddef>

namespace palpate
{
/// Four numbers at once, by GCC and Clang's vector extension. Functions take and give them by
/// reference, since their calling convention as values depends on the instruction set. So does
/// their alignment: what functions for several sets share is declared alignas(sizeof(FourLanes)).
typedef double FourLanes __attribute__((vector_size(4 * sizeof(double))));

/// Of negative numbers 0.
inline void SquareRoot(double square, double& root) noexcept
{
  root = std::sqrt(square > 0.0 ? square : 0.0);
}
inline void SquareRoot(const FourLanes& square, FourLanes& root) noexcept
{
  const FourLanes positive = square > 0.0 ? square : FourLanes{};
  for (std::size_t i = 0; i < 4; ++i)
  {
    root[i] = std::sqrt(positive[i]);
  }
}
} // namespace palpate
