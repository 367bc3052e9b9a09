#pragma once

#include "TrialActivity.h"

#include <QPushButton>

namespace palpate
{
/// A mask is corrected by pulls at its surface; the answer is how well it agrees with the true one.
class MaskActivity : public TrialActivity
{
  Q_OBJECT

public:
  MaskActivity(const TrialPlace& place, QWidget* strip);
  ~MaskActivity() override;

  void Begin() override;
  void Take(const TouchState& newest, TaskWatch& watch) override;
  bool HasAnswer() const override { return !this->Study.State().Correction.Steps.empty(); }
  TaskAnswer Answer() const override;

private:
  StudyController& Study;
  CorrectionLink& Correcting;
  const TaskTarget& Target;
  QPushButton* Back;
};
} // namespace palpate
