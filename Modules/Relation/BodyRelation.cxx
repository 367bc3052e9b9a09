#include "BodyRelation.h"

#include "BodyOverlap.h"
#include "MeshDistances.h"
#include "SurfaceTopology.h"
#include "Units.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace palpate
{
namespace
{
constexpr double Beyond = 1e30; // mm

// Distances from a body of points near its box, Beyond of the others; signed if points may lie
// inside.
Status DistancesNear(const std::vector<Vector3>& points, const RelatedBody& body, double reach,
                     bool isSigned, const KernelProgress& progress, std::vector<double>& distances)
{
  const double far = 1.2 * reach + 2.0; // so that triangles across the reach have all corners
  distances.assign(points.size(), Beyond);
  std::vector<Vector3> near;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (body.Box().squaredExteriorDistance(points[i]) <= far * far)
    {
      near.push_back(points[i]);
      places.push_back(i);
    }
  }
  std::vector<double> found;
  Status status = Status::Success();
  if (isSigned || body.Body().IsModel())
  {
    status = body.Body().DistancesOf(near, progress, found);
  }
  else
  {
    found = body.Body().DistancesOfTriangles(near);
  }
  for (std::size_t i = 0; status.IsOk() && i < places.size(); ++i)
  {
    distances[places[i]] = found[i];
  }
  return status;
}

double AreaBetween(const IndexedMesh& mesh, const std::vector<double>& distances, double limit)
{
  return AreaWithin(mesh, distances, limit) -
         AreaWithin(mesh, distances, std::nextafter(-limit, -Beyond));
}

// What of `body` is near `from`.
Status MeasureSide(const RelatedBody& body, const RelatedBody& from,
                   const RelationSettings& settings, bool isSigned, const KernelProgress& progress,
                   RelatedSide& side)
{
  const double reach = settings.Reach();
  std::vector<double> within;
  Status status = DistancesNear(body.Samples().Points, from, reach, isSigned,
                                PartOf(progress, 0.0, 0.7), side.Distances);
  if (status.IsOk())
  {
    status =
        DistancesNear(body.Inside(), from, reach, isSigned, PartOf(progress, 0.7, 1.0), within);
  }
  if (!status.IsOk())
  {
    return status;
  }
  const IndexedMesh& own = body.Own();
  side.ContactArea = AreaBetween(own, side.Distances, settings.Contact);
  const double area = std::max(std::numeric_limits<double>::min(), MeasureEnclosed(own).Area);
  for (NearShare& share : side.Near)
  {
    const double limit = share.Millimeters;
    share.Area = AreaWithin(own, side.Distances, limit) / area;
    const auto count = std::count_if(within.begin(), within.end(),
                                     [limit](double distance) { return distance <= limit; });
    share.Volume =
        static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(1, within.size()));
  }
  return status;
}

// Of surfaces that do not cross, every point of the inner one lies inside the other.
bool LiesIn(const RelatedBody& inner, const RelatedBody& outer)
{
  std::vector<double> distance;
  return outer.Box().contains(inner.Box()) &&
         outer.Body().DistancesOf({inner.Body().Surface().Points.front()}, {}, distance).IsOk() &&
         distance.front() < 0.0;
}

// Of masks, their voxels. Else, by the divergence theorem, the volume between a point and the parts
// of each surface that lie in the other body; near the point where they cross errors are least.
double SharedVolumeOf(const RelatedBody& one, const RelatedBody& other,
                      const BodyRelation& relation)
{
  if (one.Body().Mask() == nullptr || other.Body().Mask() == nullptr)
  {
    const Vector3& from = relation.Wall.PointOfOne;
    return VolumeWithin(one.Samples(), from, relation.One.Distances, 0.0) +
           VolumeWithin(other.Samples(), from, relation.Other.Distances, 0.0);
  }
  BodyOverlap overlap;
  return FindBodyOverlap(one.Body(), other.Body(), overlap).IsOk()
             ? overlap.Both * overlap.Spacing.prod()
             : std::numeric_limits<double>::quiet_NaN();
}

// By the surfaces alone.
BodyRelation::Kind KindOf(const RelatedBody& one, const RelatedBody& other, const MeshGap& wall)
{
  using Kind = BodyRelation::Kind;
  return wall.Distance == 0.0 ? Kind::Overlapping
         : LiesIn(one, other) ? Kind::Inside
         : LiesIn(other, one) ? Kind::Around
                              : Kind::Apart;
}

void FindSharedVolume(const RelatedBody& one, const RelatedBody& other, BodyRelation& relation)
{
  using Kind = BodyRelation::Kind;
  const bool hasMasks = one.Body().Mask() != nullptr && other.Body().Mask() != nullptr;
  const bool isNested = relation.Is == Kind::Inside || relation.Is == Kind::Around;
  if (hasMasks ? one.Box().intersects(other.Box()) : relation.Is == Kind::Overlapping)
  {
    relation.SharedVolume = SharedVolumeOf(one, other, relation);
  }
  else if (isNested)
  {
    relation.SharedVolume = std::min(one.Body().Volume(), other.Body().Volume());
  }
  if (relation.Is == Kind::Apart && relation.SharedVolume > 0.0) // voxels at the very border
  {
    relation.Is = Kind::Overlapping;
  }
}
} // namespace

double RelationSettings::Reach() const noexcept
{
  return this->Margins.empty() ? this->Contact : std::max(this->Contact, this->Margins.back());
}

Status RelateBodies(const RelatedBody& one, const RelatedBody& other,
                    const RelationSettings& settings, const KernelProgress& progress,
                    BodyRelation& relation)
{
  BodyRelation made;
  made.Wall = one.Gap().To(other.Gap());
  made.Offset = other.Spread().Mean - one.Spread().Mean;
  const double cosine = one.Spread().Axes().col(0).dot(other.Spread().Axes().col(0));
  made.AxesAngle = DegreesPerRadian * std::acos(std::min(1.0, std::abs(cosine)));
  for (const double margin : settings.Margins)
  {
    made.One.Near.push_back({margin, 0.0, 0.0});
    made.Other.Near.push_back({margin, 0.0, 0.0});
  }
  made.Is = KindOf(one, other, made.Wall);
  const bool mayHold = made.Is != BodyRelation::Kind::Apart;
  if (made.Wall.Distance <= settings.Reach() || mayHold)
  {
    Status status =
        MeasureSide(one, other, settings, mayHold, PartOf(progress, 0.0, 0.5), made.One);
    if (status.IsOk())
    {
      status = MeasureSide(other, one, settings, mayHold, PartOf(progress, 0.5, 1.0), made.Other);
    }
    if (!status.IsOk())
    {
      return status;
    }
  }
  FindSharedVolume(one, other, made);
  relation = std::move(made);
  return Status::Success();
}
} // namespace palpate
