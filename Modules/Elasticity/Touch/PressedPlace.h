#pragma once

#include "Vector3.h"

namespace palpate
{
/// A place of an elastic organ that a ball presses with a Hertz bump.
struct PressedPlace
{
  Vector3 Direction = Vector3::UnitZ(); ///< unit, from the model's centre
  double Force = 0.0;                   ///< along the surface's normal there, N
  double PatchRadius = 0.0;             ///< of the bump, mm
};
} // namespace palpate
