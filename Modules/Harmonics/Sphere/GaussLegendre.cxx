#include "GaussLegendre.h"

#include <cmath>

namespace palpate
{
namespace
{
constexpr long double Pi = 3.14159265358979323846264338327950288L;

struct LegendreValue
{
  long double Value;
  long double Derivative;
};

LegendreValue EvaluateLegendre(int degree, long double x)
{
  long double previous = 1.0L;
  long double current = x;
  for (int k = 2; k <= degree; ++k)
  {
    const long double next = ((2 * k - 1) * x * current - (k - 1) * previous) / k;
    previous = current;
    current = next;
  }
  return {current, degree * (x * current - previous) / (x * x - 1.0L)};
}
} // namespace

GaussLegendre::GaussLegendre(int nodeCount)
    : Nodes(static_cast<std::size_t>(nodeCount)), Weights(static_cast<std::size_t>(nodeCount))
{
  for (int i = 0; i < nodeCount; ++i)
  {
    long double x = -std::cos(Pi * (i + 0.75L) / (nodeCount + 0.5L));
    // Newton converges quadratically from this guess; six steps pass long double precision.
    for (int step = 0; step < 6; ++step)
    {
      const LegendreValue p = EvaluateLegendre(nodeCount, x);
      x -= p.Value / p.Derivative;
    }
    const long double slope = EvaluateLegendre(nodeCount, x).Derivative;
    this->Nodes[static_cast<std::size_t>(i)] = static_cast<double>(x);
    this->Weights[static_cast<std::size_t>(i)] =
        static_cast<double>(2.0L / ((1.0L - x * x) * slope * slope));
  }
}
} // namespace palpate
