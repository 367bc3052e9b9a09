#pragma once

#include "PalpateTaskModule.h"
#include "TaskSettings.h"

#include <Eigen/Geometry>

namespace palpate
{
/// The turn of a pose.
PALPATETASK_EXPORT Eigen::Quaterniond TurnOf(const TaskPose& pose);

///@{ A pose of a body with this centre as a map of the world (mm), and back, for maps that turn and
/// shift.
PALPATETASK_EXPORT Eigen::Affine3d MapOf(const TaskPose& pose, const Vector3& centerWorld);
PALPATETASK_EXPORT TaskPose PoseOf(const Eigen::Affine3d& map, const Vector3& centerWorld);
///@}
} // namespace palpate
