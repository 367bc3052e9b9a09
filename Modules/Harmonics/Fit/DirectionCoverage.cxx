#include "DirectionCoverage.h"

#include "CoefficientCovariance.h"
#include "IcosahedronDirections.h"
#include "RadialModelFit.h"
#include "SphericalHarmonicBasis.h"
#include "SphericalHarmonicConventions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace palpate
{
namespace
{
constexpr double Degree = M_PI / 180.0;

SphericalCap FindGap(const std::vector<Vector3>& directions, const std::vector<double>& weights)
{
  std::vector<Vector3> used;
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    if (weights[i] > 0.0)
    {
      used.push_back(directions[i]);
    }
  }
  const double spacing = std::sqrt(4.0 * M_PI / static_cast<double>(used.size()));
  return LargestEmptyCap(used, 0.25 * spacing);
}

// The largest noise gain over the sphere: from a grid of a third of the shortest wavelength and the
// centre of the gap, followed by uphill steps.
class GainSearch
{
public:
  GainSearch(const CoefficientCovariance& covariance, int degree)
      : Covariance(covariance), Basis(degree), Values(Basis.Size())
  {
  }

  void Try(const Vector3& direction)
  {
    this->Basis.Evaluate(direction, this->Values.data());
    const double gain = this->Covariance.RadiusDeviation(this->Values.data());
    if (gain > this->Gain || std::isnan(gain))
    {
      this->Gain = std::isnan(gain) ? std::numeric_limits<double>::infinity() : gain;
      this->Direction = direction;
    }
  }

  void Run(const Vector3& gapCenter)
  {
    const int frequency = std::clamp(this->Basis.Degree() / 2, 1, 12);
    const IcosahedronDirections sphere(frequency);
    for (const Vector3& direction : sphere.Directions())
    {
      this->Try(direction);
    }
    this->Try(gapCenter);
    constexpr int Halvings = 5; // down to a few thousandths of a radian
    double step = 0.5 / frequency;
    for (int halving = 0; halving < Halvings; ++halving, step *= 0.5)
    {
      const Vector3 center = this->Direction;
      const Vector3 side = center.unitOrthogonal();
      const Vector3 other = center.cross(side);
      for (int k = 0; k < 6; ++k)
      {
        const double angle = k * M_PI / 3.0;
        this->Try(
            (center + step * (std::cos(angle) * side + std::sin(angle) * other)).normalized());
      }
    }
  }

  double Gain = 0.0;
  Vector3 Direction = Vector3::UnitZ();

private:
  const CoefficientCovariance& Covariance;
  SphericalHarmonicBasis Basis;
  std::vector<double> Values;
};

void Judge(int degree, double strength, std::size_t count, DirectionCoverage& coverage)
{
  std::ostringstream text;
  text.precision(3);
  const double gap = coverage.LargestGap.Radius / Degree;
  const Vector3& center = coverage.LargestGap.Center;
  if (strength == 0.0 && !(coverage.Condition <= DirectionCoverage::HighestCondition))
  {
    coverage.Outcome = DirectionCoverage::Verdict::Undetermined;
    text << count << " directions leave degree " << degree << " undetermined (condition "
         << coverage.Condition << ", largest gap " << gap
         << " degrees in radius): add directions there or a roughness penalty, or take a lower "
            "degree";
  }
  else if (coverage.LargestGap.Radius > DirectionCoverage::WidestGap(degree))
  {
    coverage.Outcome = DirectionCoverage::Verdict::Gaps;
    text << "No direction within " << gap << " degrees of (" << center.x() << ", " << center.y()
         << ", " << center.z() << "): the surface there is a guess (noise gain up to "
         << coverage.NoiseGainMaximum << ")";
  }
  else if (!(coverage.NoiseGainMaximum <= DirectionCoverage::HighestNoiseGain))
  {
    coverage.Outcome = DirectionCoverage::Verdict::Gaps;
    text << count << " directions are too few or too uneven for degree " << degree
         << ": somewhere the fit carries " << coverage.NoiseGainMaximum
         << " times the noise of one sample";
  }
  else
  {
    coverage.Outcome = DirectionCoverage::Verdict::Good;
    text << count << " directions determine degree " << degree << " everywhere (largest gap " << gap
         << " degrees in radius, noise gain at most " << coverage.NoiseGainMaximum << ")";
  }
  coverage.Message = text.str();
}

} // namespace

double DirectionCoverage::WidestGap(int degree)
{
  return M_PI / std::max(1, degree);
}

Status AssessCoverage(const std::vector<Vector3>& directions, const std::vector<double>& weights,
                      const RadialModelFitResult& fit, DirectionCoverage& coverage)
{
  const int degree = DegreeOfCount(fit.Coefficients.size());
  const std::vector<double> radii(directions.size(), 0.0);
  Status status = CheckSamples({directions, radii, weights}, degree);
  if (!status.IsOk())
  {
    return status;
  }
  coverage = {};
  coverage.LargestGap = FindGap(directions, weights);
  coverage.Condition = fit.Condition;
  const std::size_t count = CountWeighted(weights);
  CoefficientCovariance covariance = fit.Covariance;
  covariance.SetVariance(4.0 * M_PI / static_cast<double>(count));
  GainSearch search(covariance, degree);
  search.Run(coverage.LargestGap.Center);
  coverage.NoiseGainMaximum = search.Gain;
  coverage.NoiseGainDirection = search.Direction;
  coverage.NoiseGainRms = std::sqrt(covariance.Trace() / (4.0 * M_PI));
  Judge(degree, fit.Roughness, count, coverage);
  return status;
}
} // namespace palpate
