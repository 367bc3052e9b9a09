#include "VoxelFlips.h"

#include "BrushVoxels.h"
#include "DistanceTransform.h"
#include "MaskEdits.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
// Those that are not as they are to be, without those that the barrier keeps out.
class FlipList
{
public:
  FlipList(const VoxelMask& mask, const VoxelGrid& grid, std::vector<IndexRun>& flips)
      : Mask(mask), Grid(grid), Flips(flips)
  {
  }

  void Want(const std::array<int, 3>& index, bool isInside)
  {
    if (HasVoxel(this->Mask, index) == isInside ||
        (isInside && this->Grid.Closed && this->Grid.Closed(index)))
    {
      return;
    }
    if (!this->Flips.empty())
    {
      IndexRun& last = this->Flips.back();
      if (last.First[1] == index[1] && last.First[2] == index[2] &&
          last.First[0] + last.Count == index[0])
      {
        ++last.Count;
        return;
      }
    }
    this->Flips.push_back({index, 1});
  }
  void Want(const std::vector<IndexRun>& runs, bool isInside)
  {
    for (const IndexRun& run : runs)
    {
      for (int n = 0; n < run.Count; ++n)
      {
        this->Want({run.First[0] + n, run.First[1], run.First[2]}, isInside);
      }
    }
  }

private:
  const VoxelMask& Mask;
  const VoxelGrid& Grid;
  std::vector<IndexRun>& Flips;
};

// Calls `visit` with each voxel of the image in a mask's box and in some slices, inclusive.
template <typename Visit>
void ForEachInSlices(const VoxelMask& mask, const std::array<int, 3>& imageSize, int axis,
                     int firstSlice, int lastSlice, const Visit& visit)
{
  std::array<int, 3> first{};
  std::array<int, 3> last{};
  for (std::size_t a = 0; a < 3; ++a)
  {
    const bool isAcross = a == static_cast<std::size_t>(axis);
    first[a] = isAcross ? firstSlice : std::max(mask.StartIndex[a], 0);
    last[a] = isAcross ? lastSlice : std::min(mask.StartIndex[a] + mask.Size[a], imageSize[a]) - 1;
  }
  for (int k = first[2]; k <= last[2]; ++k)
  {
    for (int j = first[1]; j <= last[1]; ++j)
    {
      for (int i = first[0]; i <= last[0]; ++i)
      {
        visit(std::array<int, 3>{i, j, k});
      }
    }
  }
}

// A slice of a mask's box, which need not reach it.
VoxelMask SliceOf(const VoxelMask& mask, int axis, int slice)
{
  std::array<int, 3> first = mask.StartIndex;
  std::array<int, 3> last{};
  for (std::size_t a = 0; a < 3; ++a)
  {
    last[a] = first[a] + mask.Size[a] - 1;
  }
  first[static_cast<std::size_t>(axis)] = slice;
  last[static_cast<std::size_t>(axis)] = slice;
  return InBox(mask, first, last);
}

std::vector<float> DistanceInSlice(const VoxelMask& slice, int axis)
{
  double least = std::max({slice.Spacing[0], slice.Spacing[1], slice.Spacing[2]});
  for (std::size_t a = 0; a < 3; ++a)
  {
    least = a == static_cast<std::size_t>(axis) ? least : std::min(least, slice.Spacing[a]);
  }
  return SignedDistance(slice, static_cast<DistanceDomain>(axis), 0.5 * least);
}

struct FlipFinder
{
  const VoxelGrid& Grid;
  const VoxelMask& Mask;
  FlipList List;

  Status operator()(const BrushStroke& stroke)
  {
    VoxelMask made;
    Status status = MakeStroke(stroke, this->Grid.ToWorld, this->Grid.ImageSize, made);
    this->List.Want(ImageRunsOf(made), !stroke.Erases);
    return status;
  }
  Status operator()(const VoxelEdit& edit)
  {
    if (edit.Runs == nullptr ||
        !std::all_of(edit.Runs->begin(), edit.Runs->end(),
                     [this](const IndexRun& run) { return this->IsInImage(run); }))
    {
      return Status::Failure("has voxels beyond the image: it is of another grid");
    }
    this->List.Want(*edit.Runs, !edit.Erases);
    return Status::Success();
  }
  Status operator()(const SliceCopy& copy)
  {
    if (!this->IsSlice(copy.Axis, copy.From) || !this->IsSlice(copy.Axis, copy.To))
    {
      return Status::Failure("has a slice beyond the image");
    }
    ForEachInSlices(this->Mask, this->Grid.ImageSize, copy.Axis, copy.To, copy.To,
                    [&](const std::array<int, 3>& index)
                    {
                      std::array<int, 3> from = index;
                      from[static_cast<std::size_t>(copy.Axis)] = copy.From;
                      this->List.Want(index, HasVoxel(this->Mask, from));
                    });
    return Status::Success();
  }
  // Shape-based: between the signed distances in both slices (Raya and Udupa, IEEE TMI 9, 1990).
  Status operator()(const SliceFilling& filling)
  {
    const auto [first, last] = std::minmax(filling.First, filling.Last);
    if (!this->IsSlice(filling.Axis, first) || !this->IsSlice(filling.Axis, last))
    {
      return Status::Failure("has a slice beyond the image");
    }
    const VoxelMask low = SliceOf(this->Mask, filling.Axis, first);
    const VoxelMask high = SliceOf(this->Mask, filling.Axis, last);
    if (low.Count() == 0 || high.Count() == 0)
    {
      return Status::Failure("fills between slices of which one has no voxels");
    }
    const std::vector<float> inLow = DistanceInSlice(low, filling.Axis);
    const std::vector<float> inHigh = DistanceInSlice(high, filling.Axis);
    ForEachInSlices(
        this->Mask, this->Grid.ImageSize, filling.Axis, first + 1, last - 1,
        [&, first = first, last = last](const std::array<int, 3>& index)
        {
          std::array<int, 3> at = index;
          at[static_cast<std::size_t>(filling.Axis)] = first;
          const std::size_t place = low.Offset(at[0] - low.StartIndex[0], at[1] - low.StartIndex[1],
                                               at[2] - low.StartIndex[2]);
          const int slice = index[static_cast<std::size_t>(filling.Axis)];
          const double share = static_cast<double>(slice - first) / (last - first);
          this->List.Want(index, (1.0 - share) * inLow[place] + share * inHigh[place] > 0.0);
        });
    return Status::Success();
  }
  template <typename Other>
  Status operator()(const Other& /*step*/)
  {
    return Status::Failure("is no step of few voxels");
  }

private:
  bool IsSlice(int axis, int slice) const
  {
    return axis >= 0 && axis < 3 && slice >= 0 &&
           slice < this->Grid.ImageSize[static_cast<std::size_t>(axis)];
  }
  bool IsInImage(const IndexRun& run) const
  {
    return this->IsSlice(0, run.First[0]) && this->IsSlice(1, run.First[1]) &&
           this->IsSlice(2, run.First[2]) && run.Count > 0 &&
           run.Count <= this->Grid.ImageSize[0] - run.First[0];
  }
};
} // namespace

bool IsFlip(const CorrectionStep& step) noexcept
{
  return std::holds_alternative<BrushStroke>(step) || std::holds_alternative<VoxelEdit>(step) ||
         std::holds_alternative<SliceCopy>(step) || std::holds_alternative<SliceFilling>(step);
}

Status FindFlips(const CorrectionStep& step, const VoxelGrid& grid, const VoxelMask& mask,
                 std::vector<IndexRun>& flips)
{
  flips.clear();
  return std::visit(FlipFinder{grid, mask, FlipList(mask, grid, flips)}, step);
}

long long Flip(const std::vector<IndexRun>& flips, VoxelMask& mask)
{
  long long more = 0;
  for (const IndexRun& run : flips)
  {
    unsigned char* voxel = &mask.Inside[mask.Offset(run.First[0] - mask.StartIndex[0],
                                                    run.First[1] - mask.StartIndex[1],
                                                    run.First[2] - mask.StartIndex[2])];
    for (int n = 0; n < run.Count; ++n, ++voxel)
    {
      more += *voxel == 0 ? 1 : -1;
      *voxel ^= 1U;
    }
  }
  return more;
}
} // namespace palpate
