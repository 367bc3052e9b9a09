#pragma once

#include "PalpateTaskModule.h"
#include "TaskEvents.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// One trial that ended.
struct TaskResult
{
  std::size_t Participant = 0; ///< in TaskResults::Participants
  TaskEvent End;
  std::string Before; ///< condition of the trial before it, whose effect it may carry; may be empty
};

/// All logs of a folder: participants of one task.
struct TaskResults
{
  std::string TaskId;
  TaskKind Kind = TaskKind::Landmarks;
  std::vector<std::string> Conditions;
  bool IsSimulation = false;
  std::vector<TaskParticipant> Participants; ///< by number
  std::vector<TaskResult> Rows;              ///< by participant, then trial
  int Unfinished = 0;                        ///< trials that began and did not end
};

/// Throws InputError for a folder without logs, damaged ones, and logs of several tasks or of both
/// people and simulated hands.
PALPATETASK_EXPORT TaskResults ReadTaskResults(const std::filesystem::path& folder);

/// A table with one row a trial, every number in full precision; what was not measured is empty. A
/// simulation is marked in each row.
PALPATETASK_EXPORT std::string TaskResultsCsv(const TaskResults& results);

/// A script for R that reads results.csv beside it and compares the conditions: a linear mixed
/// model with random intercepts of participants and targets (lme4), without that package an
/// analysis of variance of the participants' means (aov).
PALPATETASK_EXPORT std::string TaskAnalysisScript(const TaskResults& results);

/// Writes results.csv and analysis.R, both or none. Throws InputError.
PALPATETASK_EXPORT void WriteTaskResults(const TaskResults& results,
                                         const std::filesystem::path& folder);

/// Column of a row: "success", or a measure; NaN for none.
PALPATETASK_EXPORT double ValueOf(const TaskResult& row, TaskKind kind, const std::string& measure);
} // namespace palpate
