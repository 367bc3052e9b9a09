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
} // namespace

CorrectedMask::CorrectedMask(VoxelMask mask, const IndexToWorld& toWorld,
                             const std::array<int, 3>& imageSize, MaskCorrection::Barrier barrier)
    : ToWorld(toWorld), ImageSize(imageSize), Closed(std::move(barrier))
{
  this->Stages.push_back(
      {std::make_shared<const VoxelMask>(std::move(mask)), nullptr, {}, nullptr});
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
  Status status = MaskCorrection::Make(*stage.Start, this->ToWorld, this->ImageSize, surface);
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
  Status status = pull != nullptr ? this->Prepare() : this->Edit(step);
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
    ClearBeyond(this->ImageSize, mask);
  }
  else
  {
    const auto& cut = std::get<PlaneCut>(step);
    if (!cut.PointWorld.allFinite() || !cut.Normal.allFinite() || cut.Normal.isZero(0.0))
    {
      return Status::Failure("is cut at a plane whose point or normal is not finite, or zero");
    }
    CutMask(cut.PointWorld, cut.Normal, this->ToWorld, mask);
  }
  if (mask.Count() == 0)
  {
    return Status::Failure("would have no voxels left");
  }
  this->Stages.push_back(
      {std::make_shared<const VoxelMask>(std::move(mask)), nullptr, {}, nullptr});
  return Status::Success();
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
    stage.Result = std::make_shared<const VoxelMask>(
        stage.Surface->Moved(stage.Pulls.Displacements(), this->Closed));
  }
  return *stage.Result;
}
} // namespace palpate
