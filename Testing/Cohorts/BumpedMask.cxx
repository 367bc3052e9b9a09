#include "BumpedMask.h"

#include "FieldVolume.h"
#include "ShapeField.h"

#include <cmath>
#include <stdexcept>

namespace palpate::test
{
namespace
{
// A body as what is above a level of its mask's shape field.
struct ShapeLevel
{
  ShapeField Field;
  double Level = 0.0;
};

ShapeLevel ShapeOfMask(const VoxelMask& mask)
{
  ShapeLevel shape;
  // Bodies that follow each slice more closely have steps between the slices, and move with these:
  // their voxels lose a tenth of a bump.
  const ShapeFieldSettings settings = ShapeFieldSettings::OfStar();
  if (const Status status = MakeShapeField(mask, settings, shape.Field); !status.IsOk())
  {
    throw std::runtime_error(status.Message());
  }
  const double volume = static_cast<double>(mask.Count()) * mask.VoxelVolume();
  const double area = std::cbrt(36.0 * M_PI * volume * volume); // of the sphere
  shape.Level = LevelOfVolume(shape.Field, volume, area);
  return shape;
}
} // namespace

VoxelMask WithBump(const VoxelMask& mask, const IndexToWorld& toWorld, const Vector3& centerWorld,
                   const SurfaceBump& bump, double shift)
{
  const ShapeLevel shape = ShapeOfMask(mask);
  const Vector3 spacing(mask.Spacing[0], mask.Spacing[1], mask.Spacing[2]);
  const Matrix3 axes = toWorld.Axes * spacing.cwiseInverse().asDiagonal();
  VoxelMask bumped = mask;
  for (int k = 0; k < mask.Size[2]; ++k)
  {
    for (int j = 0; j < mask.Size[1]; ++j)
    {
      for (int i = 0; i < mask.Size[0]; ++i)
      {
        const Vector3 index(i, j, k + shift);
        const Vector3 start(mask.StartIndex[0], mask.StartIndex[1], mask.StartIndex[2]);
        const Vector3 offset = toWorld(start + index) - centerWorld;
        const Vector3 direction = offset.normalized();
        Vector3 point = spacing.cwiseProduct(index);
        if (offset.norm() > 0.0 && bump.Covers(direction))
        {
          point -= bump.AlongRadius(direction) * (axes.transpose() * direction);
        }
        bumped.Inside[mask.Offset(i, j, k)] = shape.Field.Sample(point) > shape.Level ? 1 : 0;
      }
    }
  }
  return bumped;
}
} // namespace palpate::test
