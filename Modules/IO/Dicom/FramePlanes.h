#pragma once

#include "DicomSource.h"
#include "ImageGrid.h"
#include "PalpateIOModule.h"

#include <Eigen/Core>
#include <vector>

namespace palpate
{
/// The planes on which a segmentation is written for a series: the series' slices if the voxels of
/// both coincide, in whatever order of axes; else as OtherVoxels says.
class PALPATEIO_EXPORT FramePlanes
{
public:
  enum class OtherVoxels
  {
    KeepOwn,    ///< the segmentation's own slices
    TakeNearest ///< the series' slices, with the nearest voxels to their pixels
  };
  /// `mask` is the grid of the segmentation. Throws InputError if it lies outside of the series.
  FramePlanes(const ImageGrid& mask, const DicomSource& source, OtherVoxels others);

  /// Whether the voxels of both coincide.
  bool IsExact() const { return this->Exact; }
  bool IsOnSeries() const { return !this->Origins.empty(); }
  const ImageGrid& Grid() const { return this->Planes; }
  /// Position of a plane's first pixel, mm.
  Vector3 OriginWorld(int plane) const;
  /// The values of a layer of the segmentation at a plane's pixels, row by row; 0 outside.
  void Read(vtkImageData* layer, int plane, std::vector<int>& values) const;

private:
  ImageGrid Planes;
  std::vector<Vector3> Origins; // of the series' slices; empty for own ones
  bool Exact = false;
  Vector3 Start = Vector3::Zero();                     // index in the mask of pixel 0, 0, 0
  Eigen::Matrix3d Steps = Eigen::Matrix3d::Identity(); // of that index along the planes' axes
};
} // namespace palpate
