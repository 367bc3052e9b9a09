#pragma once

#include "PalpateTaskModule.h"
#include "Progress.h"
#include "TaskSettings.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace palpate
{
/// Simulated hands that take part in a study.
struct TaskSimulation
{
  int Participants = 12;
  std::string Level = "novice"; ///< see HandSkill::Levels
  std::uint64_t Seed = 1;       ///< equal seeds give equal logs
};

/// Simulates every trial of every participant by the servo, in virtual time, and writes their logs
/// (TaskRun) into an existing folder; resumes those that are there. Throws InputError for
/// scenes that cannot be touched and logs of something else, FilterError
/// and Cancelled.
PALPATETASK_EXPORT void SimulateTask(const TaskSettings& task, const TaskSimulation& simulation,
                                     const std::filesystem::path& folder,
                                     const ProgressFunction& progress);
} // namespace palpate
