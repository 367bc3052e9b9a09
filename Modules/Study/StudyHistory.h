#pragma once

#include "PalpateStudyModule.h"
#include "StudyState.h"

#include <cstddef>
#include <deque>
#include <memory>
#include <string>

namespace palpate
{
/// A study's states, one a step, to go back and forth in. A state is small, so steps are whole
/// states; what is computed from them lies elsewhere. Where one looks (StudyState::View) is no
/// step: it stays when others are undone.
class PALPATESTUDY_EXPORT StudyHistory
{
public:
  explicit StudyHistory(StudyState first = {}, std::size_t mostSteps = 200);

  const StudyState& Current() const { return this->Now; }

  /// Makes `next` the current state, as a step that `sentence` names ("Change the degree to 14");
  /// steps that were undone are gone. Changes that follow each other with the same `gesture`, such
  /// as those of one slider, become one step, until EndGesture. False where nothing is different.
  bool Change(const std::string& sentence, const StudyState& next, const std::string& gesture = {});
  /// What follows from the last step by itself, and goes and comes with it.
  void Amend(const StudyState& next) { this->Now = next; }
  /// The slider was let go: the next change is a step of its own.
  void EndGesture() { this->Gesture.clear(); }
  /// Looks elsewhere.
  void ChangeView(const StudyView& view) { this->Now.View = view; }
  /// Begins anew with another study.
  void Reset(const StudyState& first);

  bool CanUndo() const { return !this->Past.empty(); }
  bool CanRedo() const { return !this->Future.empty(); }
  /// The sentence of the step that would be taken back, or again; empty where there is none.
  std::string UndoText() const { return this->CanUndo() ? this->Past.back().Sentence : ""; }
  std::string RedoText() const { return this->CanRedo() ? this->Future.back().Sentence : ""; }
  bool Undo();
  bool Redo();

  /// The current state is that of the file.
  void MarkSaved() { this->Saved = this->Now; }
  /// There is something to be saved; looking elsewhere is nothing.
  bool IsChanged() const;

private:
  // The state that a step left, or comes to.
  struct Step
  {
    std::string Sentence;
    std::shared_ptr<const StudyState> State;
  };
  void Swap(std::deque<Step>& from, std::deque<Step>& to);

  StudyState Now;
  StudyState Saved;
  std::deque<Step> Past;   ///< oldest first
  std::deque<Step> Future; ///< next one last
  std::size_t MostSteps;
  std::string Gesture; ///< of the last step
};
} // namespace palpate
