#pragma once

#include "StudyController.h"

#include <QElapsedTimer>
#include <QToolButton>
#include <QWidget>

namespace palpate
{
/// The pipeline from files to touch in one line of fixed height: "Ready", or what runs, how many of
/// how many, and since when, with a button that stops it. A click opens all steps.
class PipelineLine : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the address.
  explicit PipelineLine(StudyController& study, QWidget* parent = nullptr);

  QString Text() const { return this->Line->text(); }

private:
  void Show();
  void ShowText(const QString& text, const QString& tip);
  void ShowRunning(SceneStep step, const StudyStepState& state);
  void Offer(const QString& text, SceneStep step, bool isResume);
  void OpenDetails();
  void Act();

  StudyController& Study;
  QToolButton* Line;
  QToolButton* Button;
  QWidget* Details;
  QElapsedTimer Since; ///< the first of the steps that run now
  SceneStep Offered = SceneStep::Volume;
  bool Resumes = false;
};
} // namespace palpate
