#include "SurfaceModelUncertainty.h"

#include "RadialModelFit.h"
#include "SurfaceSamples.h"

#include <limits>

namespace palpate
{
Status AssessSurfaceModelFit(const IndexedMesh& mesh, const SurfaceModelFitResult& fit,
                             SurfaceModelUncertainty& uncertainty)
{
  const int degree = fit.Surface.Degree();
  const SurfaceSamples samples = SampleMesh(mesh, fit.Parameters, SampleSpacingFor(degree));
  std::vector<SurfaceModel::Sample> there(samples.Parameters.size());
  fit.Surface.EvaluateBatch(samples.Parameters.data(), there.size(), there.data());
  std::vector<double> left(there.size());
  for (std::size_t i = 0; i < left.size(); ++i)
  {
    left[i] = samples.Normals[i].dot(samples.Points[i] - there[i].Point);
  }
  RadialModelFitOptions options;
  options.Degree = degree;
  options.MaximumCondition = std::numeric_limits<double>::max(); // for the verdict to state
  RadialModelFitResult series;
  Status status = FitRadialModel({samples.Parameters, left, samples.Weights}, options, series);
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
