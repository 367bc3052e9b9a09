#pragma once

#include "ImageGrid.h"
#include "PalpateIOModule.h"

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
struct StackedSlice
{
  Vector3 PositionWorld = Vector3::Zero(); ///< centre of its first pixel, mm, patient LPS
  Vector3 RowWorld = Vector3::UnitX();     ///< unit vector along a row (growing column index)
  Vector3 ColumnWorld = Vector3::UnitY();  ///< unit vector down a column (growing row index)
  Vector3 Spacing = Vector3::Ones();       ///< mm between columns, between rows; z unused
  int Columns = 0;
  int Rows = 0;
  std::string Name; ///< of its file or frame, for messages; may be empty

  Vector3 NormalWorld() const { return this->RowWorld.cross(this->ColumnWorld); }
  /// "f3.dcm at S 12.5 mm": its name, and its place along the patient axis that its normal is
  /// closest to.
  std::string Place() const;
  /// Same orientation (1e-4), pixel spacing and size.
  bool IsParallelTo(const StackedSlice& other) const;
};

/// A position along the patient axis that a normal is closest to: "S 12.5 mm".
std::string PlaceAlong(const Vector3& normalWorld, const Vector3& positionWorld);

/// Parallel slices, ordered along their normal.
struct SliceStack
{
  ImageGrid Grid;                 ///< its third axis is that of the positions (see CheckGrid)
  std::vector<int> SliceOfPlane;  ///< slice index of each given plane
  std::vector<std::string> Notes; ///< on positions that were not even, as sentences
};

struct SliceStackRules
{
  /// Slices may be absent and several planes may lie in one slice (a segmentation's frames).
  bool Sparse = false;
  /// Slice spacing stated by the file (mm). Used if the planes' positions agree with it.
  std::optional<double> StatedStep;
};

/// Orders parallel planes along their normal. Positions within 2 % of the spacing and a tenth of a
/// pixel of even ones are taken as they are. Beyond that, as if they were rounded, slices get the
/// straight line closest to them if that moves none by a tenth of a voxel, with a note; a line that
/// is not along the normal makes the grid sheared, which CheckGrid judges. Throws InputError, which
/// names slices and their positions, for larger deviations (a missing slice), more than 65,536
/// slices, and, unless sparse, several planes at one position; if sparse, also for sheared stacks.
PALPATEIO_EXPORT SliceStack StackSlices(const std::filesystem::path& file,
                                        const std::vector<StackedSlice>& planes,
                                        const SliceStackRules& rules);
} // namespace palpate
