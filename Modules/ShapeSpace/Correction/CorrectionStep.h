#pragma once

#include "SurfacePull.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace palpate
{
/// All but the largest part of a mask is removed.
struct IslandRemoval
{
};

/// Cavities that a mask encloses are filled.
struct CavityFilling
{
};

/// A mask's surface is smoothed by a Gaussian; its size stays.
struct SurfaceSmoothing
{
  static constexpr double LargestDeviation = 20.0; ///< mm
  double Deviation = 1.0;                          ///< mm
};

/// What lies beyond a plane, where its normal points to, is removed.
struct PlaneCut
{
  Vector3 PointWorld = Vector3::Zero(); ///< mm, patient LPS
  Vector3 Normal = Vector3::UnitZ();    ///< of any length
};

/// What a brush passes over is added to a mask, or removed from it: the voxels whose centres are
/// within the radius of its path. Copies share the path.
struct BrushStroke
{
  static constexpr double LeastRadius = 0.1;    ///< mm
  static constexpr double LargestRadius = 50.0; ///< mm
  static constexpr std::size_t MostPoints = 10000;
  using Path = std::vector<Vector3>;

  std::shared_ptr<const Path> PointsWorld; ///< mm, patient LPS, joined by straight lines
  double Radius = 5.0;                     ///< mm
  /// Normal of the slice through the first point, in whose voxels alone the brush is a disc; none:
  /// it is a ball.
  std::optional<Vector3> SliceNormal;
  bool Erases = false;
};

/// Voxels along the first axis of an image.
struct IndexRun
{
  std::array<int, 3> First{}; ///< image index
  int Count = 0;
};

/// Voxels that are added to a mask, or removed from it: a stroke that ended at edges of an image.
/// Of the mask's own grid. Copies share the runs.
struct VoxelEdit
{
  std::shared_ptr<const std::vector<IndexRun>> Runs;
  bool Erases = false;
};

/// A slice of a mask's grid (image indices along an axis, 0 to 2) becomes what another one is.
struct SliceCopy
{
  int Axis = 2;
  int From = 0;
  int To = 0;
};

/// The slices between two become the shapes between theirs.
struct SliceFilling
{
  int Axis = 2;
  int First = 0;
  int Last = 0;
};

inline bool operator==(const IslandRemoval& /*a*/, const IslandRemoval& /*b*/)
{
  return true;
}
inline bool operator==(const CavityFilling& /*a*/, const CavityFilling& /*b*/)
{
  return true;
}
inline bool operator==(const SurfaceSmoothing& a, const SurfaceSmoothing& b)
{
  return a.Deviation == b.Deviation;
}
inline bool operator==(const PlaneCut& a, const PlaneCut& b)
{
  return a.PointWorld == b.PointWorld && a.Normal == b.Normal;
}

/// Whether two shared lists hold the same; null ones hold nothing.
template <typename List>
bool IsSameList(const std::shared_ptr<const List>& a, const std::shared_ptr<const List>& b)
{
  return a == b || (a != nullptr && b != nullptr && *a == *b);
}
inline bool operator==(const BrushStroke& a, const BrushStroke& b)
{
  return a.Radius == b.Radius && a.SliceNormal == b.SliceNormal && a.Erases == b.Erases &&
         IsSameList(a.PointsWorld, b.PointsWorld);
}
inline bool operator==(const IndexRun& a, const IndexRun& b)
{
  return a.First == b.First && a.Count == b.Count;
}
inline bool operator==(const VoxelEdit& a, const VoxelEdit& b)
{
  return a.Erases == b.Erases && IsSameList(a.Runs, b.Runs);
}
inline bool operator==(const SliceCopy& a, const SliceCopy& b)
{
  return a.Axis == b.Axis && a.From == b.From && a.To == b.To;
}
inline bool operator==(const SliceFilling& a, const SliceFilling& b)
{
  return a.Axis == b.Axis && a.First == b.First && a.Last == b.Last;
}

/// One correction of a mask; of a model, pulls only.
using CorrectionStep = std::variant<SurfacePull, IslandRemoval, CavityFilling, SurfaceSmoothing,
                                    PlaneCut, BrushStroke, VoxelEdit, SliceCopy, SliceFilling>;
} // namespace palpate
