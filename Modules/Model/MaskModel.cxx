#include "MaskModel.h"

#include "DecimalText.h"
#include "MappedSurface.h"
#include "MaskComponents.h"
#include "MaskSurface.h"
#include "RadialModelFit.h"
#include "RadialSampling.h"
#include "SurfaceModelFit.h"

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

Status FitSurface(const VoxelMask& mask, const IndexToWorld& toWorld, int degree,
                  const TopologyChange& leftOut, OrganModel& model, TopologyReport& changes)
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
  SurfaceModelFitOptions options;
  options.Degree = degree;
  SurfaceModelFitResult fit;
  status = FitSurfaceModel(mapped.Mesh, mapped.Directions, options, fit);
  if (status.IsOk())
  {
    model = fit.Surface;
  }
  return status;
}

Status FitRadii(const IndexedMesh& mesh, const MaskModelSettings& settings, OrganModel& model)
{
  const RadialSampling sampling = SampleRadially(mesh, VolumeCentroid(mesh), Frequency, {});
  if (sampling.Seen.HiddenPercent > settings.MaximumHiddenPercent)
  {
    return Status::Failure(
        "the mask is not star-shaped: " + FixedText(sampling.Seen.HiddenPercent, 1) +
        " % of its surface is hidden from its centre");
  }
  RadialModelFitOptions options;
  options.Degree = settings.Degree;
  RadialModelFitResult fit;
  const Status status = FitRadialModel(SamplesOf(sampling, RadialWeight::Area), options, fit);
  if (status.IsOk())
  {
    model = RadialModel(settings.Degree, fit.Coefficients, sampling.CenterWorld);
  }
  return status;
}

Status FitStar(const VoxelMask& mask, const IndexToWorld& toWorld,
               const MaskModelSettings& settings, const TopologyChange& leftOut, OrganModel& model,
               TopologyReport& changes)
{
  MaskSurfaceSettings surfaceSettings;
  surfaceSettings.Shape.CellsOnSurface = MaskSurfaceSettings::CellsOfModel;
  MaskSurface surface;
  const Status status = MakeMaskSurface(mask, toWorld, surfaceSettings, {}, surface);
  changes = surface.Changes();
  changes.Add(leftOut);
  const Status changed = CheckTopology(changes, {});
  if (!changed.IsOk() || !status.IsOk())
  {
    return OfMask(changed.IsOk() ? status : changed);
  }
  return FitRadii(surface.Mesh, settings, model);
}
} // namespace

Status FitMask(VoxelMask mask, const IndexToWorld& toWorld, const MaskModelSettings& settings,
               OrganModel& model, TopologyReport* changes)
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
  const bool takesInParts = smaller.Count > 0 && !settings.IsRadial;
  Status status = takesInParts ? FitSurface(mask, toWorld, settings.Degree, {}, model, made)
                               : Status::Failure({});
  if (!status.IsOk() && takesInParts && isTooMuch)
  {
    return status;
  }
  if (!status.IsOk())
  {
    parts.Keep(0, mask);
    status = settings.IsRadial ? FitStar(mask, toWorld, settings, smaller, model, made)
                               : FitSurface(mask, toWorld, settings.Degree, smaller, model, made);
  }
  if (changes != nullptr)
  {
    *changes = made;
  }
  return status;
}
} // namespace palpate
