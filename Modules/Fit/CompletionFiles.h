#pragma once

#include "PalpateFitModule.h"
#include "ShapeCompletion.h"
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
  /// Measures what a completion found; `count` next places.
  PALPATEFIT_EXPORT static CompletedOrgan Of(const ShapeCompletion& completion, std::size_t touches,
                                             int count);

  RadialModel Model;
  std::size_t Touches = 0;
  std::size_t PriorCases = 0;     ///< 0: smoothness alone
  double Distance = 0.0;          ///< RMS of the touches' distances from the surface
  double LargestDistance = 0.0;   ///< above which it is refused
  std::vector<double> Deviations; ///< standard deviations at the points of the drawn surface
  double MeanDeviation = 0.0;     ///< RMS over the surface's area
  double LargestDeviation = 0.0;
  double Milliliters = 0.0;
  std::vector<Vector3> Next; ///< where to touch next, the first one first
};

/// What is written besides: names of the inputs, and the image on whose grid a mask is wanted.
struct CompletionInputs
{
  std::filesystem::path Points; ///< empty: none
  std::filesystem::path Prior;  ///< empty: none
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
