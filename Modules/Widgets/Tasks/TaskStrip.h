#pragma once

#include "TrialActivity.h"

#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace palpate
{
/// A strip over the views during a trial: which one, the time, what ends it, and the controls of
/// its activity.
class TaskStrip : public QFrame
{
  Q_OBJECT

public:
  explicit TaskStrip(QWidget* parent);

  /// Takes the place of the former activity, which is deleted; null: none.
  void Show(const QString& progress, TrialActivity* activity);
  void ShowTime(const QString& text);
  /// Whether the trial runs, so that it can be answered.
  void Enable(bool isRunning);

Q_SIGNALS:
  void NextAsked();
  void PauseAsked();
  void StopAsked();

private:
  QPushButton* AddButton(const QString& text, const char* name, void (TaskStrip::*asked)());

  QLabel* Progress;
  QLabel* Time;
  QVBoxLayout* Column;
  QPushButton* Next;
  TrialActivity* Activity = nullptr;
};
} // namespace palpate
