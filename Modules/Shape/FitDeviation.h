#pragma once

#include "PalpateShapeModule.h"
#include "Vector3.h"
#include "vtkDoubleArray.h"
#include "vtkSmartPointer.h"

#include <Eigen/Core>
#include <vector>

namespace palpate
{
using CovarianceFactor =
    Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

/// One standard deviation (mm) of a fitted series at each direction, from the factor of its
/// covariance (CoefficientCovariance::Factor).
PALPATESHAPE_EXPORT vtkSmartPointer<vtkDoubleArray>
FitDeviation(const CovarianceFactor& factor, const std::vector<Vector3>& directions,
             const char* name);
} // namespace palpate
