#include "ToolSkeleton.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
// The ball that touches an ellipsoid from inside at the image of a unit vector, centred on the
// plane across the shortest axis: by the normal there.
ToolSkeleton::Ball BallInEllipsoid(const Vector3& semiAxes, int shortest, const Vector3& unit)
{
  const double square = semiAxes[shortest] * semiAxes[shortest];
  const Vector3 normal = unit.cwiseQuotient(semiAxes);
  Vector3 center = semiAxes.cwiseProduct(unit) - square * normal;
  center[shortest] = 0.0;
  return {center, square * normal.norm()};
}

void AddRing(const ToolSkeleton::Ball& like, double across, double apart,
             std::vector<ToolSkeleton::Ball>& balls)
{
  const int count = std::max(1, static_cast<int>(std::ceil(2.0 * EIGEN_PI * across / apart)));
  for (int n = 0; n < count; ++n)
  {
    const double angle = 2.0 * EIGEN_PI * n / count;
    ToolSkeleton::Ball ball = like;
    ball.Center += across * Vector3(std::cos(angle), std::sin(angle), 0.0);
    balls.push_back(ball);
  }
}
} // namespace

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
  this->Group(0, this->All.size());
}

// Halves along the longest extent until few are left.
void ToolSkeleton::Group(std::size_t begin, std::size_t end)
{
  Eigen::AlignedBox3d box;
  for (std::size_t n = begin; n < end; ++n)
  {
    box.extend(this->All[n].Center);
  }
  const auto first = this->All.begin();
  const auto at = [&](std::size_t n) { return first + static_cast<std::ptrdiff_t>(n); };
  if (end - begin > ClusterSize)
  {
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const std::size_t middle = begin + (end - begin) / 2;
    std::stable_sort(at(begin), at(end),
                     [axis](const Ball& a, const Ball& b)
                     { return a.Center[axis] < b.Center[axis]; });
    this->Group(begin, middle);
    this->Group(middle, end);
    return;
  }
  Cluster cluster{begin, end, box.center(), 0.0};
  for (std::size_t n = begin; n < end; ++n)
  {
    cluster.Radius = std::max(cluster.Radius,
                              (this->All[n].Center - cluster.Center).norm() + this->All[n].Radius);
  }
  this->Groups.push_back(cluster);
}

int ToolSkeleton::CountAlong(double radius, double length)
{
  constexpr double Most = 256.0;
  constexpr double Dense = 0.5; // mm
  const double spacing = std::max(0.5 * radius, std::min(radius, Dense));
  return 1 + static_cast<int>(std::clamp(std::ceil(length / spacing), 0.0, Most - 1.0));
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
    const double height = shaftLength * n / count;
    if (height + shaftRadius > radius)
    {
      balls.push_back({height * Vector3::UnitZ(), shaftRadius, false});
    }
  }
  return ToolSkeleton(std::move(balls));
}

ToolSkeleton ToolSkeleton::Cylinder(double radius, double length, double rim)
{
  constexpr double Apart = 0.2; // radii
  const double apart = Apart * radius;
  const double side = std::max(0.5 * length - radius, 0.0); // of the axis, from its middle
  std::vector<Ball> balls;
  if (side > 0.0)
  {
    balls = Capsule(radius, 2.0 * side, CountAlong(radius, 2.0 * side)).All;
  }
  for (const double up : {-1.0, 1.0})
  {
    const Ball end{up * (0.5 * length - rim) * Vector3::UnitZ(), rim};
    for (double across = radius - rim; across > 0.0; across -= apart)
    {
      AddRing(end, across, apart, balls);
    }
    for (double height = end.Center.norm() - apart; height > side; height -= apart)
    {
      AddRing({up * height * Vector3::UnitZ(), rim}, radius - rim, apart, balls);
    }
  }
  return ToolSkeleton(std::move(balls));
}

ToolSkeleton ToolSkeleton::Ellipsoid(const Vector3& semiAxes)
{
  constexpr double Equal = 1.001; // of two axes
  constexpr int OnLine = 129;
  constexpr int OnDisc = 256;
  int shortest = 0;
  int longest = 0;
  semiAxes.minCoeff(&shortest);
  semiAxes.maxCoeff(&longest);
  if (semiAxes[longest] < Equal * semiAxes[shortest])
  {
    return ToolSkeleton({{Vector3::Zero(), semiAxes[shortest]}});
  }
  const int middle = 3 - shortest - longest;
  const bool isLine = semiAxes[middle] < Equal * semiAxes[shortest];
  const int count = isLine ? OnLine : OnDisc;
  std::vector<Ball> balls;
  for (int n = 0; n < count; ++n)
  {
    Vector3 unit = Vector3::Zero();
    if (isLine) // at equal angles of the surface's normals
    {
      const double angle = EIGEN_PI * n / (count - 1);
      unit[longest] = std::cos(angle);
      unit[shortest] = std::sin(angle);
      unit = unit.cwiseProduct(semiAxes).normalized();
    }
    else // on a spiral of equal areas, to the rim
    {
      const double angle = n * EIGEN_PI * (3.0 - std::sqrt(5.0));
      const double out = std::sqrt(n / (count - 1.0));
      unit[longest] = out * std::cos(angle);
      unit[middle] = out * std::sin(angle);
      unit[shortest] = std::sqrt(std::max(0.0, 1.0 - out * out));
    }
    balls.push_back(BallInEllipsoid(semiAxes, shortest, unit));
  }
  ToolSkeleton tool(std::move(balls));
  tool.SemiAxes = semiAxes;
  tool.Apart =
      semiAxes[longest] * (isLine ? EIGEN_PI / OnLine : std::sqrt(2.0 * EIGEN_PI / OnDisc));
  return tool;
}

Vector3 ToolSkeleton::PointAgainst(const Vector3& direction, const Ball& ball) const noexcept
{
  const Vector3 own = ball.Center - ball.Radius * direction;
  if (this->Apart <= 0.0)
  {
    return own;
  }
  const Vector3 scaled = this->SemiAxes.cwiseProduct(direction);
  const Vector3 lowest = -this->SemiAxes.cwiseProduct(scaled) / scaled.norm();
  return (lowest - own).squaredNorm() < this->Apart * this->Apart ? lowest : own;
}
} // namespace palpate
