#pragma once

#include "ModelSoftening.h"
#include "PalpateFitModule.h"
#include "SofteningReport.h"
#include "SofteningSettings.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// A softened model, for `palpate soften --json`.
struct SoftenedModel
{
  std::filesystem::path Input;
  std::filesystem::path Output;
  const SofteningSettings& Settings;
  const ModelSoftness& Softness;
  const FeltStiffness& Felt;
  double ToolRadius = 0.0; ///< mm
  double Seconds = 0.0;    ///< of the softening
};

/// One JSON object on one line, see Documentation/JsonOutput.md.
PALPATEFIT_EXPORT std::string SoftenedAsJson(const SoftenedModel& made);
} // namespace palpate
