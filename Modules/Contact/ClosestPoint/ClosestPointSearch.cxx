#include "ClosestPointSearch.h"

#include "BranchAndBoundSearch.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
// Parts as wide as a fraction of the finest detail that the degree can represent.
int LevelsFor(int degree, int fraction)
{
  constexpr int Most = 5;
  int levels = 2;
  while (levels < Most && (1 << levels) < fraction * degree)
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

template <typename Surface>
ClosestPointOf<Surface> Unusable(const Surface& model)
{
  ClosestPointOf<Surface> point;
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

std::size_t BytesOf(const RadialModel& model)
{
  return model.Coefficients().size() * sizeof(double);
}

std::size_t BytesOf(const CenteredSurface& shape)
{
  return shape.Bytes();
}
} // namespace

template <typename Surface>
ClosestPointSearchOf<Surface>::ClosestPointSearchOf(std::shared_ptr<const Surface> model)
    : Shape(std::move(model)), LocalSearch(*Shape),
      Parts(*Shape, LocalSearch.Bounds(),
            LevelsFor(Shape->Degree(), SurfaceKind<Surface>::PartFraction))
{
}

template <typename Surface>
std::size_t ClosestPointSearchOf<Surface>::Bytes() const noexcept
{
  return BytesOf(*this->Shape) + this->Parts.Bytes() + this->LocalSearch.Bounds().Bytes();
}

template <typename Surface>
ClosestPointOf<Surface> ClosestPointSearchOf<Surface>::Nearest(const Vector3& queryWorld,
                                                               int evaluationLimit) const noexcept
{
  return this->Search(queryWorld, evaluationLimit, 0.0, 0.0);
}

template <typename Surface>
ClosestPointOf<Surface>
ClosestPointSearchOf<Surface>::Nearest(const Vector3& queryWorld, int evaluationLimit,
                                       const ClosestPoint& near) const noexcept
{
  return this->Search(queryWorld, evaluationLimit, 0.0, 0.0, &near);
}

template <typename Surface>
ClosestPointOf<Surface> ClosestPointSearchOf<Surface>::Clearance(const Vector3& queryWorld,
                                                                 double toolRadius,
                                                                 int evaluationLimit) const noexcept
{
  return this->Search(queryWorld, evaluationLimit, toolRadius, ClearanceLeftOpen);
}

template <typename Surface>
ClosestPointOf<Surface>
ClosestPointSearchOf<Surface>::Clearance(const Vector3& queryWorld, double toolRadius,
                                         int evaluationLimit,
                                         const ClosestPoint& near) const noexcept
{
  return this->Search(queryWorld, evaluationLimit, toolRadius, ClearanceLeftOpen, &near);
}

template <typename Surface>
ClosestPointOf<Surface>
ClosestPointSearchOf<Surface>::Search(const Vector3& queryWorld, int evaluationLimit,
                                      double toolRadius, double part,
                                      const ClosestPoint* near) const noexcept
{
  const Vector3 query = queryWorld - this->Shape->CenterWorld();
  if (!IsUsable(query))
  {
    return Unusable(*this->Shape);
  }
  BranchAndBoundSearch<Surface> search(*this->Shape, this->LocalSearch, this->Parts, query,
                                       evaluationLimit, toolRadius, part);
  const ClosestPoint closest = search.Run(near);
  return closest.State == ClosestPoint::Outcome::BadInput ? Unusable(*this->Shape) : closest;
}

template <typename Surface>
ClosestPointOf<Surface> ClosestPointSearchOf<Surface>::Track(const Vector3& queryWorld,
                                                             const ClosestPoint& previous,
                                                             double tolerance) const noexcept
{
  const Vector3 query = queryWorld - this->Shape->CenterWorld();
  if (!IsUsable(query))
  {
    return Unusable(*this->Shape);
  }
  return this->LocalSearch.Continue(query, previous, tolerance, TrackingEvaluationLimit);
}

template <typename Surface>
ToolContact ClosestPointSearchOf<Surface>::TouchAnywhere(const Vector3& toolCenterWorld,
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

template class ClosestPointSearchOf<RadialModel>;
template class ClosestPointSearchOf<CenteredSurface>;
} // namespace palpate
