#pragma once

#include <Eigen/Core>

namespace palpate
{
/// A place on the side of an organ that an examiner can reach, mm from its middle along the
/// surface: to the patient's left, and upwards.
using FreePlace = Eigen::Vector2d;
} // namespace palpate
