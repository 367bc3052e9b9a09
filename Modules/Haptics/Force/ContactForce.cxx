#include "ContactForce.h"

#include <algorithm>

namespace palpate
{
Vector3 ContactForce(const ContactLaw& law, const ContactOffset& contact) noexcept
{
  if (!contact.IsTouching)
  {
    return Vector3::Zero();
  }
  const Vector3 spring = contact.IsElastic ? contact.Push : Vector3(law.Stiffness * contact.Offset);
  const double resistance =
      law.Damping + (contact.IsElastic ? law.Relaxation * contact.Slope : 0.0);
  const double damping = resistance * contact.Velocity.dot(contact.Normal);
  return spring + std::max(damping, -spring.dot(contact.Normal)) * contact.Normal;
}
} // namespace palpate
