#include "PoseConstraints.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
void PoseConstraints::Add(const PoseConstraint& constraint) noexcept
{
  if (this->Count < Most)
  {
    this->All[this->Count++] = constraint;
    return;
  }
  const auto farthest =
      std::max_element(this->All.begin(), this->All.end(),
                       [](const auto& a, const auto& b) { return a.Gap < b.Gap; });
  if (constraint.Gap < farthest->Gap)
  {
    *farthest = constraint;
  }
}

void PoseConstraints::ForgetPushes() noexcept
{
  for (std::size_t n = 0; n < this->Count; ++n)
  {
    this->All[n].Push = 0.0;
  }
}

Twist PoseConstraints::Solve(const Twist& wanted, double length) noexcept
{
  constexpr int MostSweeps = 60;
  constexpr double Settled = 1e-9; // mm, of the multipliers
  const double perTurn = 1.0 / (length * length);
  Twist twist = wanted;
  const auto push = [&](const PoseConstraint& at, double by)
  {
    twist.Shift += by * at.Normal;
    twist.Turn += by * perTurn * at.Arm.cross(at.Normal);
  };
  for (std::size_t n = 0; n < this->Count; ++n)
  {
    push(this->All[n], this->All[n].Push);
  }
  for (int sweep = 0; sweep < MostSweeps; ++sweep)
  {
    double change = 0.0;
    for (std::size_t n = 0; n < this->Count; ++n)
    {
      PoseConstraint& at = this->All[n];
      const Vector3 lever = at.Arm.cross(at.Normal);
      const double left = at.Normal.dot(twist.Shift) + lever.dot(twist.Turn) + at.Gap;
      const double stiffness = 1.0 + perTurn * lever.squaredNorm();
      const double by = std::max(-at.Push, -left / stiffness);
      at.Push += by;
      push(at, by);
      change = std::max(change, std::abs(by));
    }
    if (change < Settled)
    {
      break;
    }
  }
  return twist;
}
} // namespace palpate
