#include "MaskModel.h"

#include "DecimalText.h"
#include "MappedSurface.h"
#include "MaskComponents.h"
#include "ParametricFit.h"
#include "RadialSampling.h"
#include "SphericalHarmonicFit.h"
#include "StarShape.h"

#include <cctype>
#include <string>

namespace palpate
{
namespace
{
constexpr int Frequency = 20; // 4,002 directions

// Messages of the surface's kernels are sentences, or begin with what the structure has or is.
Status OfMask(const Status& status)
{
  const std::string& message = status.Message();
  return !message.empty() && std::islower(static_cast<unsigned char>(message.front())) != 0
             ? Status::Failure("the mask's largest part " + message)
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
    return Status::Failure("the mask's largest part is not star-shaped: " + FixedText(hidden, 1) +
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

Status FitStar(const VoxelMask& mask, const IndexToWorld& toWorld,
               const MaskModelSettings& settings, SurfaceModel& model)
{
  GenusZeroSurface surface;
  const Status status = MakeGenusZeroSurface(mask, {}, {}, surface);
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
  MaskComponents(mask).Keep(0, mask);
  return settings.IsStarShaped ? FitStar(mask, toWorld, settings, model)
                               : FitParametric(mask, toWorld, settings.Degree, model);
}
} // namespace palpate
