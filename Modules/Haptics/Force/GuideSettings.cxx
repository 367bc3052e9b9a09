#include "GuideSettings.h"

#include "PositiveNumber.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

namespace palpate
{
namespace
{
constexpr double Farthest = 1e6; // mm

std::size_t LeastPoints(GuideShape shape)
{
  return shape == GuideShape::Point ? 1 : shape == GuideShape::Path ? 2 : 3;
}

Status CheckPoints(GuideShape shape, const std::vector<Vector3>& points)
{
  if (points.size() < LeastPoints(shape) || points.size() > GuideSettings::MostPoints)
  {
    return Status::Failure("A guide needs 1 point, a path 2 to " +
                           std::to_string(GuideSettings::MostPoints) + ", a plane 3.");
  }
  const bool areNear =
      std::all_of(points.begin(), points.end(),
                  [](const Vector3& point)
                  { return point.allFinite() && point.cwiseAbs().maxCoeff() <= Farthest; });
  if (!areNear)
  {
    return Status::Failure("A guide's points must be finite and within a kilometre.");
  }
  constexpr double LeastArea = 1e-6; // mm^2
  if (shape == GuideShape::Plane &&
      !((points[1] - points[0]).cross(points[2] - points[0]).norm() > LeastArea))
  {
    return Status::Failure(
        "The three points of a guide's plane lie on one line: move one of them.");
  }
  return Status::Success();
}

Status CheckLevel(const GuideSettings& settings)
{
  if (settings.Structure <= 0)
  {
    return Status::Failure("A guide inside, outside or on the surface of a structure needs the "
                           "structure's id, which is the number of a label.");
  }
  if (!(std::abs(settings.Distance) <= Farthest))
  {
    return Status::Failure("A guide's distance must be finite and within a kilometre.");
  }
  return Status::Success();
}
} // namespace

bool operator==(const GuideSettings& a, const GuideSettings& b)
{
  const auto all = [](const GuideSettings& s)
  {
    return std::tie(s.Shape, s.PointsWorld, s.Stiffness, s.Range, s.LargestForce, s.Structure,
                    s.Distance);
  };
  return all(a) == all(b);
}

Status CheckGuide(const GuideSettings& settings)
{
  const Status status = settings.HasStructure() ? CheckLevel(settings)
                                                : CheckPoints(settings.Shape, settings.PointsWorld);
  if (status.IsOk() && (!IsPositive(settings.Stiffness) || !IsPositive(settings.Range) ||
                        !IsPositive(settings.LargestForce)))
  {
    return Status::Failure("Stiffness, range and largest force of a guide must be finite and "
                           "positive.");
  }
  return status;
}
} // namespace palpate
