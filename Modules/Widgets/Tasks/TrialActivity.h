#pragma once

#include "CorrectionLink.h"
#include "DrawingLink.h"
#include "MatchingLink.h"
#include "StudyController.h"
#include "TaskConduct.h"
#include "TaskSettings.h"
#include "TaskWatch.h"
#include "ViewContents.h"

#include <QWidget>

namespace palpate
{
/// What an activity works with; all of it outlives the activity.
struct TrialPlace
{
  StudyController& Study;
  ViewContents& Contents;
  DrawingLink& Drawing;
  CorrectionLink& Correcting;
  MatchingLink& Matching;
  const TaskTarget& Target;
  bool HasForce;
};

/// What a participant does in a trial of one kind: what the views show for it, its controls in the
/// strip over them, and its answer.
class TrialActivity : public QWidget
{
  Q_OBJECT

public:
  using QWidget::QWidget;

  /// The trial has begun.
  virtual void Begin() = 0;
  /// After each poll of the trial, which `watch` has followed.
  virtual void Take(const TouchState& newest, TaskWatch& watch) = 0;
  /// Otherwise the trial is given up.
  virtual bool HasAnswer() const = 0;
  /// Throws InputError if its files cannot be read any more.
  virtual TaskAnswer Answer() const = 0;
  /// Whether the trial ends by itself.
  virtual bool IsDone() const { return false; }
};

/// A child of `strip`. To add a kind, add its activity to the table in the source file.
TrialActivity* MakeTrialActivity(TaskKind kind, const TrialPlace& place, QWidget* strip);
} // namespace palpate
