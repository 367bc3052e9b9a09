#include "RayCaster.h"

#include "RayTraversal.h"
#include "TricubicCell.h"
#include "TrilinearCell.h"

namespace palpate
{
namespace
{
FieldHit Cast(const ScalarField& field, const FieldRay& ray, double tMin, double tMax,
              MaterialSet materials, const CoordinateRounding& rounding) noexcept
{
  RayPath path;
  if (!path.Set(ray.Origin, ray.Direction) || std::isnan(tMin) || std::isnan(tMax))
  {
    FieldHit none;
    none.Kind = HitKind::BadRay;
    return none;
  }
  if (tMin > tMax)
  {
    return {};
  }
  return field.Interpolation() == FieldInterpolation::Trilinear
             ? RayTraversal<TrilinearCell>(field, path, tMin, tMax, materials, rounding).Run()
             : RayTraversal<TricubicCell>(field, path, tMin, tMax, materials, rounding).Run();
}
} // namespace

FieldHit RayCaster::CastIndex(const FieldRay& rayIndex, double tMin, double tMax,
                              MaterialSet materials) const noexcept
{
  FieldHit hit = Cast(*this->Data, rayIndex, tMin, tMax, materials, {});
  hit.ErrorLength = hit.ErrorT * this->Data->Grid().VectorWorld(rayIndex.Direction).norm();
  return hit;
}

FieldHit RayCaster::CastWorld(const FieldRay& rayWorld, double tMin, double tMax,
                              MaterialSet materials) const noexcept
{
  const FieldGrid& grid = this->Data->Grid();
  const FieldRay rayIndex{grid.PointIndex(rayWorld.Origin), grid.VectorIndex(rayWorld.Direction)};
  const CoordinateRounding rounding{grid.PointIndexRounding(rayWorld.Origin),
                                    grid.VectorIndexRounding(rayWorld.Direction)};
  FieldHit hit = Cast(*this->Data, rayIndex, tMin, tMax, materials, rounding);
  if (hit.Kind == HitKind::Surface || hit.Kind == HitKind::Border)
  {
    hit.Position = rayWorld.Origin + hit.T * rayWorld.Direction;
    hit.Gradient = grid.GradientWorld(hit.Gradient);
    hit.ErrorLength = hit.ErrorT * rayWorld.Direction.norm();
  }
  return hit;
}

void RayCaster::CastAllWorld(const FieldRay* raysWorld, std::size_t count, double tMin, double tMax,
                             FieldHit* hits, MaterialSet materials) const noexcept
{
  for (std::size_t ray = 0; ray < count; ++ray)
  {
    hits[ray] = this->CastWorld(raysWorld[ray], tMin, tMax, materials);
  }
}
} // namespace palpate
