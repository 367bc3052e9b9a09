#include "CorrectedMask.h"

#include "MaskComponents.h"
#include "MaskEdits.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
Status SmoothWithin(double deviation, VoxelMask& mask)
{
  if (!(deviation > 0.0) || !(deviation <= SurfaceSmoothing::LargestDeviation))
  {
    return Status::Failure("is smoothed by more than 0 and at most 20 mm");
  }
  std::array<int, 3> first = mask.StartIndex;
  std::array<int, 3> last{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int rim = static_cast<int>(std::ceil(2.0 * deviation / mask.Spacing[axis])) + 1;
    last[axis] = first[axis] + mask.Size[axis] - 1 + rim;
    first[axis] -= rim;
  }
  mask = InBox(mask, first, last);
  SmoothMask(deviation, mask);
  return Status::Success();
}

// Voxels outside of the image are no voxels.
void ClearBeyond(const std::array<int, 3>& imageSize, VoxelMask& mask)
{
  std::size_t at = 0;
  for (int k = 0; k < mask.Size[2]; ++k)
  {
    for (int j = 0; j < mask.Size[1]; ++j)
    {
      for (int i = 0; i < mask.Size[0]; ++i, ++at)
      {
        const std::array<int, 3> index{mask.StartIndex[0] + i, mask.StartIndex[1] + j,
                                       mask.StartIndex[2] + k};
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          mask.Inside[at] = index[axis] < 0 || index[axis] >= imageSize[axis] ? 0 : mask.Inside[at];
        }
      }
    }
  }
}

// A mask that nobody else has, with a rim around voxels that are to change; a copy if it has not.
VoxelMask& OwnWithRoom(const std::vector<IndexRun>& flips, std::shared_ptr<VoxelMask>& mask)
{
  std::array<int, 3> first = mask->StartIndex;
  std::array<int, 3> last{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    last[axis] = first[axis] + mask->Size[axis] - 1;
  }
  for (const IndexRun& run : flips)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      first[axis] = std::min(first[axis], run.First[axis] - 1);
      last[axis] = std::max(last[axis], run.First[axis] + (axis == 0 ? run.Count : 1));
    }
  }
  const bool isWide = first == mask->StartIndex && last[0] - first[0] + 1 == mask->Size[0] &&
                      last[1] - first[1] + 1 == mask->Size[1] &&
                      last[2] - first[2] + 1 == mask->Size[2];
  if (!isWide || mask.use_count() > 1)
  {
    mask = std::make_shared<VoxelMask>(isWide ? *mask : InBox(*mask, first, last));
  }
  return *mask;
}
} // namespace

CorrectedMask::CorrectedMask(VoxelMask mask, const IndexToWorld& toWorld,
                             const std::array<int, 3>& imageSize, MaskCorrection::Barrier barrier)
    : Image{toWorld, imageSize, std::move(barrier)}
{
  this->Stages.emplace_back().Start = std::make_shared<VoxelMask>(std::move(mask));
}

Status CorrectedMask::Prepare()
{
  if (this->Stages.empty())
  {
    return Status::Failure("has no voxels");
  }
  Stage& stage = this->Stages.back();
  if (stage.Surface)
  {
    return Status::Success();
  }
  MaskCorrection surface;
  Status status =
      MaskCorrection::Make(*stage.Start, this->Image.ToWorld, this->Image.ImageSize, surface);
  if (status.IsOk())
  {
    stage.Pulls = SurfaceCorrection(surface.Surface().Points, surface.Normals(),
                                    SurfaceCorrection::Motion::Free);
    stage.Surface = std::make_shared<const MaskCorrection>(std::move(surface));
  }
  return status;
}

Status CorrectedMask::Surface(const MaskCorrection*& surface, const SurfaceCorrection*& pulls)
{
  Status status = this->Prepare();
  if (status.IsOk())
  {
    surface = &*this->Stages.back().Surface;
    pulls = &this->Stages.back().Pulls;
  }
  return status;
}

Status CorrectedMask::Apply(const CorrectionStep& step)
{
  const SurfacePull* const pull = std::get_if<SurfacePull>(&step);
  Status status = pull != nullptr ? this->Prepare()
                  : IsFlip(step)  ? this->Paint(step)
                                  : this->Edit(step);
  if (pull != nullptr && status.IsOk())
  {
    status = this->Stages.back().Pulls.Pull(*pull);
    this->Stages.back().Result.reset();
  }
  if (status.IsOk())
  {
    this->List.push_back(step);
  }
  return status;
}

Status CorrectedMask::Edit(const CorrectionStep& step)
{
  if (this->Stages.empty())
  {
    return Status::Failure("has no voxels");
  }
  if (this->Stages.size() > MostEdits)
  {
    return Status::Failure("has more than 100 edits");
  }
  VoxelMask mask = this->Mask();
  if (std::holds_alternative<IslandRemoval>(step))
  {
    RemoveIslands(mask);
  }
  else if (std::holds_alternative<CavityFilling>(step))
  {
    FillCavities(mask);
  }
  else if (const auto* smoothing = std::get_if<SurfaceSmoothing>(&step))
  {
    if (const Status status = SmoothWithin(smoothing->Deviation, mask); !status.IsOk())
    {
      return status;
    }
    ClearBeyond(this->Image.ImageSize, mask);
  }
  else
  {
    const auto& cut = std::get<PlaneCut>(step);
    if (!cut.PointWorld.allFinite() || !cut.Normal.allFinite() || cut.Normal.isZero(0.0))
    {
      return Status::Failure("is cut at a plane whose point or normal is not finite, or zero");
    }
    CutMask(cut.PointWorld, cut.Normal, this->Image.ToWorld, mask);
  }
  if (mask.Count() == 0)
  {
    return Status::Failure("would have no voxels left");
  }
  this->Stages.emplace_back().Start = std::make_shared<VoxelMask>(std::move(mask));
  return Status::Success();
}

Status CorrectedMask::Paint(const CorrectionStep& step)
{
  if (this->Stages.empty())
  {
    return Status::Failure("has no voxels");
  }
  const bool begins =
      this->Stages.back().Strokes.empty() || !this->Stages.back().Pulls.Pulls().empty();
  if (begins ? this->Stages.size() > MostEdits : this->Stages.back().Strokes.size() >= MostStrokes)
  {
    return Status::Failure("has more than 1,000 strokes after each other, or 100 edits");
  }
  const VoxelMask& before = this->Mask();
  std::vector<IndexRun> flips;
  if (Status status = FindFlips(step, this->Image, before, flips); !status.IsOk())
  {
    return status;
  }
  long long count = begins ? before.Count() : this->Stages.back().Voxels;
  for (const IndexRun& run : flips)
  {
    count += HasVoxel(before, run.First) ? -run.Count : run.Count;
  }
  if (count == 0)
  {
    return Status::Failure("would have no voxels left");
  }
  const Stroke stroke{nullptr, before.StartIndex, before.Size};
  if (begins)
  {
    // The result of pulls goes on as the start of the strokes, and back when they are undone.
    Stage& last = this->Stages.back();
    auto start =
        last.Pulls.Pulls().empty() ? std::make_shared<VoxelMask>(before) : std::move(last.Result);
    this->Stages.emplace_back().Start = std::move(start);
  }
  Stage& stage = this->Stages.back();
  Flip(flips, OwnWithRoom(flips, stage.Start));
  stage.Voxels = count;
  stage.Surface.reset();
  stage.Strokes.push_back(stroke);
  stage.Strokes.back().Flips = std::make_shared<const std::vector<IndexRun>>(std::move(flips));
  return Status::Success();
}

void CorrectedMask::UndoStroke()
{
  Stage& stage = this->Stages.back();
  const Stroke stroke = stage.Strokes.back();
  stage.Strokes.pop_back();
  Stage& former = this->Stages[this->Stages.size() - 2];
  if (stage.Strokes.empty() && former.Pulls.Pulls().empty())
  {
    this->Stages.pop_back();
    return;
  }
  stage.Voxels += Flip(*stroke.Flips, OwnWithRoom({}, stage.Start));
  stage.Surface.reset();
  if (stage.Start->Size != stroke.Size)
  {
    std::array<int, 3> last{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      last[axis] = stroke.StartIndex[axis] + stroke.Size[axis] - 1;
    }
    stage.Start = std::make_shared<VoxelMask>(InBox(*stage.Start, stroke.StartIndex, last));
  }
  if (stage.Strokes.empty())
  {
    former.Result = std::move(stage.Start);
    this->Stages.pop_back();
  }
}

bool CorrectedMask::Undo()
{
  if (this->List.empty())
  {
    return false;
  }
  if (std::holds_alternative<SurfacePull>(this->List.back()))
  {
    this->Stages.back().Pulls.Undo();
    this->Stages.back().Result.reset();
  }
  else if (IsFlip(this->List.back()))
  {
    this->UndoStroke();
  }
  else
  {
    this->Stages.pop_back();
  }
  this->List.pop_back();
  return true;
}

const VoxelMask& CorrectedMask::Mask()
{
  Stage& stage = this->Stages.back();
  if (stage.Pulls.Pulls().empty())
  {
    return *stage.Start;
  }
  if (!stage.Result)
  {
    stage.Result = std::make_shared<VoxelMask>(
        stage.Surface->Moved(stage.Pulls.Displacements(), this->Image.Closed));
  }
  return *stage.Result;
}
} // namespace palpate
