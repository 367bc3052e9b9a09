#pragma once

#include "ComparedBody.h"

#include <cstdint>

namespace palpate
{
/// How much of the space that two bodies take they share, by counting the cells of a grid.
struct BodyOverlap
{
  enum class Cells
  {
    Voxels,     ///< of two masks on one grid: exact for the masks
    MaskVoxels, ///< of the one that is a mask: those with their centre inside the other
    Cubes       ///< around both bodies
  };

  Cells Kind = Cells::Cubes;
  Vector3 Spacing = Vector3::Zero(); ///< of the cells, mm
  std::int64_t One = 0;
  std::int64_t Other = 0;
  std::int64_t Both = 0;

  /// Of which only Dice, and so Jaccard, is known.
  static BodyOverlap OfDice(double dice);

  /// 2 |A and B| / (|A| + |B|): Dice, Ecology 26 (1945). 0 if neither has a cell.
  double Dice() const noexcept;
  /// |A and B| / |A or B|: Jaccard, New Phytologist 11 (1912).
  double Jaccard() const noexcept;
};

/// Compares closed bodies on the voxels of masks, which need not begin at the same voxel nor count
/// along the same axes; masks on different grids, and surfaces and models, on some 4 million cubes
/// around both bodies, of which a mask has those whose centre is in one of its voxels. Fails for an
/// open surface.
Status FindBodyOverlap(const ComparedBody& one, const ComparedBody& other, BodyOverlap& overlap);
} // namespace palpate
