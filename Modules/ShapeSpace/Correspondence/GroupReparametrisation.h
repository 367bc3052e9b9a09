#pragma once

#include "KernelProgress.h"
#include "Status.h"
#include "SurfaceModel.h"

#include <vector>

namespace palpate
{
struct ReparametrisationSettings
{
  int FieldDegree = 4;           ///< of the harmonics of a step (SphereFlow)
  double NoiseMillimeters = 0.5; ///< RMS; variation below it is not worth a description
  double Damping = 0.01;         ///< of a step, relative to its curvature
  int MostRounds = 60;
  double LeastGain = 1e-3;           ///< relative decrease of the length below which rounds end
  double ToleranceMillimeters = 0.1; ///< RMS, by which a surface may change in its own degree
  int Threads = 0;                   ///< 0: one per processor; has no influence on the result
};

/// What became of one surface.
struct ReparametrisedCase
{
  bool IsMoved = false;
  double RmsTurn = 0.0;        ///< of the parameters over the sphere, rad
  double LeastAreaRatio = 1.0; ///< of areas on the parameter sphere, after over before
  ///@{ Distance of the surface, fitted again, from what it was, mm.
  double RmsChange = 0.0;
  double LargestChange = 0.0;
  ///@}
};

struct ReparametrisationResult
{
  std::vector<SurfaceModel> Surfaces;
  std::vector<ReparametrisedCase> Cases;
  std::vector<double> Lengths; ///< DescriptionLength of the given parameters and after each round
  double LengthBefore = 0.0;   ///< of the given surfaces
  double LengthAfter = 0.0;    ///< of the results
  double VarianceBefore = 0.0; ///< mm^2
  double VarianceAfter = 0.0;  ///< mm^2
};

/// Moves the parameters of each surface, one to one, so that the group's modes have a shorter
/// description (DescriptionLength; Davies et al., IEEE TMI 21, 2002), while the surfaces stay. The
/// sphere is weighted by the area of the mean surface at the start.
///
/// Each round is a Gauss-Newton step of all surfaces towards what the others predict of each: by
/// majorisation that lowers the length, and a common factor of the steps is halved until it does.
/// The steps sum to zero, so that the parameters of the group as a whole do not drift. Afterwards a
/// surface that is as well off with its own parameters keeps them, and the others are fitted again
/// in their own degree; one that would change by more than the tolerance moves half as far, or
/// stays. If all that does not shorten the description, all stay.
///
/// `surfaces` of one degree, in common axes. The order has no influence beyond rounding, the number
/// of threads none at all. Fails for fewer than three surfaces, which say nothing about each other,
/// for different degrees, and if `progress` cancels.
Status ReparametriseGroup(const std::vector<SurfaceModel>& surfaces,
                          const ReparametrisationSettings& settings,
                          ReparametrisationResult& result, const KernelProgress& progress = {});
} // namespace palpate
