#pragma once

#include "PalpateDisplayModule.h"
#include "Vector3.h"

#include "vtkSmartPointer.h"

#include <Eigen/Core>
#include <array>

class vtkImageData;
class vtkPolyData;

namespace palpate
{
/// The geometry of an image with its direction matrix, without VTK's lookups. World is patient LPS,
/// mm; indices are the image's own, which need not start at 0.
struct PALPATEDISPLAY_EXPORT ImageAxes
{
  explicit ImageAxes(vtkImageData* image);

  Vector3 ToWorld(const Vector3& index) const
  {
    return this->OriginWorld + this->StepWorld * index;
  }
  Vector3 ToIndex(const Vector3& world) const
  {
    return this->WorldToIndex * (world - this->OriginWorld);
  }
  /// Corners of the box of all voxels, half a voxel beyond the outermost centres. Corner c is at
  /// the upper end of axis a if bit a of c is set.
  std::array<Vector3, 8> CornersWorld() const;
  int Size(int axis) const { return this->Extent[2 * axis + 1] - this->Extent[2 * axis] + 1; }

  std::array<int, 6> Extent{};
  std::array<double, 3> Spacing{};       ///< mm
  std::array<Vector3, 3> UnitWorld;      ///< along each index axis
  Vector3 OriginWorld = Vector3::Zero(); ///< of index (0, 0, 0)
  Eigen::Matrix3d StepWorld;             ///< columns: the step of one index along each axis, mm
  Eigen::Matrix3d WorldToIndex;
};

/// The sides of a box with its corners in the order of CornersWorld.
PALPATEDISPLAY_EXPORT vtkSmartPointer<vtkPolyData> MakeBox(const std::array<Vector3, 8>& corners);
} // namespace palpate
