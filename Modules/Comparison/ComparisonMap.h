#pragma once

#include "PairComparison.h"
#include "PalpateComparisonModule.h"
#include "RasterImage.h"

#include "vtkLookupTable.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace palpate
{
class ReportPage;

/// The two surfaces of a pair, each with its distances from the other.
class PALPATECOMPARISON_EXPORT ComparisonMap
{
public:
  /// The pair must have its surfaces.
  explicit ComparisonMap(const PairComparison& pair);

  ///@{ Triangles in patient LPS (mm) with the point array "SignedDistance" (mm, negative inside the
  /// other surface), or "Distance" if that one is open.
  vtkPolyData* One() const { return this->OneSurface; }
  vtkPolyData* Other() const { return this->OtherSurface; }
  ///@}
  /// Adds a surface of the two from six sides, coloured by its distances, with a colour bar.
  void AddViews(ReportPage& page, vtkPolyData* surface) const;
  /// The first surface from six sides on white.
  RasterImage Picture() const;

private:
  vtkSmartPointer<vtkPolyData> OneSurface;
  vtkSmartPointer<vtkPolyData> OtherSurface;
  vtkSmartPointer<vtkLookupTable> Colors;
};
} // namespace palpate
