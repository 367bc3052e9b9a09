#pragma once

#include "ImageGrid.h"
#include "PalpateIOModule.h"

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <vector>

namespace palpate
{
struct SlicePlane
{
  Vector3 PositionWorld = Vector3::Zero(); ///< centre of its first pixel, mm, patient LPS
  Vector3 RowWorld = Vector3::UnitX();     ///< unit vector along a row (growing column index)
  Vector3 ColumnWorld = Vector3::UnitY();  ///< unit vector down a column (growing row index)
  Vector3 Spacing = Vector3::Ones();       ///< mm between columns, between rows; z unused
  int Columns = 0;
  int Rows = 0;

  Vector3 NormalWorld() const { return this->RowWorld.cross(this->ColumnWorld); }
  /// Same orientation (1e-4), pixel spacing and size.
  bool IsParallelTo(const SlicePlane& other) const;
};

/// Parallel slices, ordered along their normal.
struct SliceStack
{
  ImageGrid Grid;
  std::vector<int> SliceOfPlane; ///< slice index of each given plane
};

struct SliceStackRules
{
  /// Slices may be absent and several planes may lie in one slice (a segmentation's frames).
  bool Sparse = false;
  /// Slice spacing stated by the file (mm). Used if the planes' positions agree with it.
  std::optional<double> StatedStep;
};

/// Orders parallel planes along their normal. Throws InputError for uneven slice spacing (by more
/// than 2 %), more than 65,536 slices, planes that drift sideways by more than a tenth of a pixel
/// (a sheared volume), and, unless sparse, several planes at one position.
PALPATEIO_EXPORT SliceStack StackSlices(const std::filesystem::path& file,
                                        const std::vector<SlicePlane>& planes,
                                        const SliceStackRules& rules);
} // namespace palpate
