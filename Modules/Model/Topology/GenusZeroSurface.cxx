#include "GenusZeroSurface.h"

#include "FieldVolume.h"
#include "MarchingTetrahedra.h"
#include "MaskSpecks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <utility>

namespace palpate
{
namespace
{
// Values next to zero would put vertices next to nodes, and many of them close together.
constexpr float LeastDepth = 0.02f; // in spacings

class GenusZeroMaker
{
public:
  GenusZeroMaker(const VoxelMask& mask, const GenusZeroSettings& settings,
                 const KernelProgress& progress, GenusZeroSurface& surface)
      : Mask(mask), Settings(settings), Progress(&progress), Surface(&surface)
  {
  }

  Status Run()
  {
    this->Surface->MaskVolume = this->VolumeOfMask();
    this->Specks = DropSpecks(this->Settings.Topology.SmallPart, this->Mask);
    Status status = MakeShapeField(this->Mask, this->Settings.Field, this->Surface->Field);
    if (!status.IsOk())
    {
      return status;
    }
    if (!this->Report(0.3))
    {
      return Status::Failure("Cancelled.");
    }
    this->MatchVolume();
    status = this->CheckVolume();
    if (!status.IsOk())
    {
      return status;
    }
    ShapeField matched = this->Surface->Field;
    status = this->RepairAndMarch(0.4, 0.6);
    if (!status.IsOk())
    {
      return status;
    }
    if (this->Settings.RestoreThinParts && !this->Surface->Lost.empty())
    {
      status = this->Restore(std::move(matched));
    }
    return !status.IsOk() || this->Report(1.0) ? status : Status::Failure("Cancelled.");
  }

private:
  bool Report(double fraction) const { return !*this->Progress || (*this->Progress)(fraction); }

  double VolumeOfMask() const
  {
    return static_cast<double>(this->Mask.Count()) * this->Mask.VoxelVolume();
  }

  void MatchVolume()
  {
    ShapeField& field = this->Surface->Field;
    const double spacing = field.Grid.Spacing;
    const double area = this->Settings.Field.CellsOnSurface * spacing * spacing;
    const float level = LevelOfVolume(field, this->VolumeOfMask(), area);
    const float least = LeastDepth * static_cast<float>(spacing);
    for (float& value : field.Values)
    {
      const float shifted = value - level;
      value = shifted > 0.0f ? std::max(shifted, least) : std::min(shifted, -least);
    }
    this->CloseBorder(-least);
  }

  // Where pores and walls are finer than the field, no level has the mask's volume.
  Status CheckVolume() const
  {
    const double volume = VolumeAbove(this->Surface->Field, 0.0f);
    if (this->IsNearMask(volume))
    {
      return Status::Success();
    }
    char text[160];
    std::snprintf(text, sizeof(text),
                  "has pores or walls that are too fine for a surface, which would enclose %.3g "
                  "instead of %.3g mm\xC2\xB3",
                  volume, this->VolumeOfMask());
    return Status::Failure(text);
  }
  bool IsNearMask(double volume) const
  {
    constexpr double LargestChange = 0.1;
    return std::abs(volume / this->VolumeOfMask() - 1.0) <= LargestChange;
  }

  // The level may be below that of the border where the grid is too coarse for the object.
  void CloseBorder(float outside)
  {
    ShapeField& field = this->Surface->Field;
    const std::array<int, 3>& size = field.Grid.Size;
    for (int k = 0; k < size[2]; ++k)
    {
      for (int j = 0; j < size[1]; ++j)
      {
        const bool isFace = k == 0 || j == 0 || k + 1 == size[2] || j + 1 == size[1];
        for (int i = 0; i < size[0]; i += isFace ? 1 : size[0] - 1)
        {
          float& value = field.Values[field.Grid.Offset(i, j, k)];
          value = std::min(value, outside);
        }
      }
    }
  }

  Status RepairAndMarch(double repaired, double marched)
  {
    GenusZeroSurface& surface = *this->Surface;
    Status status = RepairTopology(surface.Field, this->Settings.Topology, surface.Topology);
    if (!status.IsOk())
    {
      return status;
    }
    surface.Topology.Add(this->Specks);
    if (!this->Report(repaired))
    {
      return Status::Failure("Cancelled.");
    }
    status = MarchTetrahedra(surface.Field, surface.Mesh);
    if (!status.IsOk())
    {
      return status;
    }
    const double tolerance = this->Settings.LostTolerance > 0.0
                                 ? this->Settings.LostTolerance
                                 : LostVoxelTolerance(this->Mask, surface.Field.Grid);
    surface.Lost = FindLostVoxels(this->Mask, surface.Field, surface.Mesh, tolerance);
    return this->Report(marched) ? Status::Success() : Status::Failure("Cancelled.");
  }

  Status Restore(ShapeField matched)
  {
    GenusZeroSurface& surface = *this->Surface;
    const std::size_t nodes = RestoreVoxels(this->Mask, surface.Lost, surface.Field, matched);
    // Voxels of a sponge stand for themselves, not for thin parts.
    if (nodes == 0 || !this->IsNearMask(VolumeAbove(matched, 0.0f)))
    {
      return Status::Success();
    }
    surface.RestoredVolume = static_cast<double>(nodes) * matched.Grid.CellVolume();
    surface.Field = std::move(matched);
    return this->RepairAndMarch(0.8, 0.9);
  }

  VoxelMask Mask;
  TopologyChange Specks;
  GenusZeroSettings Settings;
  const KernelProgress* Progress;
  GenusZeroSurface* Surface;
};
} // namespace

Status MakeGenusZeroSurface(const VoxelMask& mask, const GenusZeroSettings& settings,
                            const KernelProgress& progress, GenusZeroSurface& surface)
{
  surface = {};
  return GenusZeroMaker(mask, settings, progress, surface).Run();
}
} // namespace palpate
