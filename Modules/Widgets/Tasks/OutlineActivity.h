#pragma once

#include "TrialActivity.h"

#include <QPushButton>

namespace palpate
{
/// An organ is drawn by touch; its outline is where the drawn surface meets the target's plane.
class OutlineActivity : public TrialActivity
{
  Q_OBJECT

public:
  OutlineActivity(const TrialPlace& place, QWidget* strip);
  ~OutlineActivity() override;

  void Begin() override;
  void Take(const TouchState& newest, TaskWatch& watch) override;
  bool HasAnswer() const override { return !this->Answer().PointsWorld.empty(); }
  TaskAnswer Answer() const override;

private:
  StudyController& Study;
  ViewContents& Contents;
  DrawingLink& Drawing;
  const TaskTarget& Target;
  QPushButton* Back;
};
} // namespace palpate
