#include "GroupReparametrisation.h"

#include "CaseLoop.h"
#include "ParameterDescent.h"
#include "ReparametrisedSurface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace palpate
{
namespace
{
constexpr double DescentShare = 0.8;        // of the progress
constexpr std::size_t RefittedTogether = 8; // between calls of the progress
constexpr int MostHalvedFlows = 3;
constexpr double LeastTurn = 1e-6; // rad; less is no move

// Moves less far while that would change the surface; leaves it alone if even that does.
void MoveWithin(double tolerance, const SurfaceModel& surface, SphereFlow flow, SurfaceModel& moved,
                ReparametrisedCase& one)
{
  for (int shortening = 0; !flow.IsIdentity() && shortening < MostHalvedFlows; ++shortening)
  {
    const ReparametrisedSurface found = Reparametrise(surface, flow);
    if (found.IsOneToOne && found.RmsChange <= tolerance && found.RmsTurn > LeastTurn)
    {
      moved = found.Surface;
      one = {true, found.RmsTurn, found.LeastAreaRatio, found.RmsChange, found.LargestChange};
      return;
    }
    flow.Shorten(0.5);
  }
}

Status CheckGroup(const std::vector<SurfaceModel>& surfaces)
{
  if (surfaces.size() < 3)
  {
    return Status::Failure("parameters of a group need at least three surfaces");
  }
  const bool isOneDegree = std::all_of(surfaces.begin(), surfaces.end(),
                                       [&](const SurfaceModel& surface)
                                       { return surface.Degree() == surfaces.front().Degree(); });
  return isOneDegree ? Status::Success()
                     : Status::Failure("the surfaces of a group must have one degree");
}
} // namespace

Status ReparametriseGroup(const std::vector<SurfaceModel>& surfaces,
                          const ReparametrisationSettings& settings,
                          ReparametrisationResult& result, const KernelProgress& progress)
{
  const Status status = CheckGroup(surfaces);
  if (!status.IsOk())
  {
    return status;
  }
  const auto isCancelled = [&](double done) { return progress && !progress(done); };
  ParameterDescent descent(surfaces, settings);
  if (!std::isfinite(descent.Length()))
  {
    return Status::Failure("a surface of the group is not finite");
  }
  result.Lengths = {descent.Length()};
  for (int round = 0; round < settings.MostRounds; ++round)
  {
    if (isCancelled(DescentShare * round / settings.MostRounds))
    {
      return Status::Failure("cancelled");
    }
    const double before = descent.Length();
    if (!descent.Step())
    {
      break;
    }
    result.Lengths.push_back(descent.Length());
    if (before - descent.Length() < settings.LeastGain * before)
    {
      break;
    }
  }
  descent.DropUselessMoves();
  result.Surfaces = surfaces;
  result.Cases.assign(surfaces.size(), {});
  for (std::size_t first = 0; first < surfaces.size(); first += RefittedTogether)
  {
    const double done = static_cast<double>(first) / static_cast<double>(surfaces.size());
    if (isCancelled(DescentShare + (1.0 - DescentShare) * done))
    {
      return Status::Failure("cancelled");
    }
    ForEachCase(std::min(RefittedTogether, surfaces.size() - first), settings.Threads,
                [&](std::size_t k)
                {
                  const std::size_t i = first + k;
                  MoveWithin(settings.ToleranceMillimeters, surfaces[i], descent.FlowOf(i),
                             result.Surfaces[i], result.Cases[i]);
                });
  }
  const DescriptionLength before = descent.Measure(surfaces);
  DescriptionLength after = descent.Measure(result.Surfaces);
  if (!(after.Value < before.Value))
  {
    result.Surfaces = surfaces;
    result.Cases.assign(surfaces.size(), {});
    after = before;
  }
  result.LengthBefore = before.Value;
  result.LengthAfter = after.Value;
  result.VarianceBefore = before.Variance;
  result.VarianceAfter = after.Variance;
  return isCancelled(1.0) ? Status::Failure("cancelled") : Status::Success();
}
} // namespace palpate
