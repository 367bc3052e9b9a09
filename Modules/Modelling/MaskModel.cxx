#include "MaskModel.h"

#include "DecimalText.h"
#include "MappedSurface.h"
#include "MaskComponents.h"
#include "ParametricFit.h"
#include "RadialSampling.h"
#include "SphericalHarmonicFit.h"
#include "StarShape.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <numeric>
#include <string>
#include <vector>

namespace palpate
{
namespace
{
constexpr int Frequency = 20;      // 4,002 directions
constexpr double LeastDice = 0.75; // as FitSettings::MinimumDice

double DiceOfLargest(const MaskComponents& parts)
{
  const std::vector<long long>& voxels = parts.VoxelCounts();
  const auto largest = static_cast<double>(voxels.front());
  return 2.0 * largest /
         (largest + static_cast<double>(std::accumulate(voxels.begin(), voxels.end(), 0LL)));
}

// Messages of the surface's kernels are sentences, or begin with what the structure has or is.
Status OfMask(const Status& status)
{
  const std::string& message = status.Message();
  return !message.empty() && std::islower(static_cast<unsigned char>(message.front())) != 0
             ? Status::Failure("the mask " + message)
             : status;
}

Status FitParametric(const VoxelMask& mask, const IndexToWorld& toWorld, int degree,
                     SurfaceModel& model)
{
  MappedSurface mapped;
  Status status = MakeMappedSurface(mask, toWorld, {}, {}, mapped);
  // Of a sponge, its holes are the reason.
  const Status changed = CheckTopology(mapped.Topology, {});
  if (!changed.IsOk() || !status.IsOk())
  {
    return OfMask(changed.IsOk() ? status : changed);
  }
  ParametricFitOptions options;
  options.Degree = degree;
  ParametricFitResult fit;
  status = FitParametricSurface(mapped.Mesh, mapped.Directions, options, fit);
  if (status.IsOk())
  {
    model = fit.Surface;
  }
  return status;
}

Status FitRadii(const IndexedMesh& mesh, const MaskModelSettings& settings, SurfaceModel& model)
{
  const Vector3 center = VolumeCentroid(mesh);
  const double hidden = JudgeStarShape(mesh, center).HiddenPercent;
  if (hidden > settings.MaximumHiddenPercent)
  {
    return Status::Failure("the mask is not star-shaped: " + FixedText(hidden, 1) +
                           " % of its surface is hidden from its centre");
  }
  SphericalHarmonicFitOptions options;
  options.Degree = settings.Degree;
  SphericalHarmonicFitResult fit;
  const Status status =
      FitSphericalHarmonics(SampleRadially(mesh, center, Frequency), options, fit);
  if (status.IsOk())
  {
    model = SphericalHarmonicModel(settings.Degree, fit.Coefficients, center);
  }
  return status;
}

// As vtkSegmentationSurface has it for a fit of radii: no finer than the voxels, whose steps would
// hide parts from the centre, and smoothed by half a voxel.
GenusZeroSettings StarSurface(const VoxelMask& mask)
{
  std::array<double, 3> spacing = mask.Spacing;
  std::sort(spacing.begin(), spacing.end());
  GenusZeroSettings settings;
  settings.Field = ShapeFieldSettings::OfStar();
  settings.Field.CellsOnSurface = 12000.0;
  settings.Field.Spacing = std::max(spacing[1], ShapeFieldSpacing(mask, settings.Field));
  settings.Field.Smoothing = 0.5 * spacing[1] / settings.Field.Spacing;
  return settings;
}

Status FitStar(const VoxelMask& mask, const IndexToWorld& toWorld,
               const MaskModelSettings& settings, SurfaceModel& model)
{
  GenusZeroSurface surface;
  const Status status = MakeGenusZeroSurface(mask, StarSurface(mask), {}, surface);
  const Status changed = CheckTopology(surface.Topology, {});
  if (!changed.IsOk() || !status.IsOk())
  {
    return OfMask(changed.IsOk() ? status : changed);
  }
  MoveToWorld(mask, toWorld, surface.Mesh);
  return FitRadii(surface.Mesh, settings, model);
}
} // namespace

Status FitMask(VoxelMask mask, const IndexToWorld& toWorld, const MaskModelSettings& settings,
               SurfaceModel& model)
{
  if (mask.Count() == 0)
  {
    return Status::Failure("the mask has no voxels");
  }
  const MaskComponents parts(mask);
  const bool hasParts = parts.VoxelCounts().size() > 1;
  if (hasParts && !settings.IsStarShaped)
  {
    const Status whole = FitParametric(mask, toWorld, settings.Degree, model);
    if (whole.IsOk() || DiceOfLargest(parts) < LeastDice)
    {
      return whole;
    }
  }
  if (DiceOfLargest(parts) < LeastDice)
  {
    return Status::Failure("the mask has " + std::to_string(parts.VoxelCounts().size()) +
                           " parts, and a star-shaped model of the largest would miss too much");
  }
  parts.Keep(0, mask);
  return settings.IsStarShaped ? FitStar(mask, toWorld, settings, model)
                               : FitParametric(mask, toWorld, settings.Degree, model);
}
} // namespace palpate
