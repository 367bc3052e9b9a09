#pragma once

#include "Vector3.h"

namespace palpate
{
/// Stiffness and damping of a structure.
struct ContactLaw
{
  double Stiffness = 0.0;  ///< k, N/mm
  double Damping = 0.0;    ///< d, N s/mm
  double Relaxation = 0.0; ///< of a structure that yields, s
};

/// The part of a contact that the force law needs: the tool's position relative to the probe.
struct ContactOffset
{
  bool IsTouching = false;
  Vector3 Offset = Vector3::Zero();   ///< proxy minus probe, mm
  Vector3 Normal = Vector3::UnitZ();  ///< unit, out of the structure
  Vector3 Velocity = Vector3::Zero(); ///< of the offset, mm/s
  bool IsElastic = false;
  Vector3 Push = Vector3::Zero(); ///< of an elastic structure, instead of the spring's force, N
  double Slope = 0.0;             ///< of that push by the depth, N/mm
};

/// F = k (x_proxy - x_probe) + d (v_proxy - v_probe), in N, in the frame of the offset; of an
/// elastic structure its own push instead of the first term, and d plus the relaxation time times
/// the push's slope instead of d: tissue as Kelvin and Voigt's solid, whose stress is that of the
/// strain plus the relaxation time times its rate.
///
/// Damping acts along the normal only, since along the surface the proxy moves with the probe, and
/// friction resists there. The sum never pulls inwards: damping a hand that retreats faster than
/// the spring follows would feel sticky.
Vector3 ContactForce(const ContactLaw& law, const ContactOffset& contact) noexcept;
} // namespace palpate
