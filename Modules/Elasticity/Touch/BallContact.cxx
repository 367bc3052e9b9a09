#include "BallContact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace palpate
{
namespace
{
// The mean gap and its derivatives by the patch's radius.
struct Gap
{
  double Value;
  double First;
  double Second;
};

// Mean of r - sqrt(r^2 - rho^2) over a Hertz bump, as a series: r times the sum of 3 / ((2k - 1)
// (2k + 1) (2k + 3)) (a/r)^2k. The surface is flatter than the ball and needs fewer terms.
class BallOnPlace
{
public:
  BallOnPlace(double ballRadius, double curvature) noexcept
      : Ball(1.0 / ballRadius), Place(curvature)
  {
  }

  Gap At(double a) const noexcept
  {
    constexpr std::size_t TermsOfPlace = 2;
    const double x = this->Ball * a;
    const double y = this->Place * a;
    double value = 0.0;
    double first = 0.0;
    double second = 0.0;
    double xPower = x; // x^(2k - 1)
    double yPower = y;
    for (std::size_t k = 1; k <= Terms.size(); ++k)
    {
      const double power = 2.0 * static_cast<double>(k);
      const double sum = Terms[k - 1] * (xPower + (k <= TermsOfPlace ? yPower : 0.0));
      value += sum;
      first += power * sum;
      second += power * (power - 1.0) * sum;
      xPower *= x * x;
      yPower *= y * y;
    }
    return {a * value, first, second / a};
  }

private:
  // With them the gap is within 0.3 % for a patch of 0.95 times the ball.
  static constexpr std::array<double, 6> Terms{1.0 / 5,   1.0 / 35,  1.0 / 105,
                                               1.0 / 231, 1.0 / 429, 1.0 / 715};

  double Ball;  // 1/mm
  double Place; // 1/mm
};

// Where a patch carries the depth; and its growth.
struct Balance
{
  double Depth;  // mm
  double Growth; // of the depth by the patch's radius
  double Force;  // N
};

// No depth makes a patch grow that far where a larger one would yield more.
Balance BalanceAt(const Gap& gap, const PatchCompliance::Value& c) noexcept
{
  if (!(c.First < 0.0 && c.Compliance > 0.0))
  {
    return {std::numeric_limits<double>::infinity(), 1.0, 0.0};
  }
  const double ratio = c.Compliance / c.First;
  return {gap.Value - 2.0 * gap.First * ratio,
          -gap.First - 2.0 * gap.Second * ratio + 2.0 * gap.First * ratio * c.Second / c.First,
          -2.0 * gap.First / c.First};
}

BallContact Linear(double depth, const Gap& gap, double radius, double compliance) noexcept
{
  const double force = (depth - gap.Value) / compliance;
  return {force, radius, 0.5 * force * (depth - gap.Value), 1.0 / compliance, true};
}
} // namespace

BallContact BallContact::Of(double depth, double ballRadius, double meanCurvature,
                            const PatchCompliance& place, double start) noexcept
{
  constexpr int MostSteps = 30;
  constexpr double Tolerance = 1e-12; // of the depth
  if (!(depth > 0.0) || !(1.0 / ballRadius + meanCurvature > 0.0))
  {
    return {0.0, 0.0, 0.0, 0.0, false};
  }
  const BallOnPlace ball(ballRadius, meanCurvature);
  double low = 0.0;
  double high = place.LargestRadius;
  {
    const Gap gap = ball.At(high);
    const PatchCompliance::Value c = place.At(high);
    if (BalanceAt(gap, c).Depth <= depth)
    {
      return Linear(depth, gap, high, c.Compliance);
    }
  }
  const double hertz = std::sqrt(depth / (1.0 / ballRadius + meanCurvature));
  double a = start > 0.0 && start < high ? start : std::min(hertz, 0.9 * high);
  BallContact contact{0.0, 0.0, 0.0, 0.0, false};
  for (int step = 0; step < MostSteps; ++step)
  {
    const Gap gap = ball.At(a);
    const PatchCompliance::Value c = place.At(a);
    const Balance balance = BalanceAt(gap, c);
    const double error = balance.Depth - depth;
    contact = {balance.Force, a, 0.0, 0.0, false};
    contact.Energy =
        contact.Force * (depth - gap.Value) - 0.5 * contact.Force * contact.Force * c.Compliance;
    const double growth = 2.0 * (gap.First * c.Second / c.First - gap.Second) / c.First;
    contact.Slope = growth / balance.Growth;
    if (std::abs(error) <= Tolerance * depth)
    {
      break;
    }
    (error > 0.0 ? high : low) = a;
    const double next = a - error / balance.Growth;
    a = next > low && next < high ? next : 0.5 * (low + high);
  }
  return contact;
}

double BallContact::EnergyByCurvature(double meanCurvature) const noexcept
{
  const double aa = this->PatchRadius * this->PatchRadius;
  return -this->Force * (aa / 5.0 + 3.0 * aa * aa * meanCurvature * meanCurvature / 35.0);
}
} // namespace palpate
