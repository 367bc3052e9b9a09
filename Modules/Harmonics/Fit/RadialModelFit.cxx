#include "RadialModelFit.h"

#include "FitRun.h"
#include "MomentSolver.h"
#include "OrthogonalSolver.h"

#include <cmath>

namespace palpate
{
namespace
{
using Options = RadialModelFitOptions;

Status CheckOptions(const Options& options)
{
  if (options.PenaltyKind == Options::Penalty::Given && options.Degree > 0 &&
      !(options.Roughness > 0.0 && std::isfinite(options.Roughness)))
  {
    return Status::Failure("the roughness penalty must be a positive number");
  }
  return Status::Success();
}

} // namespace

Status FitRadialModel(const RadialSamples& samples, const RadialModelFitOptions& options,
                      RadialModelFitResult& result)
{
  Status status = CheckSamples(samples, options.Degree);
  if (status.IsOk())
  {
    status = CheckOptions(options);
  }
  if (!status.IsOk())
  {
    return status;
  }
  MomentSolver moments(options.Degree);
  FitRun run(samples, options, moments);
  status = run.Run(result);
  if (run.Able())
  {
    return status;
  }
  OrthogonalSolver orthogonal(options.Degree);
  return FitRun(samples, options, orthogonal).Run(result);
}
} // namespace palpate
