#pragma once

#include "ComparedFile.h"
#include "PalpateComparisonModule.h"
#include "Progress.h"
#include "SurfaceGeodesics.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace palpate
{
/// Distances along the surface of a file's structure (mm, patient LPS); a mask's is its shape
/// (MaskBody::Shape).
class PALPATECOMPARISON_EXPORT BodyGeodesics
{
public:
  using Length = SurfaceGeodesics::Length;
  static constexpr const char* MapName = "DistanceAlongSurface"; ///< of the array, mm

  /// Throws InputError if the structure has no surface that can be measured.
  BodyGeodesics(const ComparedFile& file, const Segment& structure);

  /// As SurfaceGeodesics::Find. Throws InputError if no path connects them, and Cancelled.
  Length Find(const Vector3& from, const Vector3& to, const ProgressFunction& progress) const;
  /// The surface, with the lengths from one of its points as an array of its points; infinite on
  /// parts that are not connected. Throws Cancelled.
  vtkSmartPointer<vtkPolyData> Map(const Vector3& from, const ProgressFunction& progress) const;
  bool IsOnModel() const { return this->Paths.IsOnModel(); }

private:
  SurfaceGeodesics Paths;
};

/// The paths as lines. Allocates.
PALPATECOMPARISON_EXPORT vtkSmartPointer<vtkPolyData>
LinesOf(const std::vector<BodyGeodesics::Length>& lengths);
} // namespace palpate
