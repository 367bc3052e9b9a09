#pragma once

#include "OrganCompletion.h"
#include "PalpateFitModule.h"
#include "Volume.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// A completed surface, and what is said of it. Lengths mm, patient LPS.
struct CompletedOrgan
{
  /// Of the points whose standard deviations a completion must have.
  static constexpr int Frequency = 20;
  /// Measures what a completion found, that is judged well.
  PALPATEFIT_EXPORT static CompletedOrgan Of(OrganCompletion completion, std::size_t touches);

  OrganCompletion Found;
  std::size_t Touches = 0;
  double MeanDeviation = 0.0; ///< RMS over the surface's area
  double LargestDeviation = 0.0;
  double Milliliters = 0.0;
};

/// What is written besides: names of the inputs, and the image on whose grid a mask is wanted.
struct CompletionInputs
{
  std::filesystem::path Points; ///< empty: none
  std::filesystem::path Prior;  ///< empty: none
  std::filesystem::path Known;  ///< the other organ; empty: none
  double Sigma = 1.0;           ///< mm
  vtkSmartPointer<vtkImageData> Grid = nullptr;
};

/// One object, as Documentation/JsonOutput.md lists its keys; `folder` is where files are written,
/// or empty.
PALPATEFIT_EXPORT std::string CompletionJson(const CompletedOrgan& organ,
                                             const CompletionInputs& inputs,
                                             const std::string& folder);

/// Writes model.json, model.vtp (with the point array "StandardDeviation", mm), completion.json
/// and, with a grid, mask.nii.gz: 1 for voxels whose centres the surface encloses. All of them or
/// none. Throws InputError.
PALPATEFIT_EXPORT void WriteCompletionFiles(const CompletedOrgan& organ,
                                            const CompletionInputs& inputs,
                                            const std::filesystem::path& folder,
                                            const std::string& program);
} // namespace palpate
