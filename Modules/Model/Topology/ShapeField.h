#pragma once

#include "Status.h"
#include "Vector3.h"
#include "VoxelMask.h"

#include <array>
#include <cstddef>
#include <vector>

namespace palpate
{
/// Nodes at equal steps along a mask's axes. Points are in mm along these axes, from the centre of
/// the voxel 0, 0, 0 of the mask's box: voxel (i, j, k) of the box has its centre at
/// (i, j, k) * spacing, and the image index of a point is its coordinates / spacing + StartIndex.
struct ShapeGrid
{
  std::array<int, 3> Size{};       ///< nodes along i, j, k
  double Spacing = 0.0;            ///< mm, of all axes
  Vector3 Origin{Vector3::Zero()}; ///< node 0, 0, 0, in mm

  std::size_t NodeCount() const noexcept { return this->Offset(0, 0, this->Size[2]); }
  std::size_t Offset(int i, int j, int k) const noexcept
  {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(this->Size[1]) +
            static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(this->Size[0]) +
           static_cast<std::size_t>(i);
  }
  std::array<int, 3> Index(std::size_t offset) const noexcept
  {
    const auto i = static_cast<std::size_t>(this->Size[0]);
    const auto j = static_cast<std::size_t>(this->Size[1]);
    return {static_cast<int>(offset % i), static_cast<int>(offset / i % j),
            static_cast<int>(offset / (i * j))};
  }
  Vector3 Point(const std::array<int, 3>& index) const
  {
    return this->Origin + this->Spacing * Vector3(index[0], index[1], index[2]);
  }
  double CellVolume() const noexcept { return this->Spacing * this->Spacing * this->Spacing; }
};

/// A scalar (mm, positive inside) at the nodes of a grid; inside is > 0. Between nodes it is linear
/// in the tetrahedra of the Freudenthal triangulation (KuhnNeighborhood.h), so that its zero level
/// is what MarchingTetrahedra returns. All nodes of the grid's outermost layer are outside.
struct ShapeField
{
  ShapeGrid Grid;
  std::vector<float> Values; ///< i runs fastest

  /// The value at a point (mm, the grid's frame); beyond the grid that of the nearest border point.
  double Sample(const Vector3& point) const;
  /// Points outwards, where the field falls: central differences of it over one spacing.
  Vector3 Outward(const Vector3& point) const;
};

struct ShapeFieldSettings
{
  double Spacing = 0.0; ///< of the grid, mm; 0: ShapeFieldSpacing
  /// Surface area (mm^2) per square of the grid's spacing when that follows from the mask.
  double CellsOnSurface = 16000.0;
  /// Bound of distances within slices, in slice spacings. A larger one interpolates the shape
  /// between slices better (0.75 predicts left-out slices of glands best), a smaller one follows
  /// each slice's own outline more closely: of a zone as thin as a slice, 0.35 loses 0.8 % of Dice
  /// more.
  double SliceClamp = 0.2;
  /// Curved between slices (SliceInterpolation), as a body and bumps on it are. The clamp then
  /// holds where distances do not change smoothly from slice to slice.
  bool IsCurved = false;
  double Smoothing = 0.35;     ///< standard deviation of the Gaussian, in grid spacings
  double MaximumNodes = 8.0e6; ///< the grid is coarsened until it has no more

  /// For fits of radii: predicts the true shape between slices better than the default, which
  /// follows the slices; such fits agree with the mask as well as with that one.
  static ShapeFieldSettings OfStar()
  {
    ShapeFieldSettings settings;
    settings.SliceClamp = 0.75;
    settings.IsCurved = true;
    return settings;
  }
};

/// Makes a field whose zero level is the boundary of the mask's voxels, half way between centres.
///
/// If the slices are thick, that is one axis at least 1.5 times as coarse as each of the others:
/// signed distance in each slice, clamped to `SliceClamp` slice spacings and linear between slices,
/// or curved (SliceInterpolation). Otherwise signed distance in three dimensions. Both are
/// resampled to an isotropic grid (trilinear otherwise) and smoothed by a Gaussian. The volume is
/// not matched yet: LevelOfVolume does that.
///
/// The grid's spacing is rounded so that nodes lie on thick slices. Grid and bounds of the mask
/// have the same centre, so that the field of a mirrored mask is the mirrored field.
///
/// Fails for a mask with no voxel inside, with a spacing that is not positive, or whose size does
/// not match its voxels, and for settings out of range.
Status MakeShapeField(const VoxelMask& mask, const ShapeFieldSettings& settings, ShapeField& field);

/// The spacing (mm) of the grid that follows from a mask: sqrt(area / CellsOnSurface), with area =
/// 2/3 of that of the voxels' faces (exact for a sphere). For thin shapes it is less, a third of
/// the mean thickness 2 V / area, but with at most six times as many cells on the surface; then it
/// is increased until there are at most `MaximumNodes` nodes. So a mask that is too large or too
/// thin loses detail, it is not refused. 0 for an empty mask.
double ShapeFieldSpacing(const VoxelMask& mask, const ShapeFieldSettings& settings);
} // namespace palpate
