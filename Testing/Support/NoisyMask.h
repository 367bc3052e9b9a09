#pragma once

#include "VoxelMask.h"

#include <random>

namespace palpate::test
{
/// Flips each voxel at the boundary in its slice with a probability.
inline VoxelMask WithNoise(VoxelMask mask, double probability, std::mt19937_64& random)
{
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const VoxelMask before = mask;
  for (int k = 0; k < mask.Size[2]; ++k)
  {
    for (int j = 1; j + 1 < mask.Size[1]; ++j)
    {
      for (int i = 1; i + 1 < mask.Size[0]; ++i)
      {
        const unsigned char here = before.Inside[before.Offset(i, j, k)];
        const bool isBoundary = before.Inside[before.Offset(i - 1, j, k)] != here ||
                                before.Inside[before.Offset(i + 1, j, k)] != here ||
                                before.Inside[before.Offset(i, j - 1, k)] != here ||
                                before.Inside[before.Offset(i, j + 1, k)] != here;
        if (isBoundary && part(random) < probability)
        {
          mask.Inside[mask.Offset(i, j, k)] = here != 0 ? 0 : 1;
        }
      }
    }
  }
  return mask;
}
} // namespace palpate::test
