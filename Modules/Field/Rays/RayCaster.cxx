#include "RayCaster.h"

#include "RayKernel.h"
#include "RayTraversal.h"
#include "TricubicCell.h"
#include "TrilinearCell.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
FieldRay IndexRay(const FieldGrid& grid, const FieldRay& world) noexcept
{
  return {grid.PointIndex(world.Origin), grid.VectorIndex(world.Direction)};
}

// Calls run(traversal) for the field's interpolation.
template <typename Function>
FieldHit Traverse(const ScalarField& field, const FieldRay& ray, const RayInterval& interval,
                  MaterialSet materials, const Function& run) noexcept
{
  RayPath path;
  if (!path.Set(ray.Origin, ray.Direction) || std::isnan(interval.From) || std::isnan(interval.To))
  {
    FieldHit none;
    none.Kind = HitKind::BadRay;
    return none;
  }
  if (interval.From > interval.To)
  {
    return {};
  }
  if (field.Interpolation() == FieldInterpolation::Trilinear)
  {
    return run(RayTraversal<TrilinearCell>(field, path, interval.From, interval.To, materials));
  }
  return run(RayTraversal<TricubicCell>(field, path, interval.From, interval.To, materials));
}

FieldHit Cast(const ScalarField& field, const FieldRay& ray, const RayInterval& interval,
              MaterialSet materials) noexcept
{
  return Traverse(field, ray, interval, materials,
                  [](auto&& traversal) { return traversal.Run(); });
}

// Transforms a hit from index coordinates to the world.
void MoveToWorld(const FieldGrid& grid, const FieldRay& rayWorld, FieldHit& hit) noexcept
{
  if (hit.Kind == HitKind::Surface || hit.Kind == HitKind::Border)
  {
    hit.Position = rayWorld.Origin + hit.T * rayWorld.Direction;
    hit.Gradient = grid.GradientWorld(hit.Gradient);
  }
}

rays::Material DescribeMaterial(const ScalarField& field, int number) noexcept
{
  const FieldMaterial& material = field.Material(number);
  const FieldCondition& condition = material.Conditions[0];
  const BrickedChannel& channel = field.Channel(condition.Channel);
  return {material.ConditionCount == 1 && field.Interpolation() == FieldInterpolation::Trilinear,
          StoredNumber(channel.StoredType()),
          field.Map(number).Data(),
          channel.BlockData(),
          channel.BlockStride(),
          condition.Iso,
          condition.Sign()};
}

void DescribeField(const ScalarField& field, MaterialSet materials, rays::Field& described) noexcept
{
  static_assert(rays::MostMaterials == MostMaterials && sizeof(BrickDirectory::Entry) == 8);
  static_assert(rays::BrickShift == BrickLayout::Shift);
  static const std::uint64_t None[CellSet::WordCount + 1] = {};
  const BrickDirectory& directory = field.Directory();
  const std::uint64_t* surfaces =
      directory.SurfaceData() != nullptr ? directory.SurfaceData() : None;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    described.Cells[axis] = field.Layout().Nodes[axis] - 1;
  }
  described.BrickColumns = field.Layout().Bricks[0];
  described.BrickRows = field.Layout().Bricks[1];
  described.Entries = reinterpret_cast<const unsigned char*>(directory.EntryData());
  described.Surfaces = reinterpret_cast<const unsigned char*>(surfaces);
  described.Wanted = materials;
  for (int material = 0; material < field.MaterialCount(); ++material)
  {
    described.Materials[material] = DescribeMaterial(field, material);
  }
}

void Put(const FieldRay& ray, const RayInterval& interval, std::size_t at,
         rays::Batch& batch) noexcept
{
  for (int axis = 0; axis < 3; ++axis)
  {
    batch.Origin[axis][at] = ray.Origin[axis];
    batch.Direction[axis][at] = ray.Direction[axis];
  }
  batch.TMin[at] = interval.From;
  batch.TMax[at] = interval.To;
}

FieldRay RayOf(const rays::Batch& batch, std::size_t at) noexcept
{
  return {{batch.Origin[0][at], batch.Origin[1][at], batch.Origin[2][at]},
          {batch.Direction[0][at], batch.Direction[1][at], batch.Direction[2][at]}};
}

// The kernel's result, completed by RayTraversal if it was left unfinished.
FieldHit Answer(const ScalarField& field, const rays::Batch& batch, std::size_t at,
                MaterialSet materials) noexcept
{
  const RayInterval interval{batch.TMin[at], batch.TMax[at]};
  const rays::Outcome outcome = batch.Answer[at];
  if (outcome == rays::Outcome::Unstarted)
  {
    return Cast(field, RayOf(batch, at), interval, materials);
  }
  if (outcome == rays::Outcome::Underway)
  {
    return Traverse(field, RayOf(batch, at), interval, materials,
                    [&batch, at](auto&& traversal) {
                      return traversal.RunFrom(batch.Cell[at], batch.T[at], batch.StartsInside[at]);
                    });
  }
  FieldHit hit;
  hit.StartsInside = batch.StartsInside[at];
  if (outcome == rays::Outcome::Surface)
  {
    hit.Kind = HitKind::Surface;
    hit.IsEntering = batch.IsEntering[at];
    hit.Material = batch.Material[at];
    hit.T = batch.T[at];
    hit.Gradient = {batch.Gradient[at][0], batch.Gradient[at][1], batch.Gradient[at][2]};
  }
  return hit;
}
} // namespace

RayCaster::RayCaster(std::shared_ptr<const ScalarField> field, InstructionSet set)
    : Data(std::move(field)), Set(set)
{
}

FieldHit RayCaster::CastIndex(const FieldRay& rayIndex, double tMin, double tMax,
                              MaterialSet materials) const noexcept
{
  return Cast(*this->Data, rayIndex, {tMin, tMax}, materials);
}

FieldHit RayCaster::CastWorld(const FieldRay& rayWorld, double tMin, double tMax,
                              MaterialSet materials) const noexcept
{
  const FieldGrid& grid = this->Data->Grid();
  FieldHit hit = Cast(*this->Data, IndexRay(grid, rayWorld), {tMin, tMax}, materials);
  MoveToWorld(grid, rayWorld, hit);
  return hit;
}

void RayCaster::CastAllWorld(const FieldRay* raysWorld, const RayInterval* intervals,
                             std::size_t count, FieldHit* hits,
                             MaterialSet materials) const noexcept
{
  if (this->Set == InstructionSet::Avx2)
  {
    return this->CastInLanes(raysWorld, intervals, count, hits, materials);
  }
  for (std::size_t ray = 0; ray < count; ++ray)
  {
    hits[ray] = this->CastWorld(raysWorld[ray], intervals[ray].From, intervals[ray].To, materials);
  }
}

void RayCaster::CastInLanes(const FieldRay* raysWorld, const RayInterval* intervals,
                            std::size_t count, FieldHit* hits, MaterialSet materials) const noexcept
{
  const ScalarField& field = *this->Data;
  const FieldGrid& grid = field.Grid();
  rays::Field described;
  DescribeField(field, materials, described);
  rays::Batch batch;
  for (std::size_t first = 0; first < count; first += rays::MostRays)
  {
    const std::size_t size = std::min<std::size_t>(count - first, rays::MostRays);
    for (std::size_t at = 0; at < size; ++at)
    {
      Put(IndexRay(grid, raysWorld[first + at]), intervals[first + at], at, batch);
    }
    for (std::size_t at = size; at % rays::Lanes != 0; ++at)
    {
      Put({Vector3::Zero(), Vector3::Zero()}, {}, at, batch);
    }
    rays::CastAvx2(described, static_cast<int>(size), batch);
    for (std::size_t at = 0; at < size; ++at)
    {
      hits[first + at] = Answer(field, batch, at, materials);
      MoveToWorld(grid, raysWorld[first + at], hits[first + at]);
    }
  }
}
} // namespace palpate
