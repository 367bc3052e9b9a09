#include "TextbookHarmonics.h"

#include <cmath>

namespace palpate::test
{
namespace
{
constexpr long double Pi = 3.14159265358979323846264338327950288L;

// P_lm(cosine) without the Condon-Shortley phase, by the recurrence in l from
// P_mm = (2m-1)!! sine^m. The sine is given apart, since 1 - cosine^2 would lose it near the poles.
long double AssociatedLegendre(int degree, int order, long double cosine, long double sine)
{
  long double current = 1.0L;
  for (int k = 1; k <= order; ++k)
  {
    current *= (2 * k - 1) * sine;
  }
  long double previous = 0.0L;
  for (int l = order + 1; l <= degree; ++l)
  {
    const long double next =
        ((2 * l - 1) * cosine * current - (l + order - 1) * previous) / (l - order);
    previous = current;
    current = next;
  }
  return current;
}

// sqrt((2l+1) / (4 pi) (l-m)! / (l+m)!) P_lm(cos theta), without the phase.
long double Normalised(int degree, int order, const Vector3& direction)
{
  const long double x = direction.x();
  const long double y = direction.y();
  const long double z = direction.z();
  const long double length = std::sqrt(x * x + y * y + z * z);
  const long double logRatio =
      std::lgamma(degree - order + 1.0L) - std::lgamma(degree + order + 1.0L);
  return std::sqrt((2 * degree + 1) / (4.0L * Pi)) * std::exp(0.5L * logRatio) *
         AssociatedLegendre(degree, order, z / length, std::hypot(x, y) / length);
}

long double Longitude(const Vector3& direction)
{
  return std::atan2(static_cast<long double>(direction.y()),
                    static_cast<long double>(direction.x()));
}
} // namespace

std::complex<long double> TextbookComplex(int degree, int order, const Vector3& direction)
{
  const long double phase = order % 2 == 0 ? 1.0L : -1.0L;
  return std::polar(1.0L, order * Longitude(direction)) *
         (phase * Normalised(degree, order, direction));
}

long double TextbookReal(int degree, int order, const Vector3& direction)
{
  const int m = std::abs(order);
  const long double q = Normalised(degree, m, direction) * (m == 0 ? 1.0L : std::sqrt(2.0L));
  const long double angle = m * Longitude(direction);
  return q * (order >= 0 ? std::cos(angle) : std::sin(angle));
}
} // namespace palpate::test
