#pragma once

#include "ModelSoftening.h"
#include "SofteningReport.h"
#include "SofteningSettings.h"

#include <filesystem>
#include <string>

namespace palpate::cli
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
std::string SoftenedAsJson(const SoftenedModel& made);
} // namespace palpate::cli
