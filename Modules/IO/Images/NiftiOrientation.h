#pragma once

#include "ImageGrid.h"
#include "PalpateIOModule.h"

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// The two transforms by which a NIfTI-1 header places its voxels. Each maps an index (i, j, k, 1)
/// to patient LPS, mm; a code of 0 or less means that the transform is absent.
struct NiftiOrientation
{
  int QFormCode = 0;
  int SFormCode = 0;
  Eigen::Matrix<double, 3, 4> QFormWorld = Eigen::Matrix<double, 3, 4>::Zero();
  Eigen::Matrix<double, 3, 4> SFormWorld = Eigen::Matrix<double, 3, 4>::Zero();
};

/// Sets origin and direction of a grid, whose spacing (mm) is set, from the header. The choice is
/// ITK's, so that positions agree with other ITK programs: the only transform given; of two the
/// sform if it is the scanner's (code 1) or equal to the qform, and neither sheared nor scaled;
/// otherwise the qform. With neither, the axes are L, P, S and the origin is 0. The direction's
/// columns are unit vectors, but only as perpendicular as the transform's; of a sheared sform whose
/// voxel sizes differ from the grid's, the grid gets the sform's. Throws InputError if the only
/// transform is an sform that is not sheared and has other voxel sizes, which would move a voxel by
/// a tenth of one.
PALPATEIO_EXPORT void PlaceGrid(const std::filesystem::path& file,
                                const NiftiOrientation& orientation, ImageGrid& grid);

/// Notes for the user on the orientation chosen by PlaceGrid: none is given, or one of the two
/// would move a corner of the volume by more than half the smallest spacing (they disagree, or the
/// sform is sheared or scaled, which is not followed).
PALPATEIO_EXPORT std::vector<std::string> OrientationNotes(const NiftiOrientation& orientation,
                                                           const ImageGrid& grid);
} // namespace palpate
