#pragma once

#include "InclusionShare.h"
#include "OrganModel.h"
#include "PalpateFitModule.h"
#include "Progress.h"
#include "SofteningCache.h"
#include "SofteningSettings.h"

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
  int ComplianceDegree = 0;
  bool IsFromCache = false;
  std::vector<InclusionShare> Inclusions; ///< those of the settings, in their order
  std::vector<std::string> Notes;         ///< on images, neighbours and the model's shape

  /// All that a user has to know before relying on it: the notes, and those of the inclusions.
  PALPATEFIT_EXPORT std::vector<std::string> Warnings() const;
};

/// Makes a radial model yield. `name` is that of its file or structure, for messages. Takes
/// seconds, unless `cache` has it; what is made is added to it. A null cache is none. Throws
/// InputError for other models and settings outside their limits, and Cancelled.
PALPATEFIT_EXPORT ModelSoftness SoftenModel(const OrganModel& model, const std::string& name,
                                            const SofteningSettings& settings,
                                            const ProgressFunction& progress,
                                            const SofteningCache* cache = nullptr);
} // namespace palpate
