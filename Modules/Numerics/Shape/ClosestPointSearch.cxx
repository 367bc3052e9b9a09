#include "ClosestPointSearch.h"

#include "BranchAndBoundSearch.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
// Parts about as wide as the finest detail that the degree can represent.
int LevelsFor(int degree)
{
  constexpr int Most = 5;
  int levels = 2;
  while (levels < Most && (1 << levels) < degree)
  {
    ++levels;
  }
  return levels;
}

// Squares of larger values would overflow.
bool IsUsable(const Vector3& query)
{
  return query.lpNorm<Eigen::Infinity>() <= 1e100;
}

ClosestPoint Unusable(const SphericalHarmonicModel& model)
{
  ClosestPoint point;
  const Vector3 up = Vector3::UnitZ();
  point.Direction = up;
  point.PointWorld = model.PointWorld(up);
  point.Normal = up;
  point.SignedDistance = 0.0;
  point.DistanceError = std::numeric_limits<double>::infinity();
  point.PositionError = point.DistanceError;
  point.SampleDirection = up;
  point.Sample = model.EvaluateSecondOrder(up);
  return point;
}
} // namespace

ClosestPointSearch::ClosestPointSearch(std::shared_ptr<const SphericalHarmonicModel> model)
    : Surface(std::move(model)), LocalSearch(*Surface),
      Parts(*Surface, LocalSearch.Bounds(), LevelsFor(Surface->Degree()))
{
}

ClosestPoint ClosestPointSearch::Nearest(const Vector3& queryWorld,
                                         int evaluationLimit) const noexcept
{
  return this->Search(queryWorld, evaluationLimit, 0.0, 0.0);
}

ClosestPoint ClosestPointSearch::Clearance(const Vector3& queryWorld, double toolRadius,
                                           int evaluationLimit) const noexcept
{
  return this->Search(queryWorld, evaluationLimit, toolRadius, ClearanceLeftOpen);
}

ClosestPoint ClosestPointSearch::Search(const Vector3& queryWorld, int evaluationLimit,
                                        double toolRadius, double part) const noexcept
{
  const Vector3 query = queryWorld - this->Surface->CenterWorld();
  if (!IsUsable(query))
  {
    return Unusable(*this->Surface);
  }
  BranchAndBoundSearch search(*this->Surface, this->LocalSearch, this->Parts, query,
                              evaluationLimit, toolRadius, part);
  const ClosestPoint closest = search.Run();
  return closest.State == ClosestPoint::Outcome::BadInput ? Unusable(*this->Surface) : closest;
}

ClosestPoint ClosestPointSearch::Track(const Vector3& queryWorld,
                                       const ClosestPoint& previous) const noexcept
{
  const Vector3 query = queryWorld - this->Surface->CenterWorld();
  if (!IsUsable(query))
  {
    return Unusable(*this->Surface);
  }
  return this->LocalSearch.Continue(query, previous, TrackingTolerance, TrackingEvaluationLimit);
}

ToolContact ClosestPointSearch::TouchAnywhere(const Vector3& toolCenterWorld,
                                              double toolRadius) const noexcept
{
  // In a hollow narrower than the tool the opposite walls push it out alternately.
  constexpr int MostPushes = 64;
  const ClosestPoint nearest = this->Nearest(toolCenterWorld);
  ToolContact contact{nearest.SignedDistance - toolRadius, nearest.Normal,
                      nearest.PointWorld + toolRadius * nearest.Normal, 0.0};
  for (int push = 0; push < MostPushes; ++push)
  {
    const ClosestPoint closest = this->Nearest(contact.ToolCenterWorld);
    contact.Overlap = std::max(0.0, toolRadius - closest.SignedDistance);
    if (contact.Overlap <= 1e-9 * toolRadius)
    {
      break;
    }
    contact.ToolCenterWorld += contact.Overlap * closest.Normal;
  }
  return contact;
}
} // namespace palpate
