#pragma once

#include "Vector3.h"

namespace palpate
{
/// How strongly a structure pushes back.
struct ContactLaw
{
  double Stiffness = 0.0; ///< k, N/mm
  double Damping = 0.0;   ///< d, N s/mm
};

/// Where a touched structure has the tool, beside where it is: what the law needs of a contact.
struct ContactOffset
{
  bool IsTouching = false;
  Vector3 Offset = Vector3::Zero();   ///< proxy less probe, mm
  Vector3 Normal = Vector3::UnitZ();  ///< unit, out of the structure
  Vector3 Velocity = Vector3::Zero(); ///< of the offset, mm/s
};

/// F = k (x_proxy - x_probe) + d (v_proxy - v_probe), in N, in the frame of the offset.
///
/// The damping acts along the normal only, since along the surface the proxy goes with the probe,
/// and resistance there is friction's. Together they never pull inwards: damping a hand that
/// retreats faster than the spring follows would feel sticky.
Vector3 ContactForce(const ContactLaw& law, const ContactOffset& contact) noexcept;
} // namespace palpate
