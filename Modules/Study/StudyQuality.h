#pragma once

#include "PalpateStudyModule.h"
#include "QualityReport.h"
#include "StudyJobs.h"
#include "StudyState.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/// Quality presets of a study's structures, measured in the background. Owner thread only.
class PALPATESTUDY_EXPORT StudyQuality
{
public:
  /// Keeps the address.
  explicit StudyQuality(StudyJobs& jobs) : Jobs(jobs) {}

  /// Measures every touchable structure of a state that is not measured yet, with the tool of
  /// `touched`: the same as a scene to touch.
  void Measure(const StudyState& state, const SceneSettings& touched);
  bool IsMeasuring() const { return !this->Running.empty(); }
  /// One line per touchable structure.
  std::vector<QualityLine> Lines(const StudyState& state) const;
  /// The state with the recommended preset of each measured structure.
  StudyState WithRecommended(const StudyState& state) const;

private:
  struct Quality
  {
    std::string Key; ///< all settings of the measurement
    std::shared_ptr<const QualityMeasurement> Measured;
    std::string Problem;
  };

  const QualityMeasurement* Of(const StudyState& state, const SceneStructure& structure) const;

  StudyJobs& Jobs;
  std::map<int, Quality> Qualities;
  std::map<int, StudyJobs::Id> Running;
};
} // namespace palpate
