#include "SphericalHarmonicFit.h"

#include "FitRun.h"
#include "OrthogonalSolver.h"

#include <cmath>

namespace palpate
{
namespace
{
using Options = SphericalHarmonicFitOptions;

Status CheckOptions(const Options& options)
{
  if (options.PenaltyKind == Options::Penalty::Given && options.Degree > 0 &&
      !(options.Roughness > 0.0 && std::isfinite(options.Roughness)))
  {
    return Status::Failure("the roughness penalty must be a positive number");
  }
  return Status::Success();
}

Status FitOrthogonally(const RadialSamples& samples, const Options& options,
                       SphericalHarmonicFitResult& result)
{
  OrthogonalSolver solver(options.Degree);
  Status status = FitRun(samples, options, solver).Run(result);
  result.UsedMethod = Options::Method::Orthogonal;
  return status;
}

Status FitByMoments(const RadialSamples& samples, const Options& options, MomentSolver& workspace,
                    SphericalHarmonicFitResult& result)
{
  FitRun run(samples, options, workspace);
  Status status = run.Run(result);
  result.UsedMethod = Options::Method::Moments;
  return run.Able() || options.MethodKind == Options::Method::Moments
             ? status
             : FitOrthogonally(samples, options, result);
}

Status Check(const RadialSamples& samples, const Options& options)
{
  Status status = CheckSamples(samples, options.Degree);
  return status.IsOk() ? CheckOptions(options) : status;
}
} // namespace

Status FitSphericalHarmonics(const RadialSamples& samples,
                             const SphericalHarmonicFitOptions& options,
                             SphericalHarmonicFitResult& result)
{
  Status status = Check(samples, options);
  if (!status.IsOk())
  {
    return status;
  }
  if (options.MethodKind == Options::Method::Orthogonal)
  {
    return FitOrthogonally(samples, options, result);
  }
  MomentSolver workspace(options.Degree);
  return FitByMoments(samples, options, workspace, result);
}

Status FitSphericalHarmonics(const RadialSamples& samples,
                             const SphericalHarmonicFitOptions& options, MomentSolver& workspace,
                             SphericalHarmonicFitResult& result)
{
  Status status = Check(samples, options);
  if (!status.IsOk())
  {
    return status;
  }
  if (options.MethodKind == Options::Method::Orthogonal)
  {
    return FitOrthogonally(samples, options, result);
  }
  if (workspace.Degree() != options.Degree)
  {
    return Status::Failure("the workspace of the fit has a different degree");
  }
  return FitByMoments(samples, options, workspace, result);
}
} // namespace palpate
