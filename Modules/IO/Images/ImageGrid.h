#pragma once

#include "PalpateIOModule.h"
#include "ShearedAxes.h"
#include "Vector3.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// Geometry of an image's voxel grid: patient LPS, mm.
struct ImageGrid
{
  std::array<int, 3> Size{{0, 0, 0}};    ///< voxels along each index axis
  Vector3 Spacing = Vector3::Ones();     ///< mm
  Vector3 OriginWorld = Vector3::Zero(); ///< centre of voxel 0, 0, 0
  Eigen::Matrix3d Direction =
      Eigen::Matrix3d::Identity(); ///< column i: unit vector of index axis i
  bool IsOriented = true;          ///< false: the file does not state the axes in the patient

  std::int64_t VoxelCount() const noexcept
  {
    return static_cast<std::int64_t>(this->Size[0]) * this->Size[1] * this->Size[2];
  }
};

/// Throws InputError for fewer than two voxels along an axis, a spacing that is not positive or
/// that no image has (below 1e-6 or above 1e6 mm), an origin that is not finite, and axes that are
/// not perpendicular unit vectors. The rule for rounded axes is the same for every format: they
/// become the nearest rotation if that moves no voxel by a tenth of a voxel along any axis.
/// Deviations up to 1e-4, as of single precision, are silent and keep the first voxel's place;
/// larger ones keep the volume's centre and add a note. With ShearedAxes::Resample, axes beyond
/// that are kept, as unit vectors, for ResampleSheared. An implausible size (see SizeNote) adds a
/// note too.
PALPATEIO_EXPORT void CheckGrid(const std::filesystem::path& file, ImageGrid& grid,
                                std::vector<std::string>& notes,
                                ShearedAxes sheared = ShearedAxes::Refuse);

/// Whether the axes are not perpendicular, as CheckGrid leaves them with ShearedAxes::Resample.
PALPATEIO_EXPORT bool IsSheared(const ImageGrid& grid);

/// A note if a volume is larger than 3 m or smaller than 2 mm, as if its unit were wrong; otherwise
/// empty.
PALPATEIO_EXPORT std::string SizeNote(const ImageGrid& grid);

/// An image of one scalar array (one tuple per voxel, first index axis fastest) on a grid.
PALPATEIO_EXPORT vtkSmartPointer<vtkImageData> MakeImage(const ImageGrid& grid,
                                                         vtkDataArray* voxels);

PALPATEIO_EXPORT ImageGrid GridOf(vtkImageData* image);

/// Whether no voxel lies elsewhere by more than a thousandth of a voxel, as by rounded headers.
PALPATEIO_EXPORT bool IsSameGrid(const ImageGrid& a, const ImageGrid& b);
} // namespace palpate
