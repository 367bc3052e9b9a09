#pragma once

#include "PalpateTaskModule.h"
#include "TaskLog.h"
#include "TaskParticipant.h"
#include "TaskPlan.h"
#include "TaskScore.h"
#include "TaskSettings.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
enum class TaskState
{
  Ready,   ///< for the next trial
  Running, ///< a trial
  Paused,
  Finished, ///< all trials are done
};

/// One participant's way through a task, from its plan to its results. Every step is on the disk
/// before its function returns; a run that ended in any way goes on from its log: trials that were
/// done stay done, one that was interrupted begins again as its next attempt.
///
///     Ready -> Running -> Ready, Paused or Finished;  Ready <-> Paused
///
/// A view drives it: it shows the trial, runs it with a TaskWatch, and ends it with an answer.
class PALPATETASK_EXPORT TaskRun
{
public:
  /// Begins or resumes. The log is participant-0001.jsonl in the folder (JSON Lines). Throws
  /// InputError if the folder cannot be written, a log is damaged or belongs to another task, and
  /// for answers that the task's questions do not allow. A resumed run keeps the answers of its
  /// beginning.
  TaskRun(const TaskSettings& task, const TaskParticipant& participant,
          const std::filesystem::path& folder);

  TaskState State() const { return this->Now; }
  const std::vector<TaskTrial>& Plan() const { return this->Trials; }
  /// The current or next trial; null when finished.
  const TaskTrial* Trial() const;
  /// How often it has begun, from 0.
  int Attempts() const { return this->Begun; }
  /// Whether the plan has a pause before it, which lasts TaskSettings::PauseSeconds at least.
  bool IsPauseDue() const;

  /// Each throws std::logic_error in a state that does not permit it.
  void Start();
  /// Scores and stores; the run is then paused if a pause is due.
  TaskScore End(const TaskAnswer& answer, const TaskConduct& conduct);
  /// Leaves the running trial without an end, as a crash does: it begins again as its next attempt.
  void Interrupt();
  void Pause();
  void Resume();

  static std::filesystem::path LogName(int participant);

private:
  void Replay(const std::filesystem::path& path, const TaskParticipant& participant);
  void Take(const std::string& line, const std::filesystem::path& path, std::size_t number);
  void Finish();
  void Require(TaskState state) const;

  TaskSettings Task;
  std::vector<TaskTrial> Trials;
  std::size_t Next = 0; // trial
  int Begun = 0;
  TaskState Now = TaskState::Ready;
  TaskLog Log;
};
} // namespace palpate
