#include "ToolSkeleton.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
ToolSkeleton::ToolSkeleton(std::vector<Ball> balls) : All(std::move(balls))
{
  constexpr double LeastLength = 1e-3; // mm, of a point
  double squares = 0.0;
  double thickest = LeastLength;
  for (const Ball& ball : this->All)
  {
    this->Extent = std::max(this->Extent, ball.Center.norm() + ball.Radius);
    squares += ball.Center.squaredNorm() / static_cast<double>(this->All.size());
    thickest = std::max(thickest, ball.Radius);
  }
  this->TurnLength = std::max(std::sqrt(squares), thickest);
}

ToolSkeleton ToolSkeleton::Capsule(double radius, double length, int count)
{
  std::vector<Ball> balls;
  for (int n = 0; n < count; ++n)
  {
    const double part = count > 1 ? static_cast<double>(n) / (count - 1) - 0.5 : 0.0;
    balls.push_back({part * length * Vector3::UnitZ(), radius});
  }
  return ToolSkeleton(std::move(balls));
}

ToolSkeleton ToolSkeleton::Drill(double radius, double shaftRadius, double shaftLength, int count)
{
  std::vector<Ball> balls{{Vector3::Zero(), radius}};
  for (int n = 1; n <= count; ++n)
  {
    balls.push_back({shaftLength * n / count * Vector3::UnitZ(), shaftRadius});
  }
  return ToolSkeleton(std::move(balls));
}
} // namespace palpate
