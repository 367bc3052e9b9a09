#include "BodyOverlap.h"

#include "MeshDistances.h"
#include "MeshVoxels.h"
#include "SurfaceMaskOverlap.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace palpate
{
namespace
{
constexpr double WantedCubes = 4.0e6;
constexpr double RelativeCoincidence = 1e-9; // rounding of distances is below
constexpr double MostMaskVoxels = 6.4e7;     // as winding numbers of two bytes each

using Index = Eigen::Vector3i;

// Between the voxel indices of two images on one lattice.
struct LatticeMap
{
  bool IsOne = false;
  Eigen::Matrix3i Axes = Eigen::Matrix3i::Identity();
  Index Offset = Index::Zero();
};

// From indices of `from` to those of `to`, if all of these are whole to a hundredth of a voxel.
LatticeMap MapBetween(const PlacedMask& from, const PlacedMask& to)
{
  constexpr double Tolerance = 0.01;
  constexpr double FarthestIndex = 1e8;
  const Matrix3 inverse = to.ToWorld.Axes.inverse();
  const Matrix3 axes = inverse * from.ToWorld.Axes;
  const Vector3 offset = inverse * (from.ToWorld.Origin - to.ToWorld.Origin);
  LatticeMap map;
  if (!axes.allFinite() || !(offset.cwiseAbs().maxCoeff() < FarthestIndex))
  {
    return map;
  }
  const Matrix3 whole = axes.array().round();
  const Vector3 wholeOffset = offset.array().round();
  double farthest = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    farthest = std::max<double>(farthest, from.Voxels.StartIndex[axis] + from.Voxels.Size[axis]);
  }
  map.IsOne = std::abs(std::abs(whole.determinant()) - 1.0) < 1e-9 &&
              farthest * (axes - whole).cwiseAbs().maxCoeff() < Tolerance &&
              (offset - wholeOffset).cwiseAbs().maxCoeff() < Tolerance;
  map.Axes = whole.cast<int>();
  map.Offset = wholeOffset.cast<int>();
  return map;
}

bool HasVoxel(const VoxelMask& mask, const Index& index)
{
  const Index at = index - Index(mask.StartIndex[0], mask.StartIndex[1], mask.StartIndex[2]);
  const bool isInBox =
      at.minCoeff() >= 0 && at[0] < mask.Size[0] && at[1] < mask.Size[1] && at[2] < mask.Size[2];
  return isInBox && mask.Inside[mask.Offset(at[0], at[1], at[2])] != 0;
}

template <typename Visit>
void ForEachVoxel(const VoxelMask& mask, const Visit& visit)
{
  const unsigned char* inside = mask.Inside.data();
  for (int k = 0; k < mask.Size[2]; ++k)
  {
    for (int j = 0; j < mask.Size[1]; ++j)
    {
      for (int i = 0; i < mask.Size[0]; ++i, ++inside)
      {
        if (*inside != 0)
        {
          visit(Index(i + mask.StartIndex[0], j + mask.StartIndex[1], k + mask.StartIndex[2]));
        }
      }
    }
  }
}

BodyOverlap OfVoxels(const PlacedMask& one, const PlacedMask& other, const LatticeMap& map)
{
  BodyOverlap overlap;
  overlap.Kind = BodyOverlap::Cells::Voxels;
  overlap.Spacing = one.ToWorld.Axes.colwise().norm();
  overlap.One = one.Voxels.Count();
  overlap.Other = other.Voxels.Count();
  ForEachVoxel(one.Voxels, [&](const Index& index)
               { overlap.Both += HasVoxel(other.Voxels, map.Axes * index + map.Offset) ? 1 : 0; });
  return overlap;
}

BodyOverlap OfMaskVoxels(const ComparedBody& surface, const PlacedMask& mask)
{
  const double most =
      std::max(MostMaskVoxels, 2.0 * static_cast<double>(mask.Voxels.Inside.size()));
  const WindingOverlap found =
      OverlapOfSurfaceAndMask(surface.Enclosure(), mask.Voxels, mask.ToWorld, most);
  BodyOverlap overlap;
  overlap.Kind = BodyOverlap::Cells::MaskVoxels;
  overlap.Spacing = mask.ToWorld.Axes.colwise().norm();
  overlap.One = found.Inside;
  overlap.Other = found.Mask;
  overlap.Both = found.Both;
  return overlap;
}

// 1 for the cubes that a body has.
Status FillCubes(const ComparedBody& body, const VoxelCenters& cubes,
                 std::vector<std::uint8_t>& inside)
{
  const PlacedMask* mask = body.Mask();
  if (mask == nullptr)
  {
    return FindInside(body.Enclosure(), cubes, body.IsConsistent(), inside);
  }
  const Matrix3 inverse = mask->ToWorld.Axes.inverse();
  const Matrix3 steps = inverse * cubes.Axes;
  const Vector3 start = inverse * (cubes.Origin - mask->ToWorld.Origin);
  inside.clear();
  inside.reserve(static_cast<std::size_t>(cubes.Size[0]) * cubes.Size[1] * cubes.Size[2]);
  for (int k = 0; k < cubes.Size[2]; ++k)
  {
    for (int j = 0; j < cubes.Size[1]; ++j)
    {
      for (int i = 0; i < cubes.Size[0]; ++i)
      {
        const Vector3 index = (start + steps * Vector3(i, j, k)).array().round();
        inside.push_back(HasVoxel(mask->Voxels, index.cast<int>()) ? 1 : 0);
      }
    }
  }
  return Status::Success();
}

// Turned away from the world's axes: faces of boxes and of voxels, which follow the axes, would lie
// between two layers of cubes everywhere, and errors would not cancel.
VoxelCenters ObliqueCubesAround(const IndexedMesh& one, const IndexedMesh& other)
{
  const Matrix3 turn =
      (Eigen::AngleAxisd(0.61, Vector3::UnitZ()) * Eigen::AngleAxisd(0.43, Vector3::UnitX()) *
       Eigen::AngleAxisd(0.29, Vector3::UnitY()))
          .toRotationMatrix();
  IndexedMesh turned;
  turned.Points.reserve(one.Points.size() + other.Points.size());
  for (const IndexedMesh* mesh : {&one, &other})
  {
    for (const Vector3& point : mesh->Points)
    {
      turned.Points.emplace_back(turn.transpose() * point);
    }
  }
  VoxelCenters cubes = CubesAround(turned, WantedCubes);
  cubes.Origin = turn * cubes.Origin;
  cubes.Axes = turn * cubes.Axes;
  return cubes;
}

Status OfCubes(const ComparedBody& one, const ComparedBody& other, BodyOverlap& overlap)
{
  const VoxelCenters cubes = ObliqueCubesAround(one.Enclosure(), other.Enclosure());
  std::vector<std::uint8_t> first;
  std::vector<std::uint8_t> second;
  if (Status status = FillCubes(one, cubes, first); !status.IsOk())
  {
    return status;
  }
  if (Status status = FillCubes(other, cubes, second); !status.IsOk())
  {
    return status;
  }
  BodyOverlap found;
  found.Spacing = cubes.Axes.colwise().norm();
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    found.One += first[i];
    found.Other += second[i];
    found.Both += first[i] & second[i];
  }
  overlap = found;
  return Status::Success();
}
} // namespace

BodyOverlap BodyOverlap::OfModels(const ComparedBody& one, const std::vector<double>& there,
                                  const ComparedBody& other, const std::vector<double>& back)
{
  const double coincident = RelativeCoincidence * std::cbrt(one.Volume() + other.Volume());
  const Vector3 from = 0.5 * (one.Centroid() + other.Centroid());
  const auto part = [&](const ComparedBody& body, const std::vector<double>& distances)
  {
    const IndexedMesh coarse = body.CoarseSurface();
    // The error of flat triangles is that of their sides' square: extrapolated to none.
    const auto within = [&](double limit)
    {
      return (4.0 * VolumeWithin(body.Surface(), from, distances, limit) -
              VolumeWithin(coarse, from, distances, limit)) /
             3.0;
    };
    const double whole = within(std::numeric_limits<double>::infinity());
    return body.Volume() / whole * 0.5 * (within(-coincident) + within(coincident));
  };
  BodyOverlap overlap;
  overlap.Kind = Cells::None;
  overlap.One = one.Volume();
  overlap.Other = other.Volume();
  overlap.Both =
      std::clamp(part(one, there) + part(other, back), 0.0, std::min(overlap.One, overlap.Other));
  return overlap;
}

BodyOverlap BodyOverlap::OfDice(double dice)
{
  BodyOverlap overlap;
  overlap.One = 1.0;
  overlap.Other = 1.0;
  overlap.Both = dice;
  return overlap;
}

double BodyOverlap::Dice() const noexcept
{
  const double sum = this->One + this->Other;
  return sum > 0.0 ? 2.0 * this->Both / sum : 0.0;
}

double BodyOverlap::Jaccard() const noexcept
{
  const double united = this->One + this->Other - this->Both;
  return united > 0.0 ? this->Both / united : 0.0;
}

Status FindBodyOverlap(const ComparedBody& one, const ComparedBody& other, BodyOverlap& overlap)
{
  if (!one.IsClosed() || !other.IsClosed())
  {
    return Status::Failure("an open surface has no inside");
  }
  if (one.Mask() != nullptr && other.Mask() != nullptr)
  {
    const LatticeMap map = MapBetween(*one.Mask(), *other.Mask());
    if (map.IsOne)
    {
      overlap = OfVoxels(*one.Mask(), *other.Mask(), map);
      return Status::Success();
    }
    return OfCubes(one, other, overlap);
  }
  if (other.Mask() != nullptr)
  {
    overlap = OfMaskVoxels(one, *other.Mask());
    return Status::Success();
  }
  if (one.Mask() != nullptr)
  {
    overlap = OfMaskVoxels(other, *one.Mask());
    std::swap(overlap.One, overlap.Other);
    return Status::Success();
  }
  return OfCubes(one, other, overlap);
}
} // namespace palpate
