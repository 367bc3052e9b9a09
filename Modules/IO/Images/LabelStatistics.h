#pragma once

#include "PalpateIOModule.h"
#include "Segmentation.h"

#include <array>
#include <string>
#include <vector>

namespace palpate
{
/// What there is to count about one structure of a segmentation, on its own voxel grid.
struct LabelStatistics
{
  vtkIdType Voxels = 0;
  double Milliliters = 0.0; ///< voxel count times voxel volume
  /// Smallest and largest index on each axis: x0, x1, y0, y1, z0, z1, inclusive.
  std::array<int, 6> BoundsIndex{{0, -1, 0, -1, 0, -1}};
  /// Faces of the image that the structure reaches, in the order of BoundsIndex.
  std::array<bool, 6> TouchesFace{{false, false, false, false, false, false}};
  /// Voxels of each connected component, falling. Voxels that share a face belong together, as in
  /// the surface that is made of them.
  std::vector<vtkIdType> ComponentVoxels;
  /// Voxels of each cavity, falling: a component (26 neighbours) of the voxels that are not the
  /// structure's, from which the outside of the image cannot be reached. Voxels of other structures
  /// count as not the structure's, and what lies beyond the image as outside.
  std::vector<vtkIdType> CavityVoxels;
  double CavityMilliliters = 0.0;

  PALPATEIO_EXPORT bool TouchesBorder() const;
  /// Names of the faces that the structure reaches by index axis and end, such as "x- z+".
  PALPATEIO_EXPORT std::string FacesText() const;
};

/// The statistics of every segment, in the order of `segmentation.Segments`. A pass over each layer
/// counts, one more for every four million runs of voxels collects these, and the rest works on
/// them, so that time does not grow with the number of structures.
PALPATEIO_EXPORT std::vector<LabelStatistics> MeasureLabels(const Segmentation& segmentation);
} // namespace palpate
