#pragma once

#include "FalconPackets.h"
#include "Vector3.h"

namespace palpate
{
/// What the motors take at most, either way.
constexpr double LargestMotorValue = 4095.0;

/// The motor values of torques at the thighs (N mm); a positive value turns a thigh inwards, where
/// its angle falls. Where one would be too large all three are made smaller together, which keeps
/// the force's direction; a value that wrapped round would pull the other way. What is no number is
/// 0.
FalconNumbers MotorValuesFor(const Vector3& torques, double countsPerNewtonMillimeter) noexcept;
} // namespace palpate
