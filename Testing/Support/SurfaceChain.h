#pragma once

#include "GenusZeroSurface.h"
#include "MeshDecimation.h"
#include "SphericalParametrisation.h"
#include "SurfaceModelFit.h"
#include "SurfaceTessellation.h"
#include "WindingNumbers.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace palpate::test
{
/// A surface model of a mask by the steps of a fit, without images: topology, limits, decimation,
/// map to the sphere, fit. Points are mm along the mask's axes from the centre of its first voxel.
struct SurfaceChain
{
  GenusZeroSurface Surface;
  IndexedMesh Mesh;
  SphericalParametrisation Map;
  SurfaceModelFitResult Fit;
};

inline Status RunSurfaceChain(const VoxelMask& mask, int degree, SurfaceChain& chain,
                              int triangles = 5000, double spacing = 0.0)
{
  GenusZeroSettings settings;
  settings.Field.Spacing = spacing;
  Status status = MakeGenusZeroSurface(mask, settings, {}, chain.Surface);
  if (status.IsOk())
  {
    status = CheckTopology(chain.Surface.Topology, {});
  }
  DecimationSettings coarse;
  coarse.Triangles = triangles;
  if (status.IsOk())
  {
    const ShapeField& field = chain.Surface.Field;
    const auto outward = [&field](const Vector3& point) { return field.Outward(point); };
    status = DecimateMesh(chain.Surface.Mesh, coarse, outward, {}, chain.Mesh);
  }
  if (status.IsOk())
  {
    status = ParametriseOnSphere(chain.Mesh, {}, chain.Map);
  }
  if (status.IsOk())
  {
    status = CheckSphereMap(chain.Map.Quality);
  }
  SurfaceModelFitOptions options;
  options.Degree = degree;
  return status.IsOk() ? FitSurfaceModel(chain.Mesh, chain.Map.Directions, options, chain.Fit)
                       : status;
}

inline IndexedMesh Tessellated(const SurfaceModel& surface)
{
  return palpate::Tessellated(surface, IcosahedronDirections(40));
}

/// The voxels of a mask that a surface in its frame encloses, and how they agree.
inline WindingOverlap OverlapOf(const SurfaceModel& surface, const VoxelMask& mask)
{
  VoxelCenters centers;
  for (int axis = 0; axis < 3; ++axis)
  {
    centers.Axes(axis, axis) = mask.Spacing[static_cast<std::size_t>(axis)];
  }
  centers.Size = mask.Size;
  std::vector<std::int16_t> numbers;
  const Status status = FindWindingNumbers(Tessellated(surface), centers, numbers);
  return status.IsOk() ? CompareWithMask(numbers, mask.Inside.data()) : WindingOverlap{};
}

/// A mask and where the centre of its first voxel is.
struct PlacedMask
{
  VoxelMask Mask;
  Vector3 Origin = Vector3::Zero();
};

/// The voxels whose centres a closed mesh encloses, with a margin of one.
inline PlacedMask Voxelised(const IndexedMesh& mesh, const Vector3& spacing)
{
  Vector3 low = mesh.Points.front();
  Vector3 high = low;
  for (const Vector3& point : mesh.Points)
  {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  PlacedMask placed;
  placed.Origin = low - spacing;
  VoxelCenters centers;
  centers.Origin = placed.Origin;
  centers.Axes = spacing.asDiagonal();
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto at = static_cast<std::size_t>(axis);
    placed.Mask.Spacing[at] = spacing[axis];
    placed.Mask.Size[at] =
        static_cast<int>(std::ceil((high[axis] - low[axis]) / spacing[axis])) + 3;
  }
  centers.Size = placed.Mask.Size;
  std::vector<std::int16_t> numbers;
  const Status status = FindWindingNumbers(mesh, centers, numbers);
  placed.Mask.Inside.resize(numbers.size());
  std::transform(numbers.begin(), numbers.end(), placed.Mask.Inside.begin(),
                 [](std::int16_t number) -> unsigned char { return number > 0 ? 1 : 0; });
  return status.IsOk() ? placed : PlacedMask{};
}

/// The voxels whose index fulfils a condition.
template <typename Condition>
VoxelMask MaskWhere(const std::array<int, 3>& size, const std::array<double, 3>& spacing,
                    const Condition& isInside)
{
  VoxelMask mask;
  mask.Size = size;
  mask.Spacing = spacing;
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        mask.Inside.push_back(isInside(i, j, k) ? 1 : 0);
      }
    }
  }
  return mask;
}
} // namespace palpate::test
