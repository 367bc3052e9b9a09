#pragma once

#include "CorrectedShape.h"
#include "ModelDocument.h"
#include "PalpateFitModule.h"
#include "Segmentation.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// A corrected organ, and how it differs from the start.
struct CorrectedOrgan : CorrectionChange
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

/// The name of the file with the corrected organ that WriteCorrectionFiles writes.
PALPATEFIT_EXPORT std::string CorrectedFileOf(const CorrectedOrgan& organ,
                                              const CorrectionInputs& inputs);

/// Writes corrections.json (the steps, to be replayed), correction.json, change.vtp (the result's
/// surface with the point array "SignedDistance" from the start, mm), and mask.nii.gz,
/// mask.seg.nrrd (of a segmentation in layers or that format), or model.json. All of them or none.
/// Throws InputError.
PALPATEFIT_EXPORT void WriteCorrectionFiles(const CorrectedOrgan& organ,
                                            const CorrectionInputs& inputs,
                                            const std::filesystem::path& folder,
                                            const std::string& program);
} // namespace palpate
