#include "ParametricUncertainty.h"

#include "SphericalHarmonicFit.h"
#include "SurfaceSamples.h"

#include <limits>

namespace palpate
{
Status AssessParametricFit(const IndexedMesh& mesh, const ParametricFitResult& fit,
                           ParametricUncertainty& uncertainty)
{
  const int degree = fit.Surface.Degree();
  const SurfaceSamples samples = SampleMesh(mesh, fit.Parameters, SampleSpacingFor(degree));
  std::vector<ParametricSphericalSurface::Sample> there(samples.Parameters.size());
  fit.Surface.EvaluateBatch(samples.Parameters.data(), there.size(), there.data());
  std::vector<double> left(there.size());
  for (std::size_t i = 0; i < left.size(); ++i)
  {
    left[i] = samples.Normals[i].dot(samples.Points[i] - there[i].Point);
  }
  SphericalHarmonicFitOptions options;
  options.Degree = degree;
  options.MaximumCondition = std::numeric_limits<double>::max(); // for the verdict to state
  SphericalHarmonicFitResult series;
  Status status =
      FitSphericalHarmonics({samples.Parameters, left, samples.Weights}, options, series);
  if (status.IsOk())
  {
    status = AssessCoverage(samples.Parameters, samples.Weights, series, uncertainty.Coverage);
  }
  uncertainty.Covariance = series.Covariance;
  uncertainty.Condition = series.Condition;
  uncertainty.NoiseDeviation = series.NoiseDeviation;
  uncertainty.DegreesOfFreedom = series.DegreesOfFreedom;
  return status;
}
} // namespace palpate
