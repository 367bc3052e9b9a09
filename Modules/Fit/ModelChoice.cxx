#include "ModelChoice.h"

#include "DecimalText.h"
#include "DegreeGoal.h"
#include "VoxelMinimum.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
using Outcome = FitResult::Outcome;

// In voxels (ResolutionOf). Of 164 whole glands at degree 12, half have 0.33 and 0.66 as radial
// models and 0.26 and 0.55 as surface models, which is not worth their time; capsules, a liver and
// a lung have 0.4 to 1.4 and 0.6 to 4.5 as radial ones, and at most half of that as surface models.
constexpr double Far95 = 0.45;
constexpr double FarMaximum = 1.0;
// Nearer by these, or by half of them if elongated, is clearly better.
constexpr double Clearly95 = 0.09;
constexpr double ClearlyMaximum = 0.75;
constexpr double ClearlyDice = 0.01;
constexpr double Slack = 0.05; // by which the other distance may grow

bool HasOtherVolume(const FitResult& radial)
{
  constexpr double LargestChange = 0.05; // of the volume
  return std::abs(radial.ModelMilliliters / radial.InputMilliliters() - 1.0) > LargestChange;
}

// Whether the surface's farthest point is much farther from the centre than its nearest: steps of
// equal angles are long there, and cut the surface at a slant.
bool IsElongated(const FitResult& radial)
{
  constexpr double LargestRatio = 3.0;
  const Vector3 center = CenterOf(radial.Model);
  double nearest = std::numeric_limits<double>::infinity();
  double farthest = 0.0;
  for (vtkIdType id = 0; id < radial.Surface->GetNumberOfPoints(); ++id)
  {
    Vector3 point;
    radial.Surface->GetPoint(id, point.data());
    nearest = std::min(nearest, (point - center).norm());
    farthest = std::max(farthest, (point - center).norm());
  }
  return farthest > LargestRatio * nearest;
}

bool IsFar(const FitResult& radial)
{
  const double voxel = ResolutionOf(radial);
  const SurfaceDistances& distances = radial.ModelToInput();
  return distances.Percentile95 > Far95 * voxel || distances.Maximum > FarMaximum * voxel ||
         IsElongated(radial);
}

bool IsClearlyNearer(const FitResult& surface, const FitResult& radial)
{
  const double voxel = ResolutionOf(radial);
  const SurfaceDistances& before = radial.ModelToInput();
  const SurfaceDistances& after = surface.ModelToInput();
  const double gain95 = (before.Percentile95 - after.Percentile95) / voxel;
  const double gainMaximum = (before.Maximum - after.Maximum) / voxel;
  const double needed = IsElongated(radial) ? 0.5 : 1.0;
  return std::min(gain95, gainMaximum) > -Slack &&
         (gain95 > needed * Clearly95 || gainMaximum > needed * ClearlyMaximum ||
          surface.Dice - radial.Dice > needed * ClearlyDice);
}

std::string DistanceText(const FitResult& result)
{
  const SurfaceDistances& distances = result.ModelToInput();
  return FixedText(distances.Percentile95, 2) + " mm (95 %) and " +
         FixedText(distances.Maximum, 2) + " mm (largest)";
}
} // namespace

bool MayTakeSurfaceModel(const FitSettings& settings)
{
  return settings.Model == FitSettings::ModelKind::Automatic && !settings.AcceptsAllHidden();
}

bool IsDoubtful(const FitResult& radial)
{
  if (radial.State == Outcome::Refused)
  {
    return true;
  }
  return radial.State == Outcome::Fitted && (MissesGoal(radial) || HasOtherVolume(radial) ||
                                             (radial.Settings.Rules > 1 && IsFar(radial)));
}

bool IsBetter(const FitResult& surface, const FitResult& radial)
{
  const bool isFitted = surface.State == Outcome::Fitted;
  if (radial.State == Outcome::Fitted)
  {
    return isFitted && (radial.Settings.Rules > 1 ? IsClearlyNearer(surface, radial)
                                                  : surface.Dice > radial.Dice);
  }
  return isFitted || (surface.State == Outcome::Refused && !surface.OptionHint.empty());
}

std::string ReasonOfChoice(const FitResult& surface, const FitResult& radial)
{
  if (surface.State != Outcome::Fitted || radial.State != Outcome::Fitted)
  {
    return {};
  }
  const bool isTaken = IsBetter(surface, radial);
  return std::string("a ") + (isTaken ? "surface" : "radial") + " model was taken: it is within " +
         DistanceText(isTaken ? surface : radial) + " of the " +
         (radial.IsOfSurface ? "surface" : "mask's boundary") + ", a " +
         (isTaken ? "radial" : "surface") + " one within " +
         DistanceText(isTaken ? radial : surface);
}
} // namespace palpate
