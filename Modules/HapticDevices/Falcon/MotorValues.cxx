#include "MotorValues.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
FalconNumbers MotorValuesFor(const Vector3& torques, double countsPerNewtonMillimeter) noexcept
{
  const Vector3 values = -countsPerNewtonMillimeter * torques;
  FalconNumbers motors{};
  if (values.allFinite())
  {
    const double scale =
        LargestMotorValue / std::max(LargestMotorValue, values.cwiseAbs().maxCoeff());
    for (int leg = 0; leg < 3; ++leg)
    {
      motors[static_cast<std::size_t>(leg)] =
          static_cast<std::int16_t>(std::lround(scale * values[leg]));
    }
  }
  return motors;
}
} // namespace palpate
