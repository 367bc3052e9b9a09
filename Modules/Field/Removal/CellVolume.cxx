#include "CellVolume.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr int Count = 4;
constexpr std::array<double, Count> Nodes{
    {0.069431844202973712, 0.33000947820757187, 0.66999052179242813, 0.93056815579702629}};
constexpr std::array<double, Count> Weights{
    {0.17392742256872693, 0.32607257743127307, 0.32607257743127307, 0.17392742256872693}};

double Mean(double a, double b, double u)
{
  return a * (1.0 - u) + b * u;
}

// Of the way from `a` to `b`, the part on which what runs straight between them is not negative.
double PositivePart(double a, double b)
{
  if (a >= 0.0 && b >= 0.0)
  {
    return 1.0;
  }
  if (a < 0.0 && b < 0.0)
  {
    return 0.0;
  }
  return std::max(a, b) / (std::max(a, b) - std::min(a, b));
}
} // namespace

double InsidePartOfCell(const std::array<double, 8>& corners) noexcept
{
  const auto [least, most] = std::minmax_element(corners.begin(), corners.end());
  if (*least >= 0.0 || *most < 0.0)
  {
    return *least >= 0.0 ? 1.0 : 0.0;
  }
  double part = 0.0;
  for (std::size_t i = 0; i < Count; ++i)
  {
    const double u = Nodes[i];
    const double near[2] = {Mean(corners[0], corners[1], u), Mean(corners[4], corners[5], u)};
    const double far[2] = {Mean(corners[2], corners[3], u), Mean(corners[6], corners[7], u)};
    for (std::size_t j = 0; j < Count; ++j)
    {
      const double v = Nodes[j];
      part += Weights[i] * Weights[j] *
              PositivePart(Mean(near[0], far[0], v), Mean(near[1], far[1], v));
    }
  }
  return part;
}
} // namespace palpate
