#pragma once

#include "PalpateStudyModule.h"
#include "StudyState.h"

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <string>

namespace palpate
{
/// Undo history of a study. States are small, so each step holds a whole state; products are kept
/// elsewhere. Changes of the view (StudyState::View) are not steps: the view stays when steps are
/// undone.
class PALPATESTUDY_EXPORT StudyHistory
{
public:
  explicit StudyHistory(StudyState first = {}, std::size_t mostSteps = 200);

  const StudyState& Current() const { return this->Now; }

  /// Makes `next` the current state, as a step named `message` ("Change the degree to 14"); undone
  /// steps are discarded. Consecutive changes with the same `gesture`, such as those of one slider,
  /// become one step, until EndGesture. Returns false if nothing differs.
  bool Change(const std::string& message, const StudyState& next, const std::string& gesture = {});
  /// Adds consequences of the last step to it; they are undone and redone with it, and are no
  /// change of their own.
  void Amend(const StudyState& next);
  /// Ends a gesture: the next change is a separate step.
  void EndGesture() { this->Gesture.clear(); }
  /// Changes the view without a step.
  void ChangeView(const StudyView& view) { this->Now.View = view; }
  /// Starts over with another study.
  void Reset(const StudyState& first);

  bool CanUndo() const { return !this->Past.empty(); }
  bool CanRedo() const { return !this->Future.empty(); }
  /// The name of the step to undo or redo; may be empty.
  std::string UndoText() const { return this->CanUndo() ? this->Past.back().Message : ""; }
  std::string RedoText() const { return this->CanRedo() ? this->Future.back().Message : ""; }
  bool Undo();
  bool Redo();

  /// Marks the current state as saved.
  void MarkSaved() { this->Saved = this->Now; }
  /// No state counts as saved until MarkSaved, not even this one.
  void MarkUnsaved() { this->Saved.reset(); }
  /// Whether there are unsaved changes, not counting the view.
  bool IsChanged() const;

private:
  // A step's name, and the state before it (Past) or after it (Future).
  struct Step
  {
    std::string Message;
    std::shared_ptr<const StudyState> State;
  };
  void Swap(std::deque<Step>& from, std::deque<Step>& to);

  StudyState Now;
  std::optional<StudyState> Saved; ///< none: nothing was saved
  std::deque<Step> Past;           ///< oldest first
  std::deque<Step> Future;         ///< next step last
  std::size_t MostSteps;
  std::string Gesture; ///< of the last step
};
} // namespace palpate
