#pragma once

#include "KernelProgress.h"
#include "MapRows.h"
#include "PalpateIOModule.h"
#include "vtkImageData.h"

#include <optional>

namespace palpate
{
/// Where a moving image belongs.
struct ImageRegistration
{
  MapRows Back{}; ///< from the fixed image to the moving one
  ///@{ Mutual information of both images' values (nats), of samples at the full resolution.
  double InformationBefore = 0.0;
  double InformationAfter = 0.0;
  ///@}
  int Steps = 0; ///< of all resolutions
};

struct ImageRegistrationSettings
{
  bool ChangesSize = false; ///< a similarity
  bool IsAffine = false;    ///< any linear map
  MapRows StartBack{};      ///< from the fixed image to the moving one
};

/// Brings an image onto another one, of any modality, so that their values tell most about each
/// other (Mattes' mutual information, by ITK, of random samples with a fixed seed): from coarse to
/// fine. Images are of one component. Sums of several threads make the tenth digit differ from run
/// to run. Empty if cancelled. Throws InputError if the images do not overlap at the start.
///
/// D. Mattes et al., "Nonrigid multimodality image registration", Proc. SPIE 4322 (2001).
PALPATEIO_EXPORT std::optional<ImageRegistration>
RegisterImages(vtkImageData* moving, vtkImageData* fixed, const ImageRegistrationSettings& settings,
               const KernelProgress& progress);
} // namespace palpate
