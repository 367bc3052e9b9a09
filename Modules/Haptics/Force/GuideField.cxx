#include "GuideField.h"

#include "PositiveNumber.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
// Of k R: D (1 - D^2/R^2)^2 at D = R / sqrt(5).
const double LargestPart = 16.0 / (25.0 * std::sqrt(5.0));

std::size_t LeastPoints(GuideShape shape)
{
  return shape == GuideShape::Point ? 1 : shape == GuideShape::Path ? 2 : 3;
}

Vector3 AcrossThree(const std::vector<Vector3>& points)
{
  return (points[1] - points[0]).cross(points[2] - points[0]);
}

Vector3 NearestOnLine(const Vector3& from, const Vector3& to, const Vector3& place) noexcept
{
  const Vector3 line = to - from;
  const double square = line.squaredNorm();
  const double part = square > 0.0 ? (place - from).dot(line) / square : 0.0;
  return from + std::clamp(part, 0.0, 1.0) * line;
}
} // namespace

GuideField::GuideField(const GuideSettings& settings)
    : Shape(settings.Shape), Points(settings.PointsWorld), Range(settings.Range),
      Spring(std::min(settings.Stiffness, settings.LargestForce / (LargestPart * settings.Range)))
{
  if (this->Shape == GuideShape::Plane)
  {
    this->Normal = AcrossThree(this->Points).normalized();
  }
}

Status GuideField::Make(const GuideSettings& settings, std::shared_ptr<const ForceField>& made)
{
  const std::vector<Vector3>& points = settings.PointsWorld;
  if (points.size() < LeastPoints(settings.Shape) || points.size() > MostPoints)
  {
    return Status::Failure("A guide needs 1 point, a path 2 to " + std::to_string(MostPoints) +
                           ", a plane 3.");
  }
  constexpr double Farthest = 1e6; // mm
  const bool areNear =
      std::all_of(points.begin(), points.end(),
                  [](const Vector3& point)
                  { return point.allFinite() && point.cwiseAbs().maxCoeff() <= Farthest; });
  if (!areNear)
  {
    return Status::Failure("A guide's points must be finite and within a kilometre.");
  }
  if (!IsPositive(settings.Stiffness) || !IsPositive(settings.Range) ||
      !IsPositive(settings.LargestForce))
  {
    return Status::Failure("Stiffness, range and largest force of a guide must be finite and "
                           "positive.");
  }
  constexpr double LeastArea = 1e-6; // mm^2
  if (settings.Shape == GuideShape::Plane && !(AcrossThree(points).norm() > LeastArea))
  {
    return Status::Failure(
        "The three points of a guide's plane lie on one line: move one of them.");
  }
  // std::make_shared cannot call the private constructor.
  made.reset(new GuideField(settings));
  return Status::Success();
}

Vector3 GuideField::NearestTo(const Vector3& originWorld) const noexcept
{
  if (this->Shape == GuideShape::Point)
  {
    return this->Points.front();
  }
  if (this->Shape == GuideShape::Plane)
  {
    return originWorld - this->Normal.dot(originWorld - this->Points.front()) * this->Normal;
  }
  Vector3 nearest = this->Points.front();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t n = 1; n < this->Points.size(); ++n)
  {
    const Vector3 one = NearestOnLine(this->Points[n - 1], this->Points[n], originWorld);
    const double square = (one - originWorld).squaredNorm();
    nearest = square < least ? one : nearest;
    least = std::min(least, square);
  }
  return nearest;
}

Vector3 GuideField::ForceWorld(const Vector3& originWorld) const noexcept
{
  const Vector3 offset = this->NearestTo(originWorld) - originWorld;
  const double left = 1.0 - offset.squaredNorm() / (this->Range * this->Range);
  // False for a place that is not finite.
  return left > 0.0 ? Vector3(this->Spring * left * left * offset) : Vector3::Zero();
}

Eigen::AlignedBox3d GuideField::BoundsWorld() const noexcept
{
  Eigen::AlignedBox3d bounds;
  if (this->Shape == GuideShape::Plane)
  {
    constexpr double Everywhere = std::numeric_limits<double>::max();
    return {Vector3::Constant(-Everywhere), Vector3::Constant(Everywhere)};
  }
  for (const Vector3& point : this->Points)
  {
    bounds.extend(Vector3(point.array() - this->Range));
    bounds.extend(Vector3(point.array() + this->Range));
  }
  return bounds;
}
} // namespace palpate
