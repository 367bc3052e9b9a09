#pragma once

#include "PalpateTaskModule.h"
#include "TaskConduct.h"
#include "TaskSettings.h"

#include <string>
#include <vector>

namespace palpate
{
/// How good an answer is: the kind's measures in the order of TaskMeasures, NaN for none.
struct TaskScore
{
  std::vector<double> Values;
  bool IsSuccess = false; ///< within the target's tolerances, and ended by the participant
};

/// Names of a kind's measures, with their units.
PALPATETASK_EXPORT const std::vector<std::string>& TaskMeasures(TaskKind kind);

/// The column that studies of this kind compare: "success" or one of the measures.
PALPATETASK_EXPORT const std::string& PrimaryMeasure(TaskKind kind);

/// Compares an answer with the target's truth:
/// - nodule: distance of the reported point from the one above the nodule, across the side that is
///   palpated, since the tool is pressed in; diameter minus the true one; a success is also to
///   report none where there is none;
/// - landmarks: mean and largest distance of those that were marked, and how many were not;
/// - outline: Dice of the areas, mean distance of the contours (both ways), in the truth's plane;
/// - mask: Dice and mean distance as the answer has them;
/// - dock: distance of the body's centre and angle from its place;
/// - path: contacts with walls and their time (of the conduct), mean distance of the tool from the
///   path, share of it that was passed within the tolerance in order.
PALPATETASK_EXPORT TaskScore ScoreOf(TaskKind kind, const TaskTarget& target,
                                     const TaskAnswer& answer, const TaskConduct& conduct);

/// Mean distance (mm) of the points along a polyline, a millimetre or less apart, from another one;
/// closed: back to its start.
PALPATETASK_EXPORT double MeanLineDistance(const std::vector<Vector3>& from,
                                           const std::vector<Vector3>& to, bool isClosed);
} // namespace palpate
