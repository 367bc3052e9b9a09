#pragma once

#include "StudyController.h"

#include <QLabel>
#include <QObject>
#include <QPushButton>
#include <QString>
#include <QTimer>

#include <functional>
#include <optional>

namespace palpate
{
/// A job that the button of a panel starts and, while it runs, cancels; a line of the panel has its
/// progress and its outcome.
class PanelJob : public QObject
{
  Q_OBJECT

public:
  /// Runs on the study's worker; what it returns is called in the window's thread and ends by End.
  using Work = std::function<StudyJob::Delivery(const ProgressFunction& progress)>;

  /// Keeps the addresses. The button has its text while nothing runs.
  PanelJob(StudyController& study, QPushButton* button, QLabel* line, QObject* parent);
  /// Cancels the job.
  ~PanelJob() override;

  bool IsRunning() const { return this->Job.has_value(); }
  void Run(Work work);
  /// Nothing runs any more; the line says so.
  void End(const QString& text);

Q_SIGNALS:
  void Asked();   ///< the button was pressed while nothing runs
  void Changed(); ///< began or ended

private:
  void Press();
  void ShowProgress();

  StudyController& Study;
  QPushButton* Button;
  QLabel* Line;
  QString Verb; ///< the button's text
  QTimer Watch;
  std::optional<StudyJobs::Id> Job;
};
} // namespace palpate
