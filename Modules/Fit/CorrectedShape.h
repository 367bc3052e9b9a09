#pragma once

#include "BodyComparison.h"
#include "CorrectedMask.h"
#include "CorrectionStep.h"
#include "IndexedMesh.h"
#include "MaskEdits.h"
#include "ModelDocument.h"
#include "PalpateFitModule.h"
#include "Segmentation.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace palpate
{
/// What a pull does at a voxel of another structure.
enum class NeighborPolicy
{
  Stop,    ///< it ends there
  Overlap, ///< the voxel becomes one of both structures, in a layer of its own
  Overwrite
};

/// How a corrected organ differs from its start. Lengths mm, patient LPS.
struct CorrectionChange
{
  long long AddedVoxels = 0; ///< of a mask
  long long RemovedVoxels = 0;
  IndexedMesh Surface; ///< of the result
  /// Of the surface's points from the surface at the start, positive outside of it.
  std::vector<double> Distances;
  double Dice = 1.0;             ///< with the start
  double StartMilliliters = 0.0; ///< of voxels, or enclosed by a model
  double Milliliters = 0.0;
  double MeanDistance = 0.0;    ///< without sign, over the result's area
  double LargestDistance = 0.0; ///< in both directions
};

/// Calls `visit(index, isInside)` with each voxel of the image that is in one of two masks only,
/// and whether it is in the second, whose box holds both.
template <typename Visit>
void ForEachChange(const VoxelMask& start, const VoxelMask& result, const Visit& visit)
{
  for (int k = 0; k < result.Size[2]; ++k)
  {
    for (int j = 0; j < result.Size[1]; ++j)
    {
      for (int i = 0; i < result.Size[0]; ++i)
      {
        const std::array<int, 3> index{result.StartIndex[0] + i, result.StartIndex[1] + j,
                                       result.StartIndex[2] + k};
        const bool isInside = result.Inside[result.Offset(i, j, k)] != 0;
        if (isInside != HasVoxel(start, index))
        {
          visit(index, isInside);
        }
      }
    }
  }
}

/// Whether a voxel (image index) is one of another structure.
PALPATEFIT_EXPORT MaskCorrection::Barrier OtherVoxels(const Segmentation& segmentation,
                                                      const Segment& structure);

/// A structure's mask, or a model, under correction, as `palpate correct` and the window have it.
/// Copies share what is large, and may be used in other threads. Not thread-safe.
class PALPATEFIT_EXPORT CorrectedShape
{
public:
  static CorrectedShape OfMask(std::shared_ptr<const Segmentation> start, const Segment& structure,
                               NeighborPolicy neighbors);
  /// It can be pulled only.
  static CorrectedShape OfModel(const ModelDocument& start);

  /// Does these steps instead of the present ones; those that both begin with stay, which needs no
  /// time. Makes the surface that is pulled next. Throws InputError for a step that fails, naming
  /// its number; then those before it are done.
  void Do(const std::vector<CorrectionStep>& steps);
  const std::vector<CorrectionStep>& Steps() const { return this->List; }
  bool IsMask() const { return this->Mask.has_value(); }
  /// The mask under correction; null for a model.
  const CorrectedMask* Voxels() const { return this->Mask ? &*this->Mask : nullptr; }

  ///@{
  /// The surface that is pulled, and its triangles. Throws InputError for a mask that has none.
  const SurfaceCorrection& Pulls();
  const std::vector<std::array<int, 3>>& Triangles();
  ///@}

  /// The corrected mask; only if IsMask. See CorrectedMask::Mask.
  const VoxelMask& ResultMask() { return this->Mask->Mask(); }
  /// The corrected mask (ComparedBody::OfMask) compared with another body; only if IsMask. Throws
  /// InputError.
  BodyComparison CompareWith(const ComparedBody& other);
  /// The corrected model; only if not IsMask. Throws InputError if it cannot be one.
  OrganModel ResultModel() const;
  /// Measured within a second. Throws InputError.
  CorrectionChange Change();

private:
  Status Apply(const CorrectionStep& step);
  void TakeBack();

  std::shared_ptr<const Segmentation> Source; ///< which the barrier of the mask asks
  std::optional<CorrectedMask> Mask;
  OrganModel Model; ///< at the start, if there is no mask
  SurfaceCorrection ModelPulls;
  std::shared_ptr<const std::vector<std::array<int, 3>>> ModelTriangles;
  std::vector<CorrectionStep> List;
};
} // namespace palpate
