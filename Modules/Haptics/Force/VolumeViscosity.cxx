#include "VolumeViscosity.h"

#include <cmath>

namespace palpate
{
Vector3 VolumeViscosity::Force(const EffectTouch& touch) const noexcept
{
  const ContactOffset& contact = touch.Contact;
  const bool isInside =
      contact.IsTouching && contact.Offset.dot(contact.Normal) > touch.CenterDepth;
  return isInside ? Vector3(-this->Viscosity * touch.HandVelocity) : Vector3::Zero();
}

Status VolumeViscosity::Check() const
{
  return this->Viscosity >= 0.0 && std::isfinite(this->Viscosity)
             ? Status::Success()
             : Status::Failure("its viscosity must be finite and not negative.");
}
} // namespace palpate
