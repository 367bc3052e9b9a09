#include "SphericalHarmonicRecurrence.h"

#include <cmath>

namespace palpate
{
SphericalHarmonicRecurrence::SphericalHarmonicRecurrence(int degree) : MaximumDegree(degree)
{
  double diagonal = 1.0 / std::sqrt(4.0 * M_PI);
  this->Diagonals.push_back(diagonal);
  for (int m = 1; m <= degree; ++m)
  {
    diagonal *= std::sqrt((2.0 * m + 1.0) / (m == 1 ? 1.0 : 2.0 * m));
    this->Diagonals.push_back(diagonal);
  }
  for (int m = 0; m <= degree; ++m)
  {
    for (int l = m + 1; l <= degree; ++l)
    {
      const double l2 = static_cast<double>(l) * l;
      const double m2 = static_cast<double>(m) * m;
      const double k2 = (l - 1.0) * (l - 1.0);
      this->Terms.push_back({std::sqrt((4.0 * l2 - 1.0) / (l2 - m2)),
                             l == m + 1 ? 0.0 : std::sqrt((k2 - m2) / (4.0 * k2 - 1.0))});
    }
  }
}
} // namespace palpate
