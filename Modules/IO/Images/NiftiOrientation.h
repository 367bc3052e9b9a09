#pragma once

#include "ImageGrid.h"
#include "PalpateIOModule.h"

#include <Eigen/Core>
#include <filesystem>
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

/// Puts origin and direction of a grid, whose spacing (mm) is set, where the header says. The
/// choice is ITK's, so that places agree with other ITK programs: the only form that is given; of
/// two the sform where it is the scanner's (code 1) or equal to the qform, and neither sheared nor
/// scaled; else the qform. With neither form the axes are L, P, S and the origin is 0. The
/// direction's columns are unit vectors, but perpendicular only as far as the form's are. Throws
/// InputError where the only form is an sform that does not have the grid's spacing.
PALPATEIO_EXPORT void PlaceGrid(const std::filesystem::path& file,
                                const NiftiOrientation& orientation, ImageGrid& grid);

/// Sentences on what a user should know of the orientation that PlaceGrid chose: none is given, or
/// one of the two would place a corner of the volume elsewhere by more than half the smallest
/// spacing (they disagree, or the sform is sheared or scaled, which is not followed).
PALPATEIO_EXPORT std::vector<std::string> OrientationNotes(const NiftiOrientation& orientation,
                                                           const ImageGrid& grid);
} // namespace palpate
