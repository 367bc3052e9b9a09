#pragma once

#include "ImageGrid.h"
#include "PalpateIOModule.h"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace palpate
{
/// The two ways in which a NIfTI-1 header says where its voxels lie. Each takes an index
/// (i, j, k, 1) to patient LPS, mm; a code of 0 or less means that the header does not give it.
struct NiftiOrientation
{
  int QFormCode = 0;
  int SFormCode = 0;
  Eigen::Matrix<double, 3, 4> QFormWorld = Eigen::Matrix<double, 3, 4>::Zero();
  Eigen::Matrix<double, 3, 4> SFormWorld = Eigen::Matrix<double, 3, 4>::Zero();
};

/// Sentences on what a user should know of the orientation that ITK chose: none is given, or one of
/// the two would place a corner of the volume elsewhere by more than half the smallest spacing
/// (they disagree, or the sform is sheared or scaled, which ITK does not follow).
PALPATEIO_EXPORT std::vector<std::string> OrientationNotes(const NiftiOrientation& orientation,
                                                           const ImageGrid& grid);
} // namespace palpate
