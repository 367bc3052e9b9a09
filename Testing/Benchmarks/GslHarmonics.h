#pragma once

#include "RadialModel.h"

#include <vector>

namespace palpate::bench
{
/// Radius and gradient by the GNU Scientific Library: its normalised Legendre functions and their
/// derivatives for one direction, cosines and sines of the longitude by rotation, and the sum over
/// the coefficients. Directions must not be at the poles.
class GslHarmonics
{
public:
  GslHarmonics(int degree, std::vector<double> coefficients);

  RadialModel::Sample Evaluate(const Vector3& direction);
  double Radius(const Vector3& direction);

private:
  int Degree;
  std::vector<double> Coefficients; // Palpate's convention
  std::vector<double> Values;       // P_lm, in GSL's order
  std::vector<double> Slopes;       // dP_lm / dtheta
};
} // namespace palpate::bench
