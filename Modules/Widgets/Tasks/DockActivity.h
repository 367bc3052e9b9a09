#pragma once

#include "TrialActivity.h"

#include <QPushButton>

namespace palpate
{
/// A body is held, by the pointer or at the tool, and brought to another one. Let go, it stays
/// where it is.
class DockActivity : public TrialActivity
{
  Q_OBJECT

public:
  DockActivity(const TrialPlace& place, QWidget* strip);
  ~DockActivity() override;

  void Begin() override;
  void Take(const TouchState& newest, TaskWatch& watch) override;
  bool HasAnswer() const override;
  TaskAnswer Answer() const override;

private:
  StudyController& Study;
  ViewContents& Contents;
  MatchingLink& Matching;
  const TaskTarget& Target;
  const HoldRules Before; ///< of the mode, from before the trial
  QPushButton* Hold;
  QPushButton* Back;
};
} // namespace palpate
