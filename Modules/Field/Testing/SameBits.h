#pragma once

#include "FieldHit.h"

#include <cstdint>
#include <cstring>

namespace palpate::test
{
/// Whether every number of two hits has the same bits.
inline bool SameBits(const FieldHit& a, const FieldHit& b)
{
  const auto bits = [](double x)
  {
    std::uint64_t word = 0;
    std::memcpy(&word, &x, sizeof(x));
    return word;
  };
  const auto same = [&bits](double x, double y) { return bits(x) == bits(y); };
  bool all = a.Kind == b.Kind && a.IsEntering == b.IsEntering && a.Material == b.Material &&
             a.StartsInside == b.StartsInside && same(a.T, b.T);
  for (int axis = 0; axis < 3; ++axis)
  {
    all =
        all && same(a.Position[axis], b.Position[axis]) && same(a.Gradient[axis], b.Gradient[axis]);
  }
  return all;
}
} // namespace palpate::test
