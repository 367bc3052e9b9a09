#include "SphericalHarmonicRecurrence.h"

#include <cmath>

namespace palpate
{
SphericalHarmonicRecurrence::SphericalHarmonicRecurrence(int degree) : MaximumDegree(degree)
{
  // In long double, so that every constant is rounded only once.
  long double diagonal = 1.0L / std::sqrt(16.0L * std::atan(1.0L)); // 1 / sqrt(4 pi)
  this->Diagonals.push_back(static_cast<double>(diagonal));
  for (int m = 1; m <= degree; ++m)
  {
    diagonal *= std::sqrt((2.0L * m + 1.0L) / (m == 1 ? 1.0L : 2.0L * m));
    this->Diagonals.push_back(static_cast<double>(diagonal));
  }
  const auto size = static_cast<std::size_t>(degree);
  this->Terms.reserve(size * (size + 1) / 2);
  for (int m = 0; m <= degree; ++m)
  {
    for (int l = m + 1; l <= degree; ++l)
    {
      const long double odd = 2.0L * l - 1.0L;
      const long double a =
          std::sqrt(odd * (odd + 2.0L) / (static_cast<long double>(l - m) * (l + m)));
      this->Terms.push_back({static_cast<double>(a * (l + m) / odd),
                             static_cast<double>(a * (l - 1 - m) / odd), static_cast<double>(a)});
    }
  }
}
} // namespace palpate
