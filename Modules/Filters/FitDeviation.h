#pragma once

#include "PalpateFiltersModule.h"
#include "Vector3.h"
#include "vtkDoubleArray.h"
#include "vtkSmartPointer.h"

#include <Eigen/Core>
#include <vector>

namespace palpate
{
/// One standard deviation (mm) of a fitted series at each direction, from the factor of its
/// covariance (CoefficientCovariance::Factor).
PALPATEFILTERS_EXPORT vtkSmartPointer<vtkDoubleArray>
FitDeviation(const Eigen::MatrixXd& factor, const std::vector<Vector3>& directions,
             const char* name);
} // namespace palpate
