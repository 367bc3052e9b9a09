#include "ComparisonNames.h"

#include "DecimalText.h"

namespace palpate
{
std::string ToleranceText(double millimeters)
{
  return SignificantText(millimeters, 6);
}

std::string SignedText(double value, int digits)
{
  return (value > 0.0 ? "+" : "") + FixedText(value, digits);
}

std::string OctantName(std::size_t octant)
{
  return std::string((octant & 1U) != 0 ? "right" : "left") + "-" +
         ((octant & 2U) != 0 ? "anterior" : "posterior") + "-" +
         ((octant & 4U) != 0 ? "inferior" : "superior");
}

std::string CellsText(const BodyOverlap& overlap)
{
  const auto number = [&](Eigen::Index axis) { return SignificantText(overlap.Spacing[axis], 3); };
  if (overlap.Kind == BodyOverlap::Cells::None)
  {
    return "integrals over both surfaces";
  }
  if (overlap.Kind == BodyOverlap::Cells::Cubes)
  {
    return "cubes of " + number(0) + " mm";
  }
  return std::string(overlap.Kind == BodyOverlap::Cells::Voxels ? "voxels of "
                                                                : "the mask's voxels of ") +
         number(0) + " x " + number(1) + " x " + number(2) + " mm";
}
} // namespace palpate
