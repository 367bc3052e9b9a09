#include "TouchableSurfaceModel.h"

#include "CenteredSurfaceSample.h"
#include "IcosahedronDirections.h"
#include "MeshCrossings.h"
#include "UnprovenPoint.h"
#include "WedgePlaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
using SurfacePoint = TouchableSurfaceModel::ClosestPoint;

bool IsUsable(const SurfaceModel& surface)
{
  constexpr double Largest = 1e90; // mm: its cube is a volume
  for (int coordinate = 0; coordinate < 3; ++coordinate)
  {
    const std::vector<double>& coefficients = surface.Coefficients(coordinate);
    if (!std::all_of(coefficients.begin(), coefficients.end(),
                     [](double c) { return std::abs(c) <= Largest; }))
    {
      return false;
    }
  }
  return true;
}

// The largest size that the coefficients allow without their means, mm.
double SizeOf(const SurfaceModel& surface)
{
  double sum = 0.0;
  for (int coordinate = 0; coordinate < 3; ++coordinate)
  {
    const std::vector<double>& coefficients = surface.Coefficients(coordinate);
    for (std::size_t i = 1; i < coefficients.size(); ++i)
    {
      sum += coefficients[i] * coefficients[i];
    }
  }
  return std::sqrt(sum);
}

// Opposite parameters have harmonics of odd degree with the other sign: the same surface, oriented
// the other way round.
SurfaceModel Turned(const SurfaceModel& surface)
{
  std::array<std::vector<double>, 3> coefficients;
  for (int coordinate = 0; coordinate < 3; ++coordinate)
  {
    std::vector<double>& values = coefficients[static_cast<std::size_t>(coordinate)];
    values = surface.Coefficients(coordinate);
    for (int l = 1; l <= surface.Degree(); l += 2)
    {
      std::for_each(values.begin() + l * l, values.begin() + (l + 1) * (l + 1),
                    [](double& c) { c = -c; });
    }
  }
  return {surface.Degree(), coefficients};
}

IcosahedronDirections MeshDirections(const CenteredSurface& shape)
{
  return IcosahedronDirections(std::max(8, 2 * shape.Degree()));
}

WindingMesh MeshOf(const CenteredSurface& shape)
{
  const IcosahedronDirections sphere = MeshDirections(shape);
  std::vector<Vector3> points;
  points.reserve(sphere.Directions().size());
  for (const Vector3& parameter : sphere.Directions())
  {
    points.push_back(shape.PointWorld(parameter));
  }
  return {std::move(points), sphere.Triangles()};
}

std::vector<Vector3> CrossingsOf(const CenteredSurface& shape, const WindingMesh& mesh)
{
  constexpr std::size_t Most = TouchableSurfaceModel::MostCrossings;
  MeshCrossings found;
  const Status status = FindMeshCrossings({mesh.PointsWorld(), MeshDirections(shape).Triangles()},
                                          {Most, Most}, found);
  std::vector<Vector3> places;
  for (const MeshCrossing& pair : found.Pairs)
  {
    places.push_back(pair.Place);
  }
  return status.IsOk() ? places : std::vector<Vector3>{};
}

// Whether a point is seen from the side that the parameters' orientation calls inside.
bool IsTurned(const SurfacePoint& point) noexcept
{
  return point.Normal.dot(AreaVector(point.Sample)) < 0.0;
}

// From the triangles' centres to the points of the surface there.
double DeviationOf(const CenteredSurface& shape)
{
  const IcosahedronDirections sphere = MeshDirections(shape);
  double largest = 0.0;
  for (const auto& triangle : sphere.Triangles())
  {
    Vector3 parameter = Vector3::Zero();
    Vector3 center = Vector3::Zero();
    for (const int corner : triangle)
    {
      const Vector3& each = sphere.Directions()[static_cast<std::size_t>(corner)];
      parameter += each;
      center += shape.PointWorld(each) / 3.0;
    }
    largest = std::max(largest, (shape.PointWorld(parameter.normalized()) - center).norm());
  }
  return largest;
}
} // namespace

SurfacePoint OtherSide(SurfacePoint point) noexcept
{
  point.Normal = -point.Normal;
  point.SignedDistance = -point.SignedDistance;
  return point;
}

// Above degree 16 evaluations take longer, in proportion to the number of coefficients.
int TouchableSurfaceModel::EvaluationsOfTick() const noexcept
{
  constexpr int Most = 700;
  constexpr int Least = 100;
  constexpr int Coefficients = 17 * 17;
  const int side = this->Model().Degree() + 1;
  return std::clamp(Most * Coefficients / (side * side), Least, Most);
}

Status TouchableSurfaceModel::Make(const SurfaceModel& surface,
                                   std::shared_ptr<const TouchableSurfaceModel>& touch)
{
  if (!IsUsable(surface))
  {
    return Status::Failure(
        "The surface to be touched has numbers that are not finite or far too large.");
  }
  constexpr double LeastVolume = 1e-9; // relative, below any that can be felt
  const double size = SizeOf(surface);
  const double volume = surface.Volume();
  if (!(std::abs(volume) > LeastVolume * size * size * size))
  {
    return Status::Failure("The surface to be touched encloses no volume.");
  }
  const double smallest = 3.0 * std::abs(volume) / surface.Area();
  touch.reset(new TouchableSurfaceModel(volume < 0.0 ? Turned(surface) : surface, smallest));
  return Status::Success();
}

TouchableSurfaceModel::TouchableSurfaceModel(const SurfaceModel& surface, double smallest)
    : Closest(std::make_shared<const CenteredSurface>(surface)), Smallest(smallest),
      Mesh(MeshOf(Closest.Model())), MeshDeviation(DeviationOf(Closest.Model())),
      Crossings(CrossingsOf(Closest.Model(), Mesh)), Exits(FindExits())
{
}

std::size_t TouchableSurfaceModel::Bytes() const noexcept
{
  return sizeof(*this) + this->Closest.Bytes() + this->Mesh.Bytes() +
         this->Crossings.size() * sizeof(Vector3) + this->Exits.size() * sizeof(Exit);
}

std::shared_ptr<const WedgePlaces> TouchableSurfaceModel::PlacesFor(double radius,
                                                                    double reach) const
{
  const std::lock_guard<std::mutex> hold(this->PlacesLock); // whoever waits needs them too
  if (!this->LastPlaces || !this->LastPlaces->AreFor(radius, reach))
  {
    this->LastPlaces = std::make_shared<const WedgePlaces>(*this, radius, reach);
  }
  return this->LastPlaces;
}

SurfacePoint TouchableSurfaceModel::SeenFromOutside(const ClosestPoint& nearest) const noexcept
{
  return nearest.SignedDistance < 0.0 ? OtherSide(nearest) : nearest;
}

SurfacePoint TouchableSurfaceModel::SeenFrom(const Vector3& queryWorld,
                                             const ClosestPoint& nearest) const noexcept
{
  if (nearest.State == ClosestPoint::Outcome::BadInput)
  {
    return nearest;
  }
  return this->IsOutside(queryWorld, nearest) ? this->SeenFromOutside(nearest)
                                              : this->WayOut(queryWorld, nearest);
}

SurfacePoint TouchableSurfaceModel::SeenLike(const ClosestPoint& other,
                                             const ClosestPoint& nearest) const noexcept
{
  return IsTurned(other) != IsTurned(nearest) ? OtherSide(nearest) : nearest;
}

// The mesh is not exactly the surface: near it the place is moved away from the surface first.
int TouchableSurfaceModel::WindingNumberNear(const Vector3& queryWorld,
                                             const ClosestPoint& nearest) const noexcept
{
  const double least = 2.0 * this->MeshDeviation;
  if (std::abs(nearest.SignedDistance) >= least)
  {
    return this->Mesh.WindingNumber(queryWorld);
  }
  const double side = std::copysign(least, nearest.SignedDistance);
  return this->Mesh.WindingNumber(nearest.PointWorld + side * nearest.Normal);
}

// Whether it is outside there, with room for a point with its margin: next to a crossing it would
// be pushed out of the other sheet, and into the body.
bool TouchableSurfaceModel::IsExit(const Vector3& pointWorld, const Vector3& normal) const noexcept
{
  constexpr double Almost = 0.99;
  constexpr int Evaluations = 256;
  const double margin = this->Margin();
  const Vector3 place = pointWorld + margin * normal;
  return this->Mesh.WindingNumber(pointWorld + 2.0 * this->MeshDeviation * normal) == 0 &&
         this->Mesh.WindingNumber(place) == 0 &&
         std::abs(this->Closest.Nearest(place, Evaluations).SignedDistance) >= Almost * margin;
}

// The nearest point; where a sheet inside is nearer, the nearest of the mesh's points that border
// the outside.
SurfacePoint TouchableSurfaceModel::WayOut(const Vector3& queryWorld,
                                           const ClosestPoint& nearest) const noexcept
{
  const ClosestPoint inside = nearest.SignedDistance > 0.0 ? OtherSide(nearest) : nearest;
  if (this->Exits.empty() || this->IsExit(inside.PointWorld, inside.Normal))
  {
    return inside;
  }
  const Exit& exit = *std::min_element(this->Exits.begin(), this->Exits.end(),
                                       [&](const Exit& a, const Exit& b) {
                                         return (a.PointWorld - queryWorld).squaredNorm() <
                                                (b.PointWorld - queryWorld).squaredNorm();
                                       });
  const ClosestPoint point = UnprovenPoint(this->Model(), exit.Parameter, queryWorld);
  return point.Normal.dot(exit.Normal) > 0.0 ? point : OtherSide(point);
}

std::vector<TouchableSurfaceModel::Exit> TouchableSurfaceModel::FindExits() const
{
  std::vector<Exit> exits;
  if (!this->CrossesItself())
  {
    return exits;
  }
  const IcosahedronDirections sphere = MeshDirections(this->Model());
  for (const Vector3& parameter : sphere.Directions())
  {
    const Place place = this->PlaceAt(parameter);
    for (const double side : {1.0, -1.0})
    {
      const Vector3 normal = side * place.Normal;
      if (this->IsExit(place.PointWorld, normal))
      {
        exits.push_back({parameter, place.PointWorld, normal});
      }
    }
  }
  return exits;
}

TouchableSurfaceModel::Place TouchableSurfaceModel::PlaceAt(const Vector3& parameter) const noexcept
{
  const auto sample = this->Model().EvaluateSecondOrder(parameter);
  return {parameter, this->Model().CenterWorld() + sample.Point, NormalOf(sample)};
}

TouchableSurfaceModel::Place TouchableSurfaceModel::PlaceAt(const Vector3& parameter,
                                                            const ClosestPoint& like) const noexcept
{
  Place place = this->PlaceAt(parameter);
  place.Normal = IsTurned(like) ? Vector3(-place.Normal) : place.Normal;
  return place;
}

SurfacePoint TouchableSurfaceModel::PointAt(const Vector3& parameter, const Vector3& queryWorld,
                                            const ClosestPoint& like) const noexcept
{
  const ClosestPoint point = UnprovenPoint(this->Model(), parameter, queryWorld);
  return IsTurned(like) ? OtherSide(point) : point;
}
} // namespace palpate
