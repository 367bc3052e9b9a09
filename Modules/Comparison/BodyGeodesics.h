#pragma once

#include "ComparedFile.h"
#include "ModelPaths.h"
#include "PalpateComparisonModule.h"
#include "Progress.h"
#include "SurfacePaths.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <optional>
#include <vector>

namespace palpate
{
/// Distances along the surface of a file's structure (mm, patient LPS): of a model on the model
/// itself, of others on the triangles of their surface; a mask's is its shape (MaskBody::Shape).
class PALPATECOMPARISON_EXPORT BodyGeodesics
{
public:
  struct Length
  {
    Vector3 From;                      ///< on the surface
    Vector3 To;                        ///< on the surface
    double Along;                      ///< mm
    double Direct;                     ///< mm, through space
    std::optional<double> Uncertainty; ///< mm, of a model: what its chords leave open
    std::vector<Vector3> Points;       ///< of the path, from end to end
  };
  static constexpr const char* MapName = "DistanceAlongSurface"; ///< of the array, mm

  /// Throws InputError if the structure has no surface that can be measured.
  BodyGeodesics(const ComparedFile& file, const Segment& structure);

  /// Between the surface's points that are nearest to these. Throws InputError if no path connects
  /// them, and Cancelled.
  Length Find(const Vector3& from, const Vector3& to, const ProgressFunction& progress) const;
  /// The surface, with the lengths from one of its points as an array of its points; infinite on
  /// parts that are not connected. Throws Cancelled.
  vtkSmartPointer<vtkPolyData> Map(const Vector3& from, const ProgressFunction& progress) const;
  bool IsOnModel() const { return this->OnModel != nullptr; }

private:
  std::shared_ptr<const ModelPaths> OnModel;
  std::shared_ptr<const SurfacePaths> OnTriangles; ///< unless it is a model
};

/// The paths as lines. Allocates.
PALPATECOMPARISON_EXPORT vtkSmartPointer<vtkPolyData>
LinesOf(const std::vector<BodyGeodesics::Length>& lengths);
} // namespace palpate
