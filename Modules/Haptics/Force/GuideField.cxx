#include "GuideField.h"

#include <algorithm>
#include <limits>

namespace palpate
{
namespace
{
Vector3 NearestOnLine(const Vector3& from, const Vector3& to, const Vector3& place) noexcept
{
  const Vector3 line = to - from;
  const double square = line.squaredNorm();
  const double part = square > 0.0 ? (place - from).dot(line) / square : 0.0;
  return from + std::clamp(part, 0.0, 1.0) * line;
}
} // namespace

GuideField::GuideField(const GuideSettings& settings)
    : Shape(settings.Shape), Points(settings.PointsWorld), Law(settings)
{
  if (this->Shape == GuideShape::Plane)
  {
    const Vector3 along = this->Points[1] - this->Points[0];
    this->Normal = along.cross(this->Points[2] - this->Points[0]).normalized();
  }
}

Status GuideField::Make(const GuideSettings& settings, std::shared_ptr<const ForceField>& made)
{
  const Status status = CheckGuide(settings);
  if (!status.IsOk())
  {
    return status;
  }
  if (settings.HasStructure())
  {
    return Status::Failure("A guide by a structure has no points.");
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
  const double pull = this->Law.PullAt(offset.squaredNorm());
  // 0 for a place that is not finite.
  return pull > 0.0 ? Vector3(pull * offset) : Vector3::Zero();
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
    bounds.extend(Vector3(point.array() - this->Law.Range()));
    bounds.extend(Vector3(point.array() + this->Law.Range()));
  }
  return bounds;
}
} // namespace palpate
