#include "RadialSamples.h"

#include "SphericalHarmonicBasis.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace palpate
{
Status CheckSamples(const RadialSamples& samples, int degree)
{
  if (degree < 0)
  {
    return Status::Failure("the degree must not be negative");
  }
  const std::size_t count = samples.Directions.size();
  if (samples.Radii.size() != count || samples.Weights.size() != count)
  {
    return Status::Failure("directions, radii and weights differ in number");
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const double weight = samples.Weights[i];
    if (!std::isfinite(samples.Radii[i]) || !samples.Directions[i].allFinite() ||
        !std::isfinite(weight) || weight < 0.0)
    {
      return Status::Failure("a sample is not finite or has a negative weight");
    }
  }
  const std::size_t used = CountWeighted(samples.Weights);
  const std::size_t needed = SphericalHarmonicBasis::CoefficientCount(degree);
  if (used < needed)
  {
    std::ostringstream text;
    text << used << " samples cannot determine the " << needed << " coefficients of degree "
         << degree << "; take more directions or a lower degree";
    return Status::Failure(text.str());
  }
  return Status::Success();
}

std::size_t CountWeighted(const std::vector<double>& weights)
{
  return static_cast<std::size_t>(
      std::count_if(weights.begin(), weights.end(), [](double weight) { return weight > 0.0; }));
}

std::vector<double> NormalisedWeights(const std::vector<double>& weights)
{
  const double largest = weights.empty() ? 0.0 : *std::max_element(weights.begin(), weights.end());
  std::vector<double> normalised(weights.size(), 0.0);
  if (!(largest > 0.0))
  {
    return normalised;
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    normalised[i] = weights[i] / largest;
    sum += normalised[i];
  }
  for (double& weight : normalised)
  {
    weight *= 4.0 * M_PI / sum;
  }
  return normalised;
}
} // namespace palpate
