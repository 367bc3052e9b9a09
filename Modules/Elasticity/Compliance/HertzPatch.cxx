#include "HertzPatch.h"

#include "GaussLegendre.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace palpate
{
void HertzPatch::Project(const SphericalHarmonicBasis& basis, double* coefficients) const
{
  // With s = sqrt(1 - (rho/a)^2) the force is 3 s^2 ds times the part of the turn.
  constexpr int Rings = 6;
  constexpr int Spokes = 16;
  // A disc does not follow a hollow that is narrower than itself.
  constexpr double SteepestBend = 0.7;
  constexpr double Turn = 6.28318530717958647692;
  static const GaussLegendre gauss(Rings);
  const auto size = static_cast<Eigen::Index>(basis.Size());
  Eigen::Map<Eigen::VectorXd> sum(coefficients, size);
  Eigen::VectorXd values(size);
  sum.setZero();
  const Vector3 first = this->Normal.unitOrthogonal();
  const Vector3 second = this->Normal.cross(first);
  for (std::size_t ring = 0; ring < Rings; ++ring)
  {
    const double s = 0.5 * (1.0 + gauss.Nodes[ring]);
    const double rho = this->Radius * std::sqrt(1.0 - s * s);
    const double bend = std::clamp(rho * this->Curvature, -SteepestBend, SteepestBend);
    const Vector3 middle =
        this->Point - rho * bend / (1.0 + std::sqrt(1.0 - bend * bend)) * this->Normal;
    const double force = 1.5 * gauss.Weights[ring] * s * s / Spokes;
    for (int spoke = 0; spoke < Spokes; ++spoke)
    {
      const double angle = Turn * (spoke + 0.5 * static_cast<double>(ring % 2)) / Spokes;
      basis.Evaluate(middle + rho * (std::cos(angle) * first + std::sin(angle) * second),
                     values.data());
      sum += force * values;
    }
  }
}

double HertzPatch::Spectrum(double x) noexcept
{
  constexpr double Small = 0.05; // the next term is 1e-9
  const double square = x * x;
  return x < Small ? 1.0 - square / 10.0 + square * square / 280.0
                   : 3.0 * (std::sin(x) - x * std::cos(x)) / (x * square);
}
} // namespace palpate
