#pragma once

#include "PalpateIOModule.h"
#include "Vector3.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>

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

/// Throws InputError for fewer than two voxels along an axis, a spacing that is not positive, an
/// origin that is not finite, and axes that are not perpendicular. Axes that are perpendicular up
/// to rounding (1e-4, which moves no voxel of a 400 mm volume by 0.05 mm) are made exactly
/// orthonormal.
PALPATEIO_EXPORT void CheckGrid(const std::filesystem::path& file, ImageGrid& grid);

/// An image of one scalar array (one tuple per voxel, first index axis fastest) on a grid.
PALPATEIO_EXPORT vtkSmartPointer<vtkImageData> MakeImage(const ImageGrid& grid,
                                                         vtkDataArray* voxels);

PALPATEIO_EXPORT ImageGrid GridOf(vtkImageData* image);
} // namespace palpate
