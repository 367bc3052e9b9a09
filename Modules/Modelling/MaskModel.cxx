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
constexpr int Frequency = 20; // 4,002 directions

// All but the largest, which are left out.
TopologyChange SmallerParts(const MaskComponents& parts, double voxelVolume)
{
  const std::vector<long long>& voxels = parts.VoxelCounts();
  TopologyChange smaller;
  if (voxels.size() > 1)
  {
    smaller.Count = static_cast<int>(voxels.size()) - 1;
    smaller.Volume =
        voxelVolume * static_cast<double>(std::accumulate(voxels.begin() + 1, voxels.end(), 0LL));
    smaller.LargestVolume = voxelVolume * static_cast<double>(voxels[1]);
  }
  return smaller;
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
                     const TopologyChange& leftOut, SurfaceModel& model, TopologyReport& changes)
{
  MappedSurface mapped;
  Status status = MakeMappedSurface(mask, toWorld, {}, {}, mapped);
  // Of a sponge, its holes are the reason.
  changes = mapped.Topology;
  changes.Add(leftOut);
  const Status changed = CheckTopology(changes, {});
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
               const MaskModelSettings& settings, const TopologyChange& leftOut,
               SurfaceModel& model, TopologyReport& changes)
{
  GenusZeroSurface surface;
  const Status status = MakeGenusZeroSurface(mask, StarSurface(mask), {}, surface);
  changes = surface.Topology;
  changes.Add(leftOut);
  const Status changed = CheckTopology(changes, {});
  if (!changed.IsOk() || !status.IsOk())
  {
    return OfMask(changed.IsOk() ? status : changed);
  }
  MoveToWorld(mask, toWorld, surface.Mesh);
  return FitRadii(surface.Mesh, settings, model);
}
} // namespace

Status FitMask(VoxelMask mask, const IndexToWorld& toWorld, const MaskModelSettings& settings,
               SurfaceModel& model, TopologyReport* changes)
{
  if (mask.Count() == 0)
  {
    return Status::Failure("the mask has no voxels");
  }
  TopologyReport made;
  const MaskComponents parts(mask);
  const TopologyChange smaller = SmallerParts(parts, mask.VoxelVolume());
  const double all = mask.VoxelVolume() * static_cast<double>(mask.Count());
  const bool isTooMuch = 100.0 * smaller.Volume > TopologyLimits().ChangedPercent * all;
  const bool takesInParts = smaller.Count > 0 && !settings.IsStarShaped;
  Status status = takesInParts ? FitParametric(mask, toWorld, settings.Degree, {}, model, made)
                               : Status::Failure({});
  if (!status.IsOk() && takesInParts && isTooMuch)
  {
    return status;
  }
  if (!status.IsOk())
  {
    parts.Keep(0, mask);
    status = settings.IsStarShaped
                 ? FitStar(mask, toWorld, settings, smaller, model, made)
                 : FitParametric(mask, toWorld, settings.Degree, smaller, model, made);
  }
  if (changes != nullptr)
  {
    *changes = made;
  }
  return status;
}
} // namespace palpate
