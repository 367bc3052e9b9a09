#include "StudyHistory.h"

#include <utility>

namespace palpate
{
namespace
{
StudyState WithView(const StudyState& state, const StudyView& view)
{
  StudyState same = state;
  same.View = view;
  return same;
}
} // namespace

StudyHistory::StudyHistory(StudyState first, std::size_t mostSteps)
    : Now(std::move(first)), Saved(Now), MostSteps(mostSteps)
{
}

bool StudyHistory::Change(const std::string& message, const StudyState& next,
                          const std::string& gesture)
{
  if (WithView(next, this->Now.View) == this->Now)
  {
    this->Now.View = next.View;
    return false;
  }
  const bool isSameGesture =
      !gesture.empty() && gesture == this->Gesture && this->CanUndo() && !this->CanRedo();
  if (isSameGesture && WithView(next, this->Past.back().State->View) == *this->Past.back().State)
  {
    this->Past.pop_back(); // back to the state before the gesture
  }
  else if (isSameGesture)
  {
    this->Past.back().Message = message;
  }
  else
  {
    this->Past.push_back({message, std::make_shared<const StudyState>(this->Now)});
  }
  if (this->Past.size() > this->MostSteps)
  {
    this->Past.pop_front();
  }
  this->Future.clear();
  this->Gesture = gesture;
  this->Now = next;
  return true;
}

void StudyHistory::Amend(const StudyState& next)
{
  const bool wasChanged = this->IsChanged();
  this->Now = next;
  if (!wasChanged)
  {
    this->MarkSaved();
  }
}

void StudyHistory::Reset(const StudyState& first)
{
  this->Now = first;
  this->Saved = first;
  this->Past.clear();
  this->Future.clear();
  this->Gesture.clear();
}

void StudyHistory::Swap(std::deque<Step>& from, std::deque<Step>& to)
{
  const Step step = std::move(from.back());
  from.pop_back();
  to.push_back({step.Message, std::make_shared<const StudyState>(this->Now)});
  this->Now = WithView(*step.State, this->Now.View);
  this->Gesture.clear();
}

bool StudyHistory::Undo()
{
  const bool can = this->CanUndo();
  if (can)
  {
    this->Swap(this->Past, this->Future);
  }
  return can;
}

bool StudyHistory::Redo()
{
  const bool can = this->CanRedo();
  if (can)
  {
    this->Swap(this->Future, this->Past);
  }
  return can;
}

bool StudyHistory::IsChanged() const
{
  return !this->Saved || WithView(*this->Saved, this->Now.View) != this->Now;
}
} // namespace palpate
