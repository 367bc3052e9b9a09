#pragma once

#include "ComparedBody.h"

#include <vector>

namespace palpate
{
/// How much of the space that two bodies take they share, by counting the cells of a grid, or by
/// integrals over their surfaces.
struct BodyOverlap
{
  enum class Cells
  {
    Voxels,     ///< of two masks on one grid: exact for the masks
    MaskVoxels, ///< of the one that is a mask: those with their centre inside the other
    Cubes,      ///< around both bodies
    None        ///< of two models: volumes in mm^3
  };

  Cells Kind = Cells::Cubes;
  Vector3 Spacing = Vector3::Zero(); ///< of the cells, mm
  double One = 0.0;                  ///< numbers of cells, or volumes
  double Other = 0.0;
  double Both = 0.0;

  /// Of two models (closed), from the distances of each one's points to the other (mm, negative
  /// inside): by the divergence theorem the volume in both is the integral over the parts of their
  /// surfaces that lie in the other one. Extrapolated over two sizes of triangles; Dice is within
  /// 1e-5. Surfaces that coincide count half each.
  static BodyOverlap OfModels(const ComparedBody& one, const std::vector<double>& there,
                              const ComparedBody& other, const std::vector<double>& back);
  /// Of which only Dice, and so Jaccard, is known.
  static BodyOverlap OfDice(double dice);

  /// 2 |A and B| / (|A| + |B|): Dice, Ecology 26 (1945). 0 if neither has a cell.
  double Dice() const noexcept;
  /// |A and B| / |A or B|: Jaccard, New Phytologist 11 (1912).
  double Jaccard() const noexcept;
};

/// Compares closed bodies on the voxels of masks, which need not begin at the same voxel nor count
/// along the same axes; masks on different grids, and surfaces, on some 4 million cubes
/// around both bodies, of which a mask has those whose centre is in one of its voxels. Fails for an
/// open surface.
Status FindBodyOverlap(const ComparedBody& one, const ComparedBody& other, BodyOverlap& overlap);
} // namespace palpate
