#include "ScanBorder.h"

#include "SurfaceTopology.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr int Reach = 2; // voxels

class CutSearch
{
public:
  CutSearch(const PlacedMask& mask, const std::array<int, 3>& size)
      : Mask(mask), Size(size), ToIndex(mask.ToWorld.Axes.inverse()),
        Steps(mask.ToWorld.Axes.colwise().norm())
  {
  }

  bool IsCutAt(const Vector3& world) const
  {
    const Vector3 index = this->ToIndex * (world - this->Mask.ToWorld.Origin);
    for (int axis = 0; axis < 3; ++axis)
    {
      const int last = this->Size[static_cast<std::size_t>(axis)] - 1;
      for (const int layer : {0, last})
      {
        const double depth = (layer == 0 ? index[axis] + 0.5 : last + 0.5 - index[axis]);
        if (depth <= Reach && depth * this->Steps[axis] < this->EdgeFrom(index, axis, layer))
        {
          return true;
        }
      }
    }
    return false;
  }

private:
  bool IsOutside(std::array<int, 3> voxel) const
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      // Beyond the image, the mask goes on.
      voxel[axis] = std::clamp(voxel[axis], 0, this->Size[axis] - 1);
      voxel[axis] -= this->Mask.Voxels.StartIndex[axis];
      if (voxel[axis] < 0 || voxel[axis] >= this->Mask.Voxels.Size[axis])
      {
        return true;
      }
    }
    const auto [i, j, k] = voxel;
    const std::array<int, 3>& box = this->Mask.Voxels.Size;
    const std::size_t row = static_cast<std::size_t>(k) * box[1] + static_cast<std::size_t>(j);
    return this->Mask.Voxels.Inside[row * box[0] + static_cast<std::size_t>(i)] == 0;
  }

  // The distance (mm) within a layer to the nearest voxel outside the mask; infinite beyond the
  // reach.
  double EdgeFrom(const Vector3& index, int axis, int layer) const
  {
    const int one = (axis + 1) % 3;
    const int other = (axis + 2) % 3;
    double least = std::numeric_limits<double>::infinity();
    for (int n = -Reach; n <= Reach; ++n)
    {
      for (int m = -Reach; m <= Reach; ++m)
      {
        std::array<int, 3> voxel{};
        voxel[static_cast<std::size_t>(axis)] = layer;
        const int a = static_cast<int>(std::lround(index[one])) + n;
        const int b = static_cast<int>(std::lround(index[other])) + m;
        voxel[static_cast<std::size_t>(one)] = a;
        voxel[static_cast<std::size_t>(other)] = b;
        if (this->IsOutside(voxel))
        {
          least = std::min(least, std::hypot(this->Gap(index[one] - a, one),
                                             this->Gap(index[other] - b, other)));
        }
      }
    }
    return least;
  }

  // From a voxel's face, mm.
  double Gap(double offset, int axis) const
  {
    return std::max(0.0, std::abs(offset) - 0.5) * this->Steps[axis];
  }

  const PlacedMask& Mask;
  std::array<int, 3> Size;
  Matrix3 ToIndex;
  Vector3 Steps; // mm
};
} // namespace

IndexedMesh WithoutCut(const IndexedMesh& surface, const PlacedMask& mask,
                       const std::array<int, 3>& size)
{
  const CutSearch cut(mask, size);
  IndexedMesh rest;
  rest.Points = surface.Points;
  for (const std::array<int, 3>& t : surface.Triangles)
  {
    const Vector3 sum = surface.Points[t[0]] + surface.Points[t[1]] + surface.Points[t[2]];
    if (!cut.IsCutAt(sum / 3.0))
    {
      rest.Triangles.push_back(t);
    }
  }
  return rest;
}

double CutAreaOf(const IndexedMesh& surface, const PlacedMask& mask, const std::array<int, 3>& size)
{
  return MeasureEnclosed(surface).Area - MeasureEnclosed(WithoutCut(surface, mask, size)).Area;
}
} // namespace palpate
