#include "MaskCorrection.h"

#include "MaskEdits.h"
#include "MaskSurface.h"
#include "MeshVoxels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
using VoxelIndex = std::array<int, 3>;

constexpr unsigned char Candidate = 2;

std::size_t OffsetIn(const VoxelMask& mask, const VoxelIndex& index)
{
  return mask.Offset(index[0] - mask.StartIndex[0], index[1] - mask.StartIndex[1],
                     index[2] - mask.StartIndex[2]);
}

// Calls `visit` with each voxel between two surfaces, and those next to it that both have on the
// side of the second; and whether that is inside.
template <typename Visit>
void ForEachSwept(const std::array<int, 3>& size, const std::vector<std::uint8_t>& old,
                  const std::vector<std::uint8_t>& now, const Visit& visit)
{
  const std::array<std::ptrdiff_t, 3> steps{1, size[0],
                                            static_cast<std::ptrdiff_t>(size[0]) * size[1]};
  const auto at = [](std::ptrdiff_t place) { return static_cast<std::size_t>(place); };
  std::ptrdiff_t place = 0;
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i, ++place)
      {
        const std::array<int, 3> index{i, j, k};
        bool isSwept = old[at(place)] != now[at(place)];
        for (std::size_t axis = 0; axis < 3 && !isSwept; ++axis)
        {
          const auto sweeps = [&](std::ptrdiff_t next)
          { return old[at(next)] != now[at(next)] && now[at(next)] == now[at(place)]; };
          isSwept = (index[axis] > 0 && sweeps(place - steps[axis])) ||
                    (index[axis] + 1 < size[axis] && sweeps(place + steps[axis]));
        }
        if (isSwept)
        {
          visit(i, j, k, now[at(place)] != 0);
        }
      }
    }
  }
}

// Turns candidates that hang together with the mask into voxels of it, and clears the others. The
// mask's box has a rim without voxels.
void JoinCandidates(VoxelMask& mask)
{
  const std::array<std::ptrdiff_t, 3> steps{1, mask.Size[0],
                                            static_cast<std::ptrdiff_t>(mask.Offset(0, 0, 1))};
  std::vector<std::ptrdiff_t> pending;
  const auto visit = [&](std::ptrdiff_t at, unsigned char wanted, const auto& found)
  {
    for (const std::ptrdiff_t step : steps)
    {
      for (const std::ptrdiff_t next : {at - step, at + step})
      {
        if (mask.Inside[static_cast<std::size_t>(next)] == wanted)
        {
          found(next);
        }
      }
    }
  };
  for (std::size_t at = 0; at < mask.Inside.size(); ++at)
  {
    bool isBeside = false;
    if (mask.Inside[at] == Candidate)
    {
      visit(static_cast<std::ptrdiff_t>(at), 1, [&](std::ptrdiff_t) { isBeside = true; });
    }
    if (isBeside)
    {
      pending.push_back(static_cast<std::ptrdiff_t>(at));
    }
  }
  for (const std::ptrdiff_t at : pending)
  {
    mask.Inside[static_cast<std::size_t>(at)] = 1;
  }
  while (!pending.empty())
  {
    const std::ptrdiff_t at = pending.back();
    pending.pop_back();
    visit(at, Candidate,
          [&](std::ptrdiff_t next)
          {
            mask.Inside[static_cast<std::size_t>(next)] = 1;
            pending.push_back(next);
          });
  }
  std::replace(mask.Inside.begin(), mask.Inside.end(), Candidate, static_cast<unsigned char>(0));
}
} // namespace

// Image indices, inclusive; first > last if nothing moves.
struct MaskCorrection::Box
{
  VoxelIndex First{1, 1, 1};
  VoxelIndex Last{0, 0, 0};

  bool IsEmpty() const { return this->First[0] > this->Last[0]; }
};

std::vector<Vector3> PointNormals(const IndexedMesh& mesh)
{
  std::vector<Vector3> normals(mesh.Points.size(), Vector3::Zero());
  for (const std::array<int, 3>& triangle : mesh.Triangles)
  {
    const Vector3 area = AreaVector(mesh, triangle);
    for (const int corner : triangle)
    {
      normals[static_cast<std::size_t>(corner)] += area;
    }
  }
  for (Vector3& normal : normals)
  {
    normal = normal.stableNormalized();
  }
  return normals;
}

Status MaskCorrection::Make(VoxelMask mask, const IndexToWorld& toWorld,
                            const std::array<int, 3>& imageSize, MaskCorrection& made)
{
  MaskSurfaceSettings settings;
  settings.Component = 0;
  settings.Shape.CellsOnSurface = MaskSurfaceSettings::CellsOfModel;
  MaskSurface surface;
  MaskCorrection correction;
  if (MakeMaskSurface(mask, toWorld, settings, {}, surface).IsOk())
  {
    correction.Mesh = std::move(surface.Mesh);
  }
  else if (const Status status = MakeMaskBoundary(mask, toWorld, correction.Mesh); !status.IsOk())
  {
    return status;
  }
  correction.Start = std::move(mask);
  correction.ToWorld = toWorld;
  correction.ImageSize = imageSize;
  correction.Outward = PointNormals(correction.Mesh);
  made = std::move(correction);
  return Status::Success();
}

// Around the triangles that differ.
MaskCorrection::Box MaskCorrection::BoxOf(const IndexedMesh& after) const
{
  const Matrix3 toIndex = this->ToWorld.Axes.inverse();
  Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity());
  Vector3 high = -low;
  const auto hasMoved = [&](int point)
  {
    const auto at = static_cast<std::size_t>(point);
    return after.Points[at] != this->Mesh.Points[at];
  };
  for (const std::array<int, 3>& triangle : this->Mesh.Triangles)
  {
    if (!std::any_of(triangle.begin(), triangle.end(), hasMoved))
    {
      continue;
    }
    for (const int corner : triangle)
    {
      for (const IndexedMesh* mesh : {&this->Mesh, &after})
      {
        const Vector3 index =
            toIndex * (mesh->Points[static_cast<std::size_t>(corner)] - this->ToWorld.Origin);
        low = low.cwiseMin(index);
        high = high.cwiseMax(index);
      }
    }
  }
  Box box;
  for (std::size_t axis = 0; axis < 3 && (low.array() <= high.array()).all(); ++axis)
  {
    const auto a = static_cast<Eigen::Index>(axis);
    const double end = this->ImageSize[axis] - 1.0;
    box.First[axis] = static_cast<int>(std::clamp(std::floor(low[a]) - 1.0, 0.0, end));
    box.Last[axis] = static_cast<int>(std::clamp(std::ceil(high[a]) + 1.0, 0.0, end));
  }
  return box;
}

void MaskCorrection::Change(const Box& box, const IndexedMesh& after, const Barrier& barrier,
                            VoxelMask& moved) const
{
  VoxelCenters grid{
      this->ToWorld(Vector3(box.First[0], box.First[1], box.First[2])), this->ToWorld.Axes, {}};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    grid.Size[axis] = box.Last[axis] - box.First[axis] + 1;
  }
  std::vector<std::uint8_t> old;
  std::vector<std::uint8_t> now;
  if (!FindInside(this->Mesh, grid, true, old).IsOk() || !FindInside(after, grid, true, now).IsOk())
  {
    return; // which finite points and a box in an image do not do
  }
  ForEachSwept(grid.Size, old, now,
               [&](int i, int j, int k, bool isInside)
               {
                 const VoxelIndex index{box.First[0] + i, box.First[1] + j, box.First[2] + k};
                 const bool was = HasVoxel(this->Start, index);
                 unsigned char& voxel = moved.Inside[OffsetIn(moved, index)];
                 if (was && !isInside)
                 {
                   voxel = 0;
                 }
                 else if (!was && isInside && !(barrier && barrier(index)))
                 {
                   voxel = Candidate;
                 }
               });
}

VoxelMask MaskCorrection::Moved(const Eigen::Matrix3Xd& displacements, const Barrier& barrier) const
{
  IndexedMesh after = this->Mesh;
  for (std::size_t n = 0; n < after.Points.size(); ++n)
  {
    const Vector3 by = displacements.col(static_cast<Eigen::Index>(n));
    if (by.norm() >= LeastDisplacement)
    {
      after.Points[n] += by;
    }
  }
  const Box box = this->BoxOf(after);
  VoxelIndex first = this->Start.StartIndex;
  VoxelIndex last{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    last[axis] = first[axis] + this->Start.Size[axis] - 1;
    if (!box.IsEmpty())
    {
      first[axis] = std::min(first[axis], box.First[axis] - 1);
      last[axis] = std::max(last[axis], box.Last[axis] + 1);
    }
  }
  VoxelMask moved = InBox(this->Start, first, last);
  if (!box.IsEmpty())
  {
    this->Change(box, after, barrier, moved);
    JoinCandidates(moved);
  }
  return moved;
}
} // namespace palpate
