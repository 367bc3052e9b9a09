#include "FeltStiffness.h"

#include "ComplianceAtlas.h"
#include "ElasticForce.h"
#include "ForcePerception.h"
#include "IcosahedronDirections.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
FeltStiffness FeltStiffness::Of(const RadialModel& model, const ComplianceMaps& maps,
                                double ballRadius, const std::vector<Vector3>& directions)
{
  constexpr double DepthOfOrgan = 0.1;
  constexpr double RootOfSphere = 3.5449077018110320546; // sqrt(4 pi)
  constexpr int Frequency = 12;
  constexpr double None = std::numeric_limits<double>::quiet_NaN();
  const ComplianceAtlas atlas(maps);
  FeltStiffness felt;
  felt.Depth =
      std::min(DepthOfBall * ballRadius, DepthOfOrgan * model.Coefficients()[0] / RootOfSphere);
  const auto forceAt = [&](const Vector3& direction)
  {
    const ElasticForce force = ElasticForce::Of(atlas, model, direction, felt.Depth, ballRadius);
    return force.IsValid ? force.ForceWorld.norm() : None;
  };
  const IcosahedronDirections even(Frequency);
  std::vector<double> all;
  for (const Vector3& direction : even.Directions())
  {
    const double force = forceAt(direction);
    if (!std::isnan(force))
    {
      all.push_back(force);
    }
  }
  std::sort(all.begin(), all.end());
  felt.Median = all.empty() ? None : all[all.size() / 2];
  felt.Least = all.empty() ? None : all.front();
  felt.Most = all.empty() ? None : all.back();
  for (const Vector3& direction : directions)
  {
    felt.Forces.push_back(forceAt(direction));
    felt.Noticed.push_back(ForcePerception::Contrast(felt.Forces.back(), felt.Median));
  }
  return felt;
}
} // namespace palpate
