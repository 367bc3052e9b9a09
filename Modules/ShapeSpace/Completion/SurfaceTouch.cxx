#include "SurfaceTouch.h"

#include <Eigen/Geometry>
#include <cmath>
#include <string>

namespace palpate
{
namespace
{
constexpr double LeastDeviation = 0.01;    // mm
constexpr double LargestDeviation = 100.0; // mm
constexpr double FarthestPoint = 1000.0;   // mm, from the centre
} // namespace

Status CheckTouches(const std::vector<SurfaceTouch>& touches, const Vector3& centerWorld)
{
  if (touches.size() > SurfaceTouch::Most)
  {
    return Status::Failure("there are " + std::to_string(touches.size()) +
                           " touched points, more than " + std::to_string(SurfaceTouch::Most) +
                           "; take every tenth");
  }
  for (std::size_t n = 0; n < touches.size(); ++n)
  {
    const SurfaceTouch& touch = touches[n];
    const std::string name = "touch " + std::to_string(n + 1);
    if (!((touch.PointWorld - centerWorld).norm() < FarthestPoint))
    {
      return Status::Failure(name + " is not within 1,000 mm of the organ's centre");
    }
    if (!(touch.Deviation >= LeastDeviation && touch.Deviation <= LargestDeviation))
    {
      return Status::Failure(name + " has a standard deviation outside of 0.01 to 100 mm");
    }
    if (touch.Normal && !(touch.Normal->allFinite() && touch.Normal->norm() > 1e-6))
    {
      return Status::Failure(name + " has a normal without a direction");
    }
  }
  return Status::Success();
}

std::optional<Vector3> MiddleOf(const std::vector<SurfaceTouch>& touches)
{
  Eigen::AlignedBox3d box;
  for (const SurfaceTouch& touch : touches)
  {
    if (!touch.IsOutside)
    {
      box.extend(touch.PointWorld);
    }
  }
  return box.isEmpty() ? std::nullopt : std::optional<Vector3>(box.center());
}

double ExpectedDistance(const std::vector<SurfaceTouch>& touches) noexcept
{
  double sum = 0.0;
  double count = 0.0;
  for (const SurfaceTouch& touch : touches)
  {
    const double offset = touch.Stroke > 0 ? SurfaceTouch::StrokeDeviation : 0.0;
    sum += touch.IsOutside ? 0.0 : touch.Deviation * touch.Deviation + offset * offset;
    count += touch.IsOutside ? 0.0 : 1.0;
  }
  return count > 0.0 ? std::sqrt(sum / count) : 0.0;
}
} // namespace palpate
