#pragma once

#include "ImageGrid.h"
#include "PalpateIOModule.h"
#include "SegmentLayers.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace palpate
{
/// A closed polygon in a plane of a grid, as continuous voxel indices.
struct SliceContour
{
  double Slice = 0.0; ///< index of its plane along the third axis
  std::vector<Eigen::Vector2d> Points;
};

/// The number of slices beyond the outermost planes of a structure that it can fill (see
/// ContourFill), from its planes' indices, one or more for each plane.
PALPATEIO_EXPORT int SlicesBeyondPlanes(std::vector<double> planes);

/// Voxels within the contours of structures. A voxel belongs to a structure if its centre is inside
/// of an odd number of its contours in a plane, so that contours within others, and narrow channels
/// that lead to inner ones, are holes. A plane stands for the slices within half the smallest
/// distance of a structure's planes, at least for the nearest slice; a slice takes the nearest
/// plane.
class PALPATEIO_EXPORT ContourFill
{
public:
  /// `mostCrossings` bounds the time and memory of all structures together: the rows of voxels that
  /// contours cross, for each slice. `file` is for messages.
  ContourFill(const std::filesystem::path& file, const std::array<int, 3>& size,
              std::int64_t mostCrossings);

  /// The voxels of one structure, in memory order. Throws InputError beyond the bound. Parts
  /// outside of the grid are left out.
  std::vector<VoxelRun> Runs(const std::vector<SliceContour>& contours);

private:
  using Plane = std::vector<const SliceContour*>;
  struct Crossing
  {
    std::int64_t Row;
    double Column;
  };

  std::vector<Crossing> CrossingsOf(const Plane& plane, std::int64_t slices);
  void AddCrossings(const SliceContour& contour, std::vector<Crossing>& crossings) const;
  std::vector<VoxelRun> RunsOf(const std::vector<Crossing>& crossings) const;

  std::filesystem::path File;
  std::array<int, 3> Size;
  std::int64_t CrossingsLeft;
};
} // namespace palpate
