#include "SegmentColor.h"

#include "Segmentation.h"

#include "vtkMath.h"

#include <cmath>

namespace palpate
{
std::array<double, 3> DefaultSegmentColor(int label)
{
  std::array<double, 3> color = Segment().Color;
  if (label != 1)
  {
    constexpr double GoldenSection = 0.6180339887498949;
    const double hue = std::fmod(label * GoldenSection, 1.0);
    vtkMath::HSVToRGB(hue, 0.55, 0.9, &color[0], &color[1], &color[2]);
  }
  return color;
}
} // namespace palpate
