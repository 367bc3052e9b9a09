#pragma once

#include "PalpateTaskModule.h"
#include "TaskConduct.h"
#include "TaskParticipant.h"
#include "TaskPlan.h"
#include "TaskScore.h"
#include "TaskSettings.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// The first line of a log: what was begun, and by whom.
struct TaskBeginning
{
  std::string TaskId;
  std::string Digest; ///< see TaskDigest
  TaskKind Kind = TaskKind::Landmarks;
  std::vector<std::string> Conditions; ///< ids, in the task's order
  TaskParticipant Participant;
};

/// Any other line of a log.
struct TaskEvent
{
  enum class Kind
  {
    Start,
    End,
    Pause,
    Resume
  };
  Kind Is = Kind::Start;
  int Trial = 0;   ///< of a start or end, from 1
  int Attempt = 0; ///< of these, from 1
  bool IsTraining = false;
  std::string Condition;
  std::string Target;
  TaskConduct Conduct; ///< of an end
  TaskScore Score;     ///< of an end
};

PALPATETASK_EXPORT std::string TaskBeginLine(const TaskSettings& task,
                                             const TaskParticipant& participant);
PALPATETASK_EXPORT std::string TaskStartLine(const TaskSettings& task, const TaskTrial& trial,
                                             int attempt);
/// With the answer, so that trials can be scored again.
PALPATETASK_EXPORT std::string TaskEndLine(const TaskSettings& task, const TaskTrial& trial,
                                           int attempt, const TaskAnswer& answer,
                                           const TaskConduct& conduct, const TaskScore& score);
PALPATETASK_EXPORT std::string TaskPauseLine(bool begins);

/// Each throws InputError, naming the file and the line, for what is not such a line.
PALPATETASK_EXPORT TaskBeginning ReadTaskBeginning(const std::string& line,
                                                   const std::filesystem::path& path);
PALPATETASK_EXPORT TaskEvent ReadTaskEvent(const std::string& line,
                                           const std::filesystem::path& path, std::size_t number,
                                           TaskKind kind);

/// "done", "time", "force", "given-up".
PALPATETASK_EXPORT const char* NameOf(TaskEnd end);
} // namespace palpate
