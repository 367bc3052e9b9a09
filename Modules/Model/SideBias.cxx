#include "SideBias.h"

#include <limits>

namespace palpate
{
namespace
{
template <std::size_t Count>
void Normalise(std::array<SideBias::Part, Count>& parts)
{
  for (SideBias::Part& part : parts)
  {
    part.Mean =
        part.Share > 0.0 ? part.Mean / part.Share : std::numeric_limits<double>::quiet_NaN();
  }
}
} // namespace

SideBias SideBias::Of(const DistanceSamples& samples, const Vector3& center)
{
  SideBias bias;
  const auto add = [](Part& part, double distance, double weight)
  {
    part.Mean += weight * distance;
    part.Share += weight;
  };
  for (std::size_t i = 0; i < samples.Points.size(); ++i)
  {
    const Vector3 arm = samples.Points[i] - center;
    Eigen::Index axis = 0;
    arm.cwiseAbs().maxCoeff(&axis);
    const auto side = static_cast<std::size_t>(2 * axis + (arm[axis] < 0.0 ? 1 : 0));
    add(bias.Sides[side], samples.Values[i], samples.Weights[i]);
    const std::size_t octant =
        (arm.x() < 0.0 ? 1U : 0U) + (arm.y() < 0.0 ? 2U : 0U) + (arm.z() < 0.0 ? 4U : 0U);
    add(bias.Octants[octant], samples.Values[i], samples.Weights[i]);
  }
  Normalise(bias.Sides);
  Normalise(bias.Octants);
  return bias;
}
} // namespace palpate
