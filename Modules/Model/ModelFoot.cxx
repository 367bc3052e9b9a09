#include "ModelFoot.h"

#include "IcosahedronDirections.h"
#include "ModelMeasures.h"
#include "SampleGeometry.h"
#include "SquaredDistance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace palpate
{
namespace
{
// Up to degree 40, triangles' sides are some 2.5 times as short as the shortest half-wave, so that
// the nearest triangle leads Newton's method to the right place. Beyond, time counts. Even.
int FrequencyOf(const OrganModel& model)
{
  return 2 * std::clamp(static_cast<int>(std::ceil(1.25 * DegreeOf(model))), 20, 50);
}

// Those of half the frequency, whose directions are among the given ones.
std::vector<std::array<int, 3>> CoarseTriangles(const std::vector<Vector3>& directions,
                                                int frequency)
{
  const auto key = [](const Vector3& direction)
  {
    constexpr double Steps = 1e7; // far below the directions' distances, far above rounding
    return std::array<long, 3>{std::lround(Steps * direction[0]), std::lround(Steps * direction[1]),
                               std::lround(Steps * direction[2])};
  };
  std::map<std::array<long, 3>, int> numbers;
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    numbers[key(directions[i])] = static_cast<int>(i);
  }
  const IcosahedronDirections coarse(frequency / 2);
  std::vector<std::array<int, 3>> triangles = coarse.Triangles();
  for (std::array<int, 3>& triangle : triangles)
  {
    for (int& corner : triangle)
    {
      corner = numbers.at(key(coarse.Directions()[corner]));
    }
  }
  return triangles;
}

void TurnInsideOut(std::vector<std::array<int, 3>>& triangles)
{
  for (std::array<int, 3>& triangle : triangles)
  {
    std::swap(triangle[1], triangle[2]);
  }
}

SurfaceModel AsSurfaceModel(const OrganModel& model)
{
  const auto* star = std::get_if<RadialModel>(&model);
  return star != nullptr ? SurfaceModel::FromModel(*star) : std::get<SurfaceModel>(model);
}

double SignedVolumeOf(const OrganModel& model)
{
  const auto* star = std::get_if<RadialModel>(&model);
  return star != nullptr ? VolumeOf(*star) : std::get<SurfaceModel>(model).Volume();
}
} // namespace

ModelFoot::ModelFoot(const OrganModel& model)
    : Frequency(FrequencyOf(model)), Shape(AsSurfaceModel(model)),
      Outward(SignedVolumeOf(model) < 0.0 ? -1.0 : 1.0),
      EnclosedVolume(std::abs(SignedVolumeOf(model))),
      SurfaceArea(std::visit([](const auto& surface) { return AreaOf(surface); }, model))
{
  const IcosahedronDirections sphere(this->Frequency);
  this->Parameters = sphere.Directions();
  for (const Vector3& parameter : this->Parameters)
  {
    this->Drawing.Points.push_back(this->Shape.PointWorld(parameter));
  }
  this->Drawing.Triangles = sphere.Triangles();
  if (this->Outward < 0.0)
  {
    TurnInsideOut(this->Drawing.Triangles);
  }
}

Vector3 ModelFoot::PointAt(const Vector3& direction) const noexcept
{
  return this->Shape.PointWorld(direction.normalized());
}

IndexedMesh ModelFoot::CoarseMesh() const
{
  IndexedMesh coarse{this->Drawing.Points, CoarseTriangles(this->Parameters, this->Frequency)};
  if (this->Outward < 0.0)
  {
    TurnInsideOut(coarse.Triangles);
  }
  return coarse;
}

// By the areas of the parts into which the point divides its triangle.
Vector3 ModelFoot::ParameterAt(const NearestOnMesh::Result& near) const noexcept
{
  const std::array<int, 3>& corners = this->Drawing.Triangles[near.Triangle];
  Vector3 parameter = Vector3::Zero();
  for (int i = 0; i < 3; ++i)
  {
    const Vector3 next = this->Drawing.Points[corners[(i + 1) % 3]] - near.Point;
    const Vector3 last = this->Drawing.Points[corners[(i + 2) % 3]] - near.Point;
    parameter += next.cross(last).norm() * this->Parameters[corners[i]];
  }
  return parameter.squaredNorm() > 0.0 ? Vector3(parameter.normalized())
                                       : this->Parameters[corners[0]];
}

ModelFoot::Foot ModelFoot::FindFoot(const Vector3& from,
                                    const NearestOnMesh::Result& near) const noexcept
{
  constexpr int MostSteps = 12;
  constexpr double ShortStep = 1e-7; // rad; the rest of the way is straight
  Vector3 parameter = this->ParameterAt(near);
  CenteredSurface::SecondOrderSample sample = this->Shape.EvaluateSecondOrder(parameter);
  for (int i = 0; i < MostSteps; ++i)
  {
    const SquaredDistance distance(parameter, sample, from);
    if (!distance.IsConvex())
    {
      break;
    }
    const Vector3 step = distance.NewtonStep();
    if (!(step.squaredNorm() > ShortStep * ShortStep))
    {
      sample.Point += sample.Tangents[0].dot(step) * sample.First[0] +
                      sample.Tangents[1].dot(step) * sample.First[1];
      parameter = Moved(parameter, step);
      break;
    }
    const Vector3 next = Moved(parameter, step);
    const CenteredSurface::SecondOrderSample there = this->Shape.EvaluateSecondOrder(next);
    if (!((from - there.Point).squaredNorm() < (from - sample.Point).squaredNorm()))
    {
      break;
    }
    parameter = next;
    sample = there;
  }
  return {parameter, sample};
}

double ModelFoot::SignedDistance(const Vector3& query,
                                 const NearestOnMesh::Result& near) const noexcept
{
  const Vector3 from = query - this->Shape.CenterWorld();
  const CenteredSurface::SecondOrderSample sample = this->FindFoot(from, near).Sample;
  const Vector3 offset = from - sample.Point;
  const double side = this->Outward * offset.dot(sample.First[0].cross(sample.First[1]));
  return side < 0.0 ? -offset.norm() : offset.norm();
}

Vector3 ModelFoot::FootOf(const Vector3& query, const NearestOnMesh::Result& near) const noexcept
{
  return this->FindFoot(query - this->Shape.CenterWorld(), near).Parameter;
}
} // namespace palpate
