#pragma once

#include "Study.h"

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>

namespace palpate
{
/// Tells each problem of a study once, and once what was assumed of its files: for the messages of
/// a window, which looks regularly.
class StudyProblems
{
public:
  /// The steps whose failure is a problem of the study.
  static constexpr std::array<SceneStep, 11> Steps{
      {SceneStep::Volume, SceneStep::Segmentation, SceneStep::Structures, SceneStep::Surface,
       SceneStep::Samples, SceneStep::Model, SceneStep::Elasticity, SceneStep::Field,
       SceneStep::Protection, SceneStep::Touch, SceneStep::Tool}};

  /// Keeps the address.
  StudyProblems(Study& study, std::function<void(const std::string& message)> tell)
      : Open(study), Tell(std::move(tell))
  {
  }

  /// What was assumed of an image, or changed, when it was read, and what structures do not yield
  /// by.
  void LookAtProducts();
  /// Failures and replacements of steps.
  void LookAtSteps();
  void LookAtTouch(const StudyTouchReading& reading);
  void LookAtReplay();

  ///@{ What is done again is told again.
  void Forget() { this->Told.clear(); }
  void ForgetVolumes() { this->Told.erase(SceneStep::Volume); }
  void ForgetStructures()
  {
    this->Told.erase(this->Told.upper_bound(SceneStep::Volume), this->Told.end());
  }
  void ForgetTouch() { this->ToldOfTouch.clear(); }
  void ForgetReplay() { this->ToldOfReplay.clear(); }
  ///@}

private:
  void LookAtVolume(int id);
  void LookAtProtection();
  template <typename Image>
  void TellNotes(SceneStep step, const std::shared_ptr<const Image>& image,
                 std::weak_ptr<const Image>& noted);
  void TellOnce(SceneStep step, const std::string& message);
  void TellOnce(const std::string& problem, std::string& told);

  Study& Open;
  std::function<void(const std::string& message)> Tell;
  std::map<SceneStep, std::set<std::string>> Told;
  std::map<int, std::weak_ptr<const Volume>> NotedVolumes; ///< whose notes were told
  std::weak_ptr<const Segmentation> NotedLabels;
  std::string ToldOfTouch;
  std::string ToldOfReplay;
};
} // namespace palpate
