#pragma once

#include "CorrectionStep.h"
#include "MaskCorrection.h"
#include "Status.h"
#include "SurfaceCorrection.h"
#include "VoxelFlips.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace palpate
{
/// A mask under correction: a function of the mask at the start and the list of steps. Pulls that
/// follow each other move one surface, that of the mask before them; an edit makes a new one, and
/// strokes that follow each other (IsFlip) change one mask, of which no other copy is made. Each
/// step can be undone, back to the start, to the same bits. Copies share masks, and may be used in
/// other threads. World mm, patient LPS. Not thread-safe.
class CorrectedMask
{
public:
  /// Each keeps the mask before it, for undoing; strokes after a pull or an edit count as one.
  static constexpr std::size_t MostEdits = 100;
  static constexpr std::size_t MostStrokes = 1000; ///< that follow each other; keep their voxels

  CorrectedMask() = default;
  /// `mask` is of an image of this size, and has a rim of voxels outside. Pulls add no voxel of the
  /// barrier.
  CorrectedMask(VoxelMask mask, const IndexToWorld& toWorld, const std::array<int, 3>& imageSize,
                MaskCorrection::Barrier barrier = {});

  /// Fails, leaving the mask as it is, as SurfaceCorrection, MaskCorrection and FindFlips do, for
  /// numbers out of range, after MostEdits or MostStrokes, and for an edit that removes every
  /// voxel.
  Status Apply(const CorrectionStep& step);
  /// Removes the last step; false if there is none.
  bool Undo();

  /// What is corrected.
  const VoxelMask& Start() const noexcept { return *this->Stages.front().Start; }
  const IndexToWorld& Grid() const noexcept { return this->Image.ToWorld; }
  const std::array<int, 3>& ImageSize() const noexcept { return this->Image.ImageSize; }
  const std::vector<CorrectionStep>& Steps() const noexcept { return this->List; }
  /// The mask as it is now; as MaskCorrection::Moved. Allocates; after a pull some 0.1 s, else
  /// fast.
  const VoxelMask& Mask();
  /// The surface that is pulled, before its pulls (triangles, normals), and the pulls. Fails as
  /// MaskCorrection::Make.
  Status Surface(const MaskCorrection*& surface, const SurfaceCorrection*& pulls);

private:
  // What a stroke has changed, and the box before it.
  struct Stroke
  {
    std::shared_ptr<const std::vector<IndexRun>> Flips;
    std::array<int, 3> StartIndex{};
    std::array<int, 3> Size{};
  };
  struct Stage
  {
    std::shared_ptr<VoxelMask> Start; ///< with the strokes; changed only where nobody shares it
    std::vector<Stroke> Strokes;      ///< that the stage begins with, unless by an edit
    long long Voxels = 0;             ///< of a start with strokes
    std::shared_ptr<const MaskCorrection> Surface; ///< made for the first pull
    SurfaceCorrection Pulls;
    std::shared_ptr<VoxelMask> Result; ///< of the pulls; null: not made, or with later strokes
  };

  Status Edit(const CorrectionStep& step);
  Status Paint(const CorrectionStep& step);
  void UndoStroke();
  Status Prepare();

  std::vector<Stage> Stages;
  std::vector<CorrectionStep> List;
  VoxelGrid Image;
};
} // namespace palpate
