#pragma once

#include "CohortEffects.h"
#include "PalpateGroupModule.h"

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
  std::string Patient;                 ///< column of patients with several cases; may be empty
  EffectSettings Effects;
};

/// The linear model that a request asks for; none without a formula. Beside the file's columns
/// there are volume_ml and area_mm2 of the models. With a Patient nothing is tested, since the
/// cases of a patient are not independent; see WriteRepeatedScans. `notes` are for the user, with
/// cases' names. Throws InputError and Cancelled.
class PALPATEGROUP_EXPORT CovariateModel
{
public:
  CovariateModel(const CohortGroup& group, const CovariateRequest& request,
                 std::vector<std::string>& notes, const KernelProgress& progress);

  /// Null if nothing was tested.
  const CohortEffects* Effects() const { return this->Tested ? &*this->Tested : nullptr; }
  /// Writes the hand-over to R, if there is a Patient.
  void WriteRepeated(const CohortGroup& group, const std::filesystem::path& folder) const;

private:
  std::string Patient;
  ModelFormula Formula;
  CovariateTable Table;
  std::optional<CohortEffects> Tested;
};
} // namespace palpate
