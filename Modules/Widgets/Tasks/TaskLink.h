#pragma once

#include "CorrectionLink.h"
#include "DrawingLink.h"
#include "FileQuestions.h"
#include "MatchingLink.h"
#include "StudyController.h"
#include "TaskForm.h"
#include "TaskPage.h"
#include "TaskRun.h"
#include "TaskStrip.h"
#include "TaskWatch.h"
#include "ViewContents.h"
#include "ViewGrid.h"

#include <QObject>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

namespace palpate
{
/// The parts of a window that a task works with.
struct TaskSurroundings
{
  StudyController& Study;
  const FileQuestions& Questions;
  ViewContents& Contents;
  ViewGrid& Views;
  DrawingLink& Drawing;
  CorrectionLink& Correcting;
  MatchingLink& Matching;
  std::function<void(bool isOn)> ShowHandOnly; ///< see TouchLink
  std::function<bool()> MayLeave;              ///< asks whether to save what is open
};

/// Runs a task in the window: asks who does it, shows the instructions between trials, prepares a
/// trial's scene, applies its condition, measures and records it, and ends it with its answer.
/// Order, log and scores are those of TaskRun. A trial that anything interrupts, be it Escape, a
/// device that fails or the end of the program, begins again.
class TaskLink : public QObject
{
  Q_OBJECT

public:
  /// Belongs to the widget that its page and its strip are in.
  TaskLink(const TaskSurroundings& around, QWidget* parent);
  ~TaskLink() override;

  /// In place of the views between trials; over the views during one.
  TaskPage* Page() const { return this->Between; }
  TaskStrip* Strip() const { return this->Over; }
  /// Whether a task is open.
  bool IsOpen() const { return this->Run != nullptr; }
  /// Whether the page is to be seen instead of the views.
  bool IsResting() const { return this->Now == Phase::Resting; }

  /// Asks for a task's file, and then who does it.
  void AskForTask();
  /// The same with a ready task, which is made in a folder unless the folder has it.
  void OpenReady(TaskKind kind);
  void Open(const std::filesystem::path& file);
  /// Interrupts a trial, if one runs.
  void Interrupt(const QString& why);

Q_SIGNALS:
  void Changed(); ///< IsOpen or IsResting

private:
  enum class Phase
  {
    Closed,
    Resting,   ///< between trials
    Preparing, ///< until the scene can be touched
    Opening,   ///< until the device is
    Arming,    ///< until force is as the condition has it
    Running
  };

  void MakeReady(TaskKind kind, const std::filesystem::path& folder);
  void Begin(const TaskSettings& task, TaskForm& form);
  void Rest(const QString& told);
  void ShowPage();
  void ShowPause();
  void ReadTrial();
  void CancelJob();
  void Pause();
  void Start();
  void Stop();
  void FollowSteps();
  void FollowTouch();
  void FollowTicks();
  bool HasCondition() const;
  void BeginTrial();
  void EndTrial();
  void ShowTime();
  void WriteResults();
  void Finish(const QString& text);
  QString ProgressText() const;
  const TaskTarget& Target() const { return this->Task.Targets[this->Run->Trial()->Target]; }
  const TaskCondition& Condition() const
  {
    return this->Task.Conditions[this->Run->Trial()->Condition];
  }

  TaskSurroundings Around;
  StudyController& Study;
  TaskPage* Between;
  TaskStrip* Over;
  TaskSettings Task;
  std::unique_ptr<TaskRun> Run;
  std::filesystem::path Folder; ///< of the results
  std::string Device;
  int Participant = 1; ///< its number
  Phase Now = Phase::Closed;
  QString Told;              ///< of the trial before, may be empty
  std::int64_t PausedAt = 0; ///< ns
  std::optional<StudyJobs::Id> Job;
  bool IsRead = false; ///< the scene of the next trial
  TrialActivity* Activity = nullptr;
  std::optional<TaskWatch> Watch;
};
} // namespace palpate
