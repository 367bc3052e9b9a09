#include "FieldSolid.h"

#include "NodeBox.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
constexpr double FarFromField = std::numeric_limits<double>::infinity();
// Deeper inside, no wall is reliable as the nearest exit.
constexpr double MostVoxelsDeep = 2.0;

// Bounds of the bricks that contain a material, by index.
Eigen::AlignedBox3d OccupiedIndex(const ScalarField& field, int material)
{
  const BrickLayout& layout = field.Layout();
  Eigen::AlignedBox3d box;
  for (int k = 0; k < layout.Bricks[2]; ++k)
  {
    for (int j = 0; j < layout.Bricks[1]; ++j)
    {
      for (int i = 0; i < layout.Bricks[0]; ++i)
      {
        if (field.Map(material)[layout.Number(i, j, k)] != MaterialMap::Absent)
        {
          const Vector3 first = layout.Cells * Vector3(i, j, k);
          box.extend(first);
          box.extend(Vector3(first + Vector3::Constant(layout.Cells)));
        }
      }
    }
  }
  const auto& size = layout.Nodes;
  const Vector3 last(size[0] - 1, size[1] - 1, size[2] - 1);
  return box.intersection(Eigen::AlignedBox3d(Vector3::Zero(), last));
}

} // namespace

Eigen::AlignedBox3d FieldSolid::BoundsOf(const ScalarField& field, int material)
{
  return WorldBounds(field.Grid(), OccupiedIndex(field, material));
}

Status FieldSolid::Make(const std::shared_ptr<const ScalarField>& field, int material,
                        std::shared_ptr<const FieldSolid>& solid)
{
  const bool isThere = material >= 0 && material < field->MaterialCount();
  return Make(field, material, isThere ? BoundsOf(*field, material) : Eigen::AlignedBox3d(), solid);
}

Status FieldSolid::Make(const std::shared_ptr<const ScalarField>& field, int material,
                        const Eigen::AlignedBox3d& boundsWorld,
                        std::shared_ptr<const FieldSolid>& solid)
{
  if (material < 0 || material >= field->MaterialCount())
  {
    return Status::Failure("The field has no material " + std::to_string(material) + ".");
  }
  solid.reset(new FieldSolid(field, material, boundsWorld));
  return Status::Success();
}

FieldSolid::FieldSolid(const std::shared_ptr<const ScalarField>& field, int material,
                       const Eigen::AlignedBox3d& boundsWorld)
    : Sampler(field), Caster(field), Number(material), FieldBytes(field->Bytes()),
      Bounds(boundsWorld), Voxel(field->Grid().Spacing().minCoeff())
{
}

FieldSolid::Wall FieldSolid::WallNear(const Vector3& pointWorld,
                                      const Vector3& outward) const noexcept
{
  const Vector3 pointIndex = this->Sampler.Field().Grid().PointIndex(pointWorld);
  Wall wall = this->WallBySamples(pointIndex);
  this->JoinBorder(pointIndex, wall);
  // If the gradient is close to zero, value over gradient is meaningless.
  const bool isTrusted = wall.IsKnown && wall.Distance > -MostVoxelsDeep * this->Voxel;
  return isTrusted ? wall : this->WallByRay(pointWorld, outward);
}

// A material is the intersection of its conditions, so the plane with the smallest depth is used.
FieldSolid::Wall FieldSolid::WallBySamples(const Vector3& pointIndex) const noexcept
{
  const ScalarField& field = this->Sampler.Field();
  const FieldMaterial& material = field.Material(this->Number);
  Wall wall;
  wall.Distance = -FarFromField;
  for (int c = 0; c < material.ConditionCount; ++c)
  {
    const FieldCondition& condition = material.Conditions[c];
    const FieldGradientSample sample =
        this->Sampler.ValueAndGradientIndex(condition.Channel, pointIndex);
    const Vector3 gradient = field.Grid().GradientWorld(sample.Gradient);
    const double slope = gradient.norm();
    if (!(slope > 0.0))
    {
      continue;
    }
    double value = sample.Value;
    condition.Relate(&value, 1);
    const double sign = condition.Sense == FieldSense::AtLeast ? -1.0 : 1.0;
    if (-value / slope > wall.Distance)
    {
      wall = {true, -value / slope, (sign / slope) * gradient};
    }
  }
  return wall;
}

FieldSolid::Wall FieldSolid::WallByRay(const Vector3& pointWorld,
                                       const Vector3& outward) const noexcept
{
  const FieldHit hit = this->Caster.CastWorld(
      {pointWorld, outward}, 0.0, MostVoxelsDeep * this->Voxel, OnlyMaterial(this->Number));
  const bool isExit =
      (hit.Kind == HitKind::Surface || hit.Kind == HitKind::Border) && !hit.IsEntering;
  const double slope = hit.Gradient.norm();
  if (!isExit || !(slope > 0.0))
  {
    return {};
  }
  const Vector3 normal = (-1.0 / slope) * hit.Gradient;
  return {true, (pointWorld - hit.Position).dot(normal), normal};
}

// Where the material reaches the grid's border, the border is a wall too.
void FieldSolid::JoinBorder(const Vector3& pointIndex, Wall& wall) const noexcept
{
  const FieldGrid& grid = this->Sampler.Field().Grid();
  const auto& size = grid.Size();
  const Vector3 last(size[0] - 1, size[1] - 1, size[2] - 1);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double spacing = grid.Spacing()[axis];
    const double below = -pointIndex[axis] * spacing;
    const double above = (pointIndex[axis] - last[axis]) * spacing;
    const double distance = std::max(below, above);
    const Vector3 inGrid = pointIndex.cwiseMax(0.0).cwiseMin(last);
    if (distance > wall.Distance && distance > -MostVoxelsDeep * spacing &&
        this->Sampler.IsInsideIndex(this->Number, inGrid))
    {
      wall = {true, distance, (above > below ? 1.0 : -1.0) * grid.Direction().col(axis)};
    }
  }
}

double FieldSolid::PartToEntry(const Vector3& fromWorld, const Vector3& path) const noexcept
{
  if (path.isZero(0.0))
  {
    return 1.0;
  }
  const FieldRay ray{fromWorld, path};
  const MaterialSet material = OnlyMaterial(this->Number);
  FieldHit hit = this->Caster.CastWorld(ray, 0.0, 1.0, material);
  if (hit.Kind != HitKind::Missed && !hit.IsEntering)
  {
    hit = this->Caster.CastWorld(ray, std::nextafter(hit.T, FarFromField), 1.0, material);
  }
  const bool isHit = hit.Kind == HitKind::Surface || hit.Kind == HitKind::Border;
  return isHit && hit.IsEntering ? hit.T : 1.0;
}

double FieldSolid::DistanceToExit(const Vector3& fromWorld, const Vector3& direction,
                                  double reach) const noexcept
{
  const FieldRay ray{fromWorld, direction};
  const FieldHit hit = this->Caster.CastWorld(ray, 0.0, reach, OnlyMaterial(this->Number));
  const bool isHit = hit.Kind == HitKind::Surface || hit.Kind == HitKind::Border;
  return isHit && !hit.IsEntering ? hit.T : reach;
}
} // namespace palpate
