#include "MaskShape.h"

#include "FieldVolume.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
Status MakeMaskShape(const VoxelMask& mask, double volume, const MaskShapeSettings& settings,
                     ShapeField& field)
{
  std::array<double, 3> spacing = mask.Spacing;
  std::sort(spacing.begin(), spacing.end());
  ShapeFieldSettings shape = ShapeFieldSettings::OfStar();
  shape.MaximumNodes = 6e7; // 240 MB
  double wanted = 0.0;
  if (settings.CellsOnSurface > 0)
  {
    shape.CellsOnSurface = std::max(settings.CellsOnSurface, 10);
    wanted = ShapeFieldSpacing(mask, shape);
  }
  shape.Spacing = std::max(spacing[1], wanted);
  shape.Smoothing = std::min(0.5 * settings.Smoothing * spacing[1] / shape.Spacing, 8.0);
  if (Status made = MakeShapeField(mask, shape, field); !made.IsOk())
  {
    return made;
  }
  const double area = std::cbrt(36.0 * M_PI * volume * volume); // of a sphere
  const float level = LevelOfVolume(field, volume, area);
  std::for_each(field.Values.begin(), field.Values.end(), [level](float& v) { v -= level; });
  return Status::Success();
}
} // namespace palpate
