#pragma once

#include "CorrectionStep.h"
#include "IndexedMesh.h"
#include "ModelDocument.h"
#include "PalpateFitModule.h"
#include "Segmentation.h"

#include <filesystem>
#include <optional>
#include <string>
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

/// A corrected organ, and how it differs from the start. Lengths mm, patient LPS.
struct CorrectedOrgan
{
  /// Of a structure of a segmentation, which stays as it is. Throws InputError for a step that
  /// fails, naming its number.
  PALPATEFIT_EXPORT static CorrectedOrgan OfMask(const Segmentation& start,
                                                 const Segment& structure,
                                                 const std::vector<CorrectionStep>& steps,
                                                 NeighborPolicy neighbors);
  /// Of a model, by pulls only. Throws InputError for another step or one that fails.
  PALPATEFIT_EXPORT static CorrectedOrgan OfModel(const ModelDocument& start,
                                                  const std::vector<CorrectionStep>& steps);

  std::optional<Segmentation> Mask; ///< all structures, of which one is corrected
  std::optional<ModelDocument> Model;
  std::vector<CorrectionStep> Steps;
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

/// Names of what was corrected.
struct CorrectionInputs
{
  std::filesystem::path File;
  std::optional<Segment> Structure; ///< of a segmentation
  NeighborPolicy Neighbors = NeighborPolicy::Stop;
};

/// One object, as Documentation/JsonOutput.md lists its keys; `folder` is where files are written,
/// or empty.
PALPATEFIT_EXPORT std::string CorrectionJson(const CorrectedOrgan& organ,
                                             const CorrectionInputs& inputs,
                                             const std::string& folder);

/// Writes corrections.json (the steps, to be replayed), correction.json, change.vtp (the result's
/// surface with the point array "SignedDistance" from the start, mm), and mask.nii.gz,
/// mask.seg.nrrd (of a segmentation in layers or that format), or model.json. All of them or none.
/// Throws InputError.
PALPATEFIT_EXPORT void WriteCorrectionFiles(const CorrectedOrgan& organ,
                                            const CorrectionInputs& inputs,
                                            const std::filesystem::path& folder,
                                            const std::string& program);
} // namespace palpate
