#pragma once

#include "StudyPipeline.h"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

class QGridLayout;

namespace palpate
{
/// A step of the pipeline as a row of a table: its status as a sign and a word, its progress, and a
/// button that cancels or repeats it.
class StepRow : public QObject
{
  Q_OBJECT

public:
  StepRow(SceneStep step, QGridLayout* table, int row, QWidget* parent);

  void Show(const StudyStepState& state);
  /// The status in a word.
  QString Word() const { return this->State->text(); }

Q_SIGNALS:
  void CancelAsked(SceneStep step);
  void RepeatAsked(SceneStep step);

private:
  void Press();

  SceneStep Step;
  QLabel* Sign;
  QLabel* State;
  QProgressBar* Progress;
  QPushButton* Button;
  QLabel* Name;
  StudyStepState::Kind Shown = StudyStepState::Kind::NotWanted;
};
} // namespace palpate
