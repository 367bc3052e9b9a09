#pragma once

#include "Vector3.h"

namespace palpate
{
/// What a hand feels of a tool that is held up: N, and N mm about the tool's origin.
struct ToolWrench
{
  Vector3 Force = Vector3::Zero();
  Vector3 Torque = Vector3::Zero();
};
} // namespace palpate
