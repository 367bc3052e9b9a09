#pragma once

#include "TaskPower.h"
#include "TaskResults.h"
#include "TaskSettings.h"

#include <filesystem>
#include <string>

namespace palpate::cli
{
/// What a task asks for, with the number of participants that balances its order.
std::string TaskSummaryText(const TaskSettings& task);
std::string TaskSummaryJson(const TaskSettings& task);

/// The plans of participants 1 to `participants`: a line a trial, and a JSON object of all.
std::string TaskPlanText(const TaskSettings& task, int participants);
std::string TaskPlanJson(const TaskSettings& task, int participants);

/// Means of both conditions, and how many participants suffice.
std::string TaskResultsText(const TaskResults& results, const TaskComparison& comparison);
std::string TaskResultsJson(const TaskResults& results, const TaskComparison& comparison);
} // namespace palpate::cli
