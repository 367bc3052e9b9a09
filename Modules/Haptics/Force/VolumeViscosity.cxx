#include "VolumeViscosity.h"

namespace palpate
{
Vector3 VolumeViscosity(double viscosity, const ContactOffset& contact, double centerDepth,
                        const Vector3& velocity) noexcept
{
  const bool isInside = contact.IsTouching && contact.Offset.dot(contact.Normal) > centerDepth;
  return isInside ? Vector3(-viscosity * velocity) : Vector3::Zero();
}
} // namespace palpate
