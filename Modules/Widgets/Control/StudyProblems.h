#pragma once

#include "Study.h"

#include <array>
#include <string>
#include <vector>

namespace palpate
{
/// What a study has to tell its user now. A message is there as long as its cause.
class StudyProblems
{
public:
  /// The steps whose failure is a problem of the study.
  static constexpr std::array<SceneStep, 12> Steps{
      {SceneStep::Volume, SceneStep::Segmentation, SceneStep::Structures, SceneStep::Surface,
       SceneStep::Samples, SceneStep::Model, SceneStep::Elasticity, SceneStep::Field,
       SceneStep::Protection, SceneStep::Touch, SceneStep::Tool, SceneStep::Guide}};

  /// Keeps the address.
  explicit StudyProblems(Study& study) : Open(study) {}

  /// Each message once, in the order of the work: what was assumed of an image, or changed, when it
  /// was read; what structures do not yield by; failures and replacements of steps; what hinders
  /// drill, touch and replay. `reading` is the newest one of a touch.
  std::vector<std::string> Now(const StudyTouchReading& reading);

private:
  void AddNotes();
  void AddFailures();
  void AddProtection();
  void AddHold(const StudyTouchReading& reading);
  void Add(const std::string& message);

  Study& Open;
  std::vector<std::string> Messages;
  std::string Hold; ///< why a drill that was started does not turn
};
} // namespace palpate
