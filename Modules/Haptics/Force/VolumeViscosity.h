#pragma once

#include "ContactForce.h"
#include "Vector3.h"

namespace palpate
{
/// Force inside a structure: F = -c v (N), for a viscosity c (N s/mm) and the hand's velocity v
/// (mm/s), while the tool's centre is inside. For soft structures: stiff ones do not let it in. It
/// never generates energy in continuous time; held from tick to tick it acts like a contact's
/// damping, with the same bound (StiffnessAdvice).
///
/// `centerDepth` (mm, in the frame of the offset) is the contact's depth at which the centre
/// enters.
Vector3 VolumeViscosity(double viscosity, const ContactOffset& contact, double centerDepth,
                        const Vector3& velocity) noexcept;
} // namespace palpate
