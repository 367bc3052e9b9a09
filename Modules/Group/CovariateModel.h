#pragma once

#include "CohortEffects.h"
#include "PalpateGroupModule.h"
#include "RepeatedEffects.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// What a user asks of covariates.
struct CovariateRequest
{
  std::filesystem::path File;          ///< see ReadCovariates; may be empty
  std::string Id;                      ///< its column with the cases; may be empty
  std::string Formula;                 ///< empty for no model
  std::vector<std::string> References; ///< COLUMN=LEVEL
  RepeatedColumns Repeated;            ///< may be empty
  EffectSettings Effects;
  bool IsForSides = false; ///< the file has sides (FindSidePairs), so needs no formula
};

/// The table of a request, with volume_ml and area_mm2 of the models. Throws InputError.
PALPATEGROUP_EXPORT CovariateTable CovariatesOf(const CohortGroup& group,
                                                const CovariateRequest& request,
                                                std::vector<std::string>& notes);

/// The model that a request asks for: mixed models if there are patients with several cases, which
/// are not independent; none without a formula. Beside the file's columns there are volume_ml and
/// area_mm2 of the models. A time that the formula lacks is added to it. `notes` are for the user,
/// with cases' names. Throws InputError and Cancelled.
class PALPATEGROUP_EXPORT CovariateModel
{
public:
  CovariateModel(const CohortGroup& group, const CovariateRequest& request,
                 std::vector<std::string>& notes, const KernelProgress& progress);

  ///@{ Null if it was not asked for.
  const CohortEffects* Effects() const { return this->Tested ? &*this->Tested : nullptr; }
  const RepeatedEffects* Repeated() const { return this->Mixed ? &*this->Mixed : nullptr; }
  ///@}

private:
  std::optional<CohortEffects> Tested;
  std::optional<RepeatedEffects> Mixed;
};
} // namespace palpate
