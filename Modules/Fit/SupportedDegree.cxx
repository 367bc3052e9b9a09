#include "SupportedDegree.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
int SupportedDegree(double cubicMillimeters, vtkImageData* mask)
{
  constexpr double Highest = 1000.0;
  const double* spacing = mask->GetSpacing();
  const double coarsest = std::max({spacing[0], spacing[1], spacing[2]});
  const double radius = std::cbrt(3.0 * cubicMillimeters / (4.0 * M_PI));
  return static_cast<int>(std::clamp(std::floor(M_PI * radius / coarsest), 1.0, Highest));
}
} // namespace palpate
