#include "MaskCorrection.h"

#include "MaskEdits.h"
#include "MaskSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
using VoxelIndex = std::array<int, 3>;

constexpr unsigned char Candidate = 2;

Vector3 VectorOfIndex(const VoxelIndex& index)
{
  return {static_cast<double>(index[0]), static_cast<double>(index[1]),
          static_cast<double>(index[2])};
}

// Shares of a triangle's corners in a point on it, by areas; equal ones if it has no area.
Vector3 SharesOf(const Vector3& point, const Vector3& a, const Vector3& b, const Vector3& c)
{
  const Vector3 areas((b - point).cross(c - point).norm(), (c - point).cross(a - point).norm(),
                      (a - point).cross(b - point).norm());
  const double sum = areas.sum();
  return sum > 0.0 ? Vector3(areas / sum) : Vector3::Constant(1.0 / 3.0);
}

std::size_t OffsetIn(const VoxelMask& mask, const VoxelIndex& index)
{
  return mask.Offset(index[0] - mask.StartIndex[0], index[1] - mask.StartIndex[1],
                     index[2] - mask.StartIndex[2]);
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
  double Inwards = 0.0; // the least displacement
  double Outwards = 0.0;
};

std::vector<Vector3> PointNormals(const IndexedMesh& mesh)
{
  std::vector<Vector3> normals(mesh.Points.size(), Vector3::Zero());
  const auto at = [](int point) { return static_cast<std::size_t>(point); };
  for (const std::array<int, 3>& triangle : mesh.Triangles)
  {
    const Vector3& a = mesh.Points[at(triangle[0])];
    const Vector3 area = (mesh.Points[at(triangle[1])] - a).cross(mesh.Points[at(triangle[2])] - a);
    for (const int corner : triangle)
    {
      normals[at(corner)] += area;
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
  Status status = NearestOnMesh::Make(correction.Mesh, correction.Nearest);
  if (status.IsOk())
  {
    made = std::move(correction);
  }
  return status;
}

MaskCorrection::Box MaskCorrection::BoxOf(const Eigen::VectorXd& displacements) const
{
  const Matrix3 toIndex = this->ToWorld.Axes.inverse();
  Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity());
  Vector3 high = -low;
  Box box;
  for (std::size_t n = 0; n < this->Mesh.Points.size(); ++n)
  {
    const double moved = displacements[static_cast<Eigen::Index>(n)];
    if (std::abs(moved) < LeastDisplacement)
    {
      continue;
    }
    const Vector3 index = toIndex * (this->Mesh.Points[n] - this->ToWorld.Origin);
    low = low.cwiseMin(index);
    high = high.cwiseMax(index);
    box.Inwards = std::min(box.Inwards, moved);
    box.Outwards = std::max(box.Outwards, moved);
  }
  const double most = std::max(-box.Inwards, box.Outwards);
  for (std::size_t axis = 0; axis < 3 && most > 0.0; ++axis)
  {
    const double margin = most / this->Start.Spacing[axis] + 1.0;
    const auto a = static_cast<Eigen::Index>(axis);
    const double end = this->ImageSize[axis] - 1.0;
    box.First[axis] = static_cast<int>(std::clamp(std::floor(low[a] - margin), 0.0, end));
    box.Last[axis] = static_cast<int>(std::clamp(std::ceil(high[a] + margin), 0.0, end));
  }
  return box;
}

double MaskCorrection::SignedDistance(const NearestOnMesh::Result& nearest, const Vector3& point,
                                      const Eigen::VectorXd& displacements,
                                      double& moved) const noexcept
{
  const std::array<int, 3>& corners =
      this->Mesh.Triangles[static_cast<std::size_t>(nearest.Triangle)];
  const auto at = [&](std::size_t corner) { return static_cast<std::size_t>(corners[corner]); };
  const Vector3 shares = SharesOf(nearest.Point, this->Mesh.Points[at(0)], this->Mesh.Points[at(1)],
                                  this->Mesh.Points[at(2)]);
  Vector3 normal = Vector3::Zero();
  moved = 0.0;
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    const double share = shares[static_cast<Eigen::Index>(corner)];
    normal += share * this->Outward[at(corner)];
    moved += share * displacements[corners[corner]];
  }
  const bool isOutside = (point - nearest.Point).dot(normal) > 0.0;
  return isOutside ? nearest.Distance : -nearest.Distance;
}

void MaskCorrection::MoveSlice(int k, const Box& box, const Eigen::VectorXd& displacements,
                               const Barrier& barrier, VoxelMask& moved) const
{
  std::vector<VoxelIndex> indices;
  std::vector<Vector3> points;
  for (int j = box.First[1]; j <= box.Last[1]; ++j)
  {
    for (int i = box.First[0]; i <= box.Last[0]; ++i)
    {
      if (HasVoxel(this->Start, {i, j, k}) ? box.Inwards < 0.0 : box.Outwards > 0.0)
      {
        indices.push_back({i, j, k});
        points.push_back(this->ToWorld(VectorOfIndex(indices.back())));
      }
    }
  }
  const std::vector<NearestOnMesh::Result> nearest = this->Nearest.FindAll(points);
  // The surface passes between voxels inside and outside: elsewhere it is another part's, a
  // cavity's, or none's.
  const double slack = *std::max_element(moved.Spacing.begin(), moved.Spacing.end());
  for (std::size_t n = 0; n < indices.size(); ++n)
  {
    double by = 0.0;
    const double distance = this->SignedDistance(nearest[n], points[n], displacements, by);
    const std::size_t at = OffsetIn(moved, indices[n]);
    if (HasVoxel(this->Start, indices[n]))
    {
      const bool isLeft = by <= -LeastDisplacement && distance >= by && distance < slack;
      moved.Inside[at] = isLeft ? 0 : 1;
    }
    else if (by >= LeastDisplacement && distance < by && distance > -slack &&
             !(barrier && barrier(indices[n])))
    {
      moved.Inside[at] = Candidate;
    }
  }
}

VoxelMask MaskCorrection::Moved(const Eigen::VectorXd& displacements, const Barrier& barrier) const
{
  const Box box = this->BoxOf(displacements);
  VoxelIndex first = this->Start.StartIndex;
  VoxelIndex last{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    last[axis] = first[axis] + this->Start.Size[axis] - 1;
    if (box.First[0] <= box.Last[0])
    {
      first[axis] = std::min(first[axis], box.First[axis] - 1);
      last[axis] = std::max(last[axis], box.Last[axis] + 1);
    }
  }
  VoxelMask moved = InBox(this->Start, first, last);
  for (int k = box.First[2]; k <= box.Last[2]; ++k)
  {
    this->MoveSlice(k, box, displacements, barrier, moved);
  }
  if (box.Outwards > 0.0)
  {
    JoinCandidates(moved);
  }
  return moved;
}
} // namespace palpate
