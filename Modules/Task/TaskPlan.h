#pragma once

#include "PalpateTaskModule.h"
#include "TaskSettings.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// One trial of a plan.
struct TaskTrial
{
  int Number = 1; ///< from 1, training included
  bool IsTraining = false;
  std::size_t Condition = 0;
  std::size_t Target = 0;
  bool EndsBlock = false; ///< a pause is due after it, unless it is the last
};

/// Rows of a Latin square of `count` >= 1 conditions (from 0), one row a participant: each
/// condition is once in each column, and each follows each other one equally often, which balances
/// what is carried over from one to the next. `count` rows if it is even or 1; else two squares of
/// together 2 `count` rows, the second reversed. Source: Williams, Experimental designs balanced
/// for the estimation of residual effects of treatments, Aust. J. Sci. Res. A 2 (1949) 149-168.
PALPATETASK_EXPORT std::vector<std::vector<int>> WilliamsRows(int count);

/// Largest number of a participant, counted from 1.
constexpr int MostParticipants = 9999;

/// The trials of a participant: conditions one after the other, in the order of WilliamsRows; in
/// each the training trials, then the others. Targets come in a random order that depends on the
/// task's seed and the participant only, none again before all have been used.
PALPATETASK_EXPORT std::vector<TaskTrial> PlanOf(const TaskSettings& task, int participant);
} // namespace palpate
