#include "MaskSurface.h"

#include "FieldVolume.h"
#include "MappedSurface.h"
#include "MarchingCubes.h"
#include "MaskComponents.h"
#include "MeshMending.h"
#include "SurfaceTopology.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace palpate
{
namespace
{
constexpr const char* TooLarge = "has too many voxels at its boundary";

// In mm along the mask's axes, as MoveToWorld expects it.
bool MarchMask(const VoxelMask& mask, IndexedMesh& mesh)
{
  SampledGrid grid;
  grid.Size = mask.Size;
  grid.Row = [&mask](int j, int k, float* row)
  {
    const unsigned char* voxels = &mask.Inside[mask.Offset(0, j, k)];
    std::transform(voxels, voxels + mask.Size[0], row,
                   [](unsigned char inside) { return inside != 0 ? 1.0F : 0.0F; });
  };
  const bool isMade = MarchCubes(grid, 0.5F, mesh);
  const Vector3 spacing(mask.Spacing.data());
  for (Vector3& point : mesh.Points)
  {
    point = point.cwiseProduct(spacing);
  }
  return isMade;
}

bool MarchShape(const ShapeField& field, double level, IndexedMesh& mesh)
{
  SampledGrid grid;
  grid.Size = field.Grid.Size;
  grid.Beyond = field.Values.front();
  grid.Row = [&field](int j, int k, float* row)
  { std::copy_n(&field.Values[field.Grid.Offset(0, j, k)], field.Grid.Size[0], row); };
  const bool isMade = MarchCubes(grid, static_cast<float>(level), mesh);
  for (Vector3& point : mesh.Points)
  {
    point = field.Grid.Origin + field.Grid.Spacing * point;
  }
  return isMade;
}

class SurfaceMaker
{
public:
  SurfaceMaker(VoxelMask& mask, const MaskSurfaceSettings& settings, const KernelProgress& progress,
               MaskSurface& surface)
      : Mask(mask), Settings(settings), Progress(progress), Made(surface)
  {
  }

  Status Run()
  {
    Status status = this->SelectComponent();
    if (!status.IsOk() || !this->Report(0.2))
    {
      return status.IsOk() ? Status::Failure("Cancelled.") : status;
    }
    status = this->Settings.IsPlain ? this->MarchPlain() : this->MarchShapeOfVolume();
    if (status.IsOk() && this->Made.Mesh.Triangles.empty())
    {
      return Status::Failure("is too thin to have a surface");
    }
    return !status.IsOk() || this->Report(0.9) ? status : Status::Failure("Cancelled.");
  }

private:
  bool Report(double fraction) const { return !this->Progress || this->Progress(fraction); }

  Status SelectComponent()
  {
    const MaskComponents components(this->Mask);
    const double voxel = this->Mask.VoxelVolume();
    for (const long long count : components.VoxelCounts())
    {
      this->Made.ComponentVolumes.push_back(static_cast<double>(count) * voxel);
    }
    const int count = static_cast<int>(this->Made.ComponentVolumes.size());
    if (count == 0)
    {
      return Status::Failure("has no voxels");
    }
    if (this->Settings.Component > count)
    {
      return Status::Failure("has " + std::to_string(count) + " connected component" +
                             (count == 1 ? "" : "s") + ": there is no component " +
                             std::to_string(this->Settings.Component));
    }
    if (this->Settings.Component > 0)
    {
      components.Keep(this->Settings.Component - 1, this->Mask);
    }
    this->Made.MaskVolume = static_cast<double>(this->Mask.Count()) * voxel;
    const MaskCavities cavities = FillCavities(this->Mask);
    this->Made.FilledCavities.Count = cavities.Count;
    this->Made.FilledCavities.Volume = static_cast<double>(cavities.Voxels) * voxel;
    this->Made.FilledCavities.LargestVolume = static_cast<double>(cavities.LargestVoxels) * voxel;
    return Status::Success();
  }

  Status MarchPlain()
  {
    const bool isMade = MarchMask(this->Mask, this->Made.Mesh);
    this->Measure();
    return isMade ? Status::Success() : Status::Failure(TooLarge);
  }

  Status MarchShapeOfVolume()
  {
    ShapeField field;
    const double volume = this->Made.MaskVolume + this->Made.FilledCavities.Volume;
    if (Status made = MakeMaskShape(this->Mask, volume, this->Settings.Shape, field); !made.IsOk())
    {
      return made;
    }
    if (!this->Report(0.6))
    {
      return Status::Failure("Cancelled.");
    }
    const auto [lowest, highest] = std::minmax_element(field.Values.begin(), field.Values.end());
    LevelSearch search;
    search.Lowest = *lowest;
    search.Highest = *highest;
    search.Volume = volume;
    search.Area = std::cbrt(36.0 * M_PI * volume * volume); // of a sphere
    search.Tolerance = 1e-3;
    search.MaximumSteps = 12;
    bool isMade = true;
    double marched = 0.0;
    const auto march = [&](double level)
    {
      marched = level;
      isMade = isMade && MarchShape(field, level, this->Made.Mesh);
      this->Measure();
      return isMade ? this->Made.SurfaceVolume : volume; // ends the search
    };
    if (const double level = FindLevel(search, march); level != marched)
    {
      march(level);
    }
    return isMade ? Status::Success() : Status::Failure(TooLarge);
  }

  // Of one component, smoothing may part a thin shape into pieces.
  void Measure()
  {
    if (this->Settings.Component > 0 && KeepPart(this->Made.Mesh, 1) > 0)
    {
      DropUnusedPoints(this->Made.Mesh);
    }
    this->Made.SurfaceVolume = MeasureEnclosed(this->Made.Mesh).Volume;
  }

  VoxelMask& Mask;
  const MaskSurfaceSettings& Settings;
  const KernelProgress& Progress;
  MaskSurface& Made;
};
} // namespace

TopologyReport MaskSurface::Changes() const
{
  TopologyReport report;
  report.ObjectVolume = this->MaskVolume;
  report.FilledCavities = this->FilledCavities;
  return report;
}

Status MakeMaskSurface(VoxelMask mask, const IndexToWorld& toWorld,
                       const MaskSurfaceSettings& settings, const KernelProgress& progress,
                       MaskSurface& surface)
{
  surface = {};
  Status status = SurfaceMaker(mask, settings, progress, surface).Run();
  if (status.IsOk())
  {
    MoveToWorld(mask, toWorld, surface.Mesh);
  }
  return status;
}

Status MakeMaskBoundary(const VoxelMask& mask, const IndexToWorld& toWorld, IndexedMesh& boundary)
{
  if (mask.Count() == 0)
  {
    return Status::Failure("has no voxels");
  }
  IndexedMesh mesh;
  if (!MarchMask(mask, mesh))
  {
    return Status::Failure(TooLarge);
  }
  MoveToWorld(mask, toWorld, mesh);
  boundary = std::move(mesh);
  return Status::Success();
}
} // namespace palpate
