#pragma once

#include "FalconPackets.h"
#include "Vector3.h"

namespace palpate
{
/// Largest magnitude of a motor value.
constexpr double LargestMotorValue = 4095.0;

/// Motor values for torques at the thighs (N mm); a positive value turns a thigh inwards, where its
/// angle decreases. If one exceeds the limit all three are scaled together, which keeps the force's
/// direction; a value that wrapped round would pull the other way. NaN becomes 0.
FalconNumbers MotorValuesFor(const Vector3& torques, double countsPerNewtonMillimeter) noexcept;
} // namespace palpate
