#pragma once

#include "Vector3.h"

#include <array>
#include <functional>
#include <vector>

namespace palpate
{
/// The coefficients up to `degree` of a function on the unit sphere, by a quadrature that is exact
/// for polynomials of `quadratureDegree`: exact up to rounding for a function of degree M if that
/// is at least `degree` + M. Time grows as the product of both degrees squared. Allocates.
std::vector<double> ProjectOnHarmonics(int degree, int quadratureDegree,
                                       const std::function<double(const Vector3&)>& function);
/// The same for the three coordinates of a function.
std::array<std::vector<double>, 3>
ProjectPointsOnHarmonics(int degree, int quadratureDegree,
                         const std::function<Vector3(const Vector3&)>& function);
} // namespace palpate
