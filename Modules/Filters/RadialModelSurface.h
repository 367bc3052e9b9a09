#pragma once

#include "IndexedMesh.h"
#include "PalpateFiltersModule.h"
#include "RadialModel.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <Eigen/Core>

namespace palpate
{
/// What a drawn model is compared with; null: with nothing.
struct RadialComparison
{
  const Eigen::MatrixXd* Factor = nullptr; ///< of the fit (CoefficientCovariance::Factor)
  const IndexedMesh* Original = nullptr;   ///< closed surface, world mm
};

/// Triangulates a radial model over the icosahedron of a frequency, 10 f^2 + 2 points in world mm,
/// with analytic outward normals and the point array "Radius" (mm). With a factor also
/// "RadiusDeviation" (mm, one standard deviation of the fitted radius); with an original also
/// "DistanceToSurface" (mm to its nearest point, positive where the model lies outside it) and
/// "Residual" (mm, the original's outermost radius minus the model's; NaN along directions that
/// miss the original).
PALPATEFILTERS_EXPORT vtkSmartPointer<vtkPolyData>
DrawRadialModel(const RadialModel& model, int frequency, const RadialComparison& compared = {});
} // namespace palpate
