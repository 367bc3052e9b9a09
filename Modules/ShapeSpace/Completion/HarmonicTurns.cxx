#include "HarmonicTurns.h"

#include <cmath>

namespace palpate
{
HarmonicTurns::HarmonicTurns(int degree) : Degree(degree), Ladder((degree + 1) * (degree + 2) / 2)
{
  Eigen::Index at = 0;
  for (int l = 0; l <= degree; ++l)
  {
    for (int m = 0; m <= l; ++m)
    {
      // sqrt(2) for the step from or to order 0, whose harmonic has no partner.
      this->Ladder[at++] = (m == 0 ? std::sqrt(0.5) : 0.5) * std::sqrt((l - m) * (l + m + 1.0));
    }
  }
}

void HarmonicTurns::Turn(const Vector3& axis, const double* coefficients,
                         double* turned) const noexcept
{
  const double* step = this->Ladder.data();
  for (int l = 0; l <= this->Degree; ++l)
  {
    const double* from = coefficients + l * (l + 1);
    double* to = turned + l * (l + 1);
    to[0] = 0.0;
    for (int m = 1; m <= l; ++m)
    {
      // About z: cosines of order m become -m sines, sines m cosines.
      to[m] = axis[2] * m * from[-m];
      to[-m] = -axis[2] * m * from[m];
    }
    for (int m = 0; m < l; ++m)
    {
      // About x and y: order m to m + 1, and back with the other sign. Order 0 has no sines.
      const double x = step[m] * axis[0];
      const double y = step[m] * axis[1];
      const double sine = m > 0 ? from[-m] : 0.0;
      to[m + 1] += -x * sine - y * from[m];
      to[-m - 1] += x * from[m] - y * sine;
      to[m] += y * from[m + 1] - x * from[-m - 1];
      if (m > 0)
      {
        to[-m] += x * from[m + 1] + y * from[-m - 1];
      }
    }
    step += l + 1;
  }
}
} // namespace palpate
