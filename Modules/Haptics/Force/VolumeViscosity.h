#pragma once

#include "ContactForce.h"
#include "Vector3.h"

namespace palpate
{
/// What a tool feels that is inside a structure: F = -c v (N), for a viscosity c (N s/mm) and the
/// hand's velocity v (mm/s), while the tool's centre is inside. Meant for structures that are not
/// stiff: others do not let it in. It never gives out energy at any one moment; held from tick to
/// tick it is a damping like a contact's own, and has the same bound (StiffnessAdvice).
///
/// `centerDepth` (mm, in the frame of the offset) is how deep a contact is where the centre enters.
Vector3 VolumeViscosity(double viscosity, const ContactOffset& contact, double centerDepth,
                        const Vector3& velocity) noexcept;
} // namespace palpate
