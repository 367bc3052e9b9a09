#pragma once

#include "PalpateFitModule.h"
#include "Progress.h"
#include "SofteningSettings.h"
#include "SurfaceModel.h"

#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/// What makes a model yield.
struct ModelSoftness
{
  std::shared_ptr<const ComplianceMaps> Elasticity;
  /// "20 kPa, inclusions of 60 kPa": without those that lie outside of the model.
  std::string Tissue;
  OrganSoftening::Account Account;
  std::vector<std::string> Notes;
};

/// Makes a star-shaped model yield. `name` is that of its file or structure, for messages. Takes
/// seconds. Throws InputError for other models and settings outside their limits, and Cancelled.
PALPATEFIT_EXPORT ModelSoftness SoftenModel(const SurfaceModel& model, const std::string& name,
                                            const SofteningSettings& settings,
                                            const ProgressFunction& progress);
} // namespace palpate
