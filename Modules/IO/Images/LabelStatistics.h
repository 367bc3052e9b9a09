#pragma once

#include "PalpateIOModule.h"
#include "Segmentation.h"

#include <array>
#include <string>
#include <vector>

namespace palpate
{
/// Voxel statistics of one structure of a segmentation, on its own grid.
struct LabelStatistics
{
  vtkIdType Voxels = 0;
  double Milliliters = 0.0; ///< voxel count times voxel volume
  /// Smallest and largest index on each axis: x0, x1, y0, y1, z0, z1, inclusive.
  std::array<int, 6> BoundsIndex{{0, -1, 0, -1, 0, -1}};
  /// Faces of the image that the structure reaches, in the order of BoundsIndex.
  std::array<bool, 6> TouchesFace{{false, false, false, false, false, false}};
  /// Voxels of each connected component, descending. Voxels are connected through faces, as in the
  /// extracted surface.
  std::vector<vtkIdType> ComponentVoxels;
  /// Voxels of each cavity, descending: a component (26 neighbours) of the voxels outside the
  /// structure that does not reach the border of the image. Voxels of other structures count as
  /// outside the structure.
  std::vector<vtkIdType> CavityVoxels;
  double CavityMilliliters = 0.0;

  PALPATEIO_EXPORT bool TouchesBorder() const;
  /// The faces that the structure reaches, by index axis and end, such as "x- z+".
  PALPATEIO_EXPORT std::string FacesText() const;
};

/// The statistics of every segment, in the order of `segmentation.Segments`. One pass over each
/// layer counts, and a further one for every four million runs of voxels collects the runs, which
/// the rest uses; so time does not grow with the number of structures.
PALPATEIO_EXPORT std::vector<LabelStatistics> MeasureLabels(const Segmentation& segmentation);
} // namespace palpate
