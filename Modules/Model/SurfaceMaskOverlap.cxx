#include "SurfaceMaskOverlap.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// Indices of the voxels of a box.
struct Box
{
  std::array<int, 3> First{};
  std::array<int, 3> Size{};
};

using Bounds = Eigen::AlignedBox3d;

// In steps along the image's axes.
Bounds BoundsInIndices(const IndexedMesh& surface, const IndexToWorld& toWorld)
{
  const Matrix3 inverse = toWorld.Axes.inverse();
  Bounds bounds;
  for (const Vector3& point : surface.Points)
  {
    bounds.extend(Vector3(inverse * (point - toWorld.Origin)));
  }
  return bounds;
}

// The mask's box, extended to the surface unless that would take too many voxels.
Box BoxAround(Bounds bounds, const VoxelMask& label, double most)
{
  const Box own{label.StartIndex, label.Size};
  for (int axis = 0; axis < 3 && !label.Inside.empty(); ++axis)
  {
    const auto a = static_cast<std::size_t>(axis);
    bounds.min()[axis] = std::min<double>(bounds.min()[axis], own.First[a]);
    bounds.max()[axis] = std::max<double>(bounds.max()[axis], own.First[a] + own.Size[a] - 1.0);
  }
  const Vector3 first = bounds.min().array().floor();
  const Vector3 size = bounds.max().array().ceil() - first.array() + 1.0;
  if (!(size.prod() <= most) || first.cwiseAbs().maxCoeff() > 1e9)
  {
    return own;
  }
  Box box;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    box.First[axis] = static_cast<int>(first[static_cast<Eigen::Index>(axis)]);
    box.Size[axis] = static_cast<int>(size[static_cast<Eigen::Index>(axis)]);
  }
  return box;
}

bool Holds(const Box& box, const Bounds& bounds)
{
  const Vector3 first(box.First[0], box.First[1], box.First[2]);
  const Vector3 last = first + Vector3(box.Size[0] - 1, box.Size[1] - 1, box.Size[2] - 1);
  return Bounds(first, last).contains(bounds);
}

// From the volume.
std::int64_t EnclosedVoxels(const IndexedMesh& surface, double voxel)
{
  double volume = 0.0;
  const Vector3& origin = surface.Points.front();
  for (const std::array<int, 3>& t : surface.Triangles)
  {
    const Vector3 a = surface.Points[t[0]] - origin;
    volume += a.dot((surface.Points[t[1]] - origin).cross(surface.Points[t[2]] - origin)) / 6.0;
  }
  constexpr double Most = 1e18;
  return std::llround(std::min(std::abs(volume / voxel), Most));
}

// The label's voxels in another box.
std::vector<std::uint8_t> Spread(const VoxelMask& label, const Box& box)
{
  const std::array<int, 3>& size = box.Size;
  std::vector<std::uint8_t> spread(static_cast<std::size_t>(size[0]) * size[1] * size[2], 0);
  for (int k = 0; k < label.Size[2]; ++k)
  {
    for (int j = 0; j < label.Size[1]; ++j)
    {
      const int row = (label.StartIndex[2] + k - box.First[2]) * size[1] + label.StartIndex[1] + j -
                      box.First[1];
      std::copy_n(label.Inside.data() + label.Offset(0, j, k), label.Size[0],
                  spread.data() + static_cast<std::size_t>(row) * size[0] + label.StartIndex[0] -
                      box.First[0]);
    }
  }
  return spread;
}
} // namespace

WindingOverlap OverlapOfSurfaceAndMask(const IndexedMesh& surface, const VoxelMask& mask,
                                       const IndexToWorld& toWorld, double mostVoxels)
{
  WindingOverlap nothing;
  nothing.Mask = mask.Count();
  const bool isFinite = std::all_of(surface.Points.begin(), surface.Points.end(),
                                    [](const Vector3& point) { return point.allFinite(); });
  if (surface.Points.empty() || !isFinite)
  {
    return nothing;
  }
  const Bounds bounds = BoundsInIndices(surface, toWorld);
  const Box box = BoxAround(bounds, mask, mostVoxels);
  const VoxelCenters centers{toWorld(Vector3(box.First[0], box.First[1], box.First[2])),
                             toWorld.Axes, box.Size};
  std::vector<std::int16_t> numbers;
  if (!FindWindingNumbers(surface, centers, numbers).IsOk())
  {
    return nothing;
  }
  WindingOverlap overlap = CompareWithMask(numbers, Spread(mask, box).data());
  if (!Holds(box, bounds))
  {
    const double voxel = std::abs(toWorld.Axes.determinant());
    overlap.Inside = std::max(overlap.Inside, EnclosedVoxels(surface, voxel));
  }
  return overlap;
}
} // namespace palpate
