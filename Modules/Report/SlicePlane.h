#pragma once

#include "PalpateReportModule.h"
#include "PixelGrid.h"
#include "Vector3.h"

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

class vtkImageData;

namespace palpate
{
/// Plane of a slice image: a plane of an image's voxel centres, cropped around a structure, with
/// square pixels. World is patient LPS, mm. Image coordinates are those of SVG: (0, 0) is the top
/// left corner of the top left pixel, whose centre is at (0.5, 0.5).
struct PALPATEREPORT_EXPORT SlicePlane
{
  std::string Name;    ///< "Axial", "Sagittal" or "Coronal"
  Vector3 CornerWorld; ///< of the image's top left corner
  Vector3 RightWorld;  ///< unit vectors along the image's axes
  Vector3 DownWorld;
  double PixelMillimeters = 1.0;
  int Width = 0; ///< pixels
  int Height = 0;
  int RightAxis = 0; ///< voxel axes along the image's axes
  int DownAxis = 1;
  int SliceAxis = 2;
  int SliceIndex = 0;  ///< along SliceAxis
  int SliceNumber = 1; ///< the same, counted from 1
  int SliceCount = 1;

  Vector3 ToWorld(const Eigen::Vector2d& raster) const
  {
    return this->CornerWorld +
           this->PixelMillimeters * (raster.x() * this->RightWorld + raster.y() * this->DownWorld);
  }
  Eigen::Vector2d ToImage(const Vector3& world) const
  {
    const Vector3 offset = (world - this->CornerWorld) / this->PixelMillimeters;
    return {offset.dot(this->RightWorld), offset.dot(this->DownWorld)};
  }
  PixelGrid Pixels() const
  {
    return {this->ToWorld({0.5, 0.5}), this->PixelMillimeters * this->RightWorld,
            this->PixelMillimeters * this->DownWorld, this->Width, this->Height};
  }
  /// Unit normal, away from the viewer.
  Vector3 NormalWorld() const;
};

/// Planes through the voxels of `mask` that have `value`: `axialCount` axial ones from end to end
/// of the structure, then a sagittal and a coronal one through its centre, in radiological
/// convention. They follow the mask's own axes; the axial planes are perpendicular to the axis
/// closest to the body's. All have the same scale: the longest side is `longestSide` pixels. Empty
/// if no voxel has the value.
PALPATEREPORT_EXPORT std::vector<SlicePlane> ChooseSlicePlanes(vtkImageData* mask, int value,
                                                               int axialCount, int longestSide);

/// The axial plane of voxels that is nearest to each point, to the same scale as those. Empty if no
/// voxel has the value.
PALPATEREPORT_EXPORT std::vector<SlicePlane> SlicePlanesAt(const std::vector<Vector3>& pointsWorld,
                                                           vtkImageData* mask, int value,
                                                           int longestSide);
} // namespace palpate
