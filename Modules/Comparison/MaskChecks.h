#pragma once

#include "CheckGroup.h"
#include "CheckedCase.h"
#include "PalpateComparisonModule.h"
#include "Progress.h"
#include "Segmentation.h"
#include "Volume.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace palpate
{
struct CheckSettings
{
  VolumeChoice Images;
  std::string As;     ///< of folders: "structures", "cases", or empty to judge (MaskFolder)
  double Rate = 0.05; ///< of false alarms of a whole case, 0..1
  const CheckGroup* Group = nullptr; ///< null: by fixed limits
  std::size_t Jobs = 1;              ///< threads
};

/// The structures of one patient and how believable each is.
struct CaseCheck
{
  std::filesystem::path File;
  std::string Name;
  std::string Message; ///< why it is not checked; empty if it is
  std::vector<std::string> Notes;
  std::vector<RefusedMask> Refused; ///< that the case lacks
  CheckedCase Patient;
  std::vector<OrganJudgement> Judgements;      ///< of each organ
  std::map<std::size_t, CheckedMask> Doubtful; ///< masks of organs that are not plausible, by place

  bool IsChecked() const { return this->Message.empty(); }
  /// That of the worst organ.
  OrganJudgement::Verdict Worst() const;
};

/// Masks that were checked.
struct MaskChecks
{
  std::vector<CaseCheck> Cases; ///< the worst first; those that cannot be checked last
  std::vector<std::string> Notes;
  double Rate = 0.05;
  bool IsByGroup = false;

  /// Inputs are label maps, masks, folders of masks that are one segmentation, and folders of
  /// cases: of masks that are cases, or of folders of the former kind. Throws InputError for an
  /// input without masks, or of which it is unclear what it is, and Cancelled.
  PALPATECOMPARISON_EXPORT static MaskChecks Of(const std::vector<std::filesystem::path>& inputs,
                                                const CheckSettings& settings,
                                                const ProgressFunction& progress);
  /// A segmentation that was read, as one case. Throws Cancelled.
  PALPATECOMPARISON_EXPORT static MaskChecks
  Of(const Segmentation& labels, const CheckSettings& settings, const ProgressFunction& progress);
  /// Measures the same for a group: in the order of the inputs, without judgements.
  PALPATECOMPARISON_EXPORT static MaskChecks
  Measure(const std::vector<std::filesystem::path>& inputs, const CheckSettings& settings,
          const ProgressFunction& progress);
};
} // namespace palpate
