#include "FadingContact.h"

namespace palpate
{
FadingContact::FadingContact(const Vector3& force, const Vector3& normal, double stiffness,
                             const Vector3& hand) noexcept
    : Progress(HandoverDuration), Weight(1.0), Push(force.dot(normal)), Stiffness(stiffness),
      Normal(normal), Hand(hand)
{
  // Along a surface there is at most friction. If two joined contacts push almost against each
  // other, the wall is normal to their sum.
  constexpr double Steepest = 0.5;
  if (!this->IsOver() && this->Push < Steepest * force.norm())
  {
    this->Push = force.norm();
    this->Normal = force / this->Push;
  }
  if (!this->IsOver())
  {
    this->Slip = (force - this->Push * this->Normal) / this->Push;
  }
}

Vector3 FadingContact::Force() const noexcept
{
  return this->IsOver() ? Vector3::Zero()
                        : Vector3(this->Weight * this->Push * (this->Normal + this->Slip));
}

FadingContact FadingContact::Joined(const FadingContact& one, const FadingContact& other) noexcept
{
  if (one.IsOver() || other.IsOver())
  {
    const FadingContact& only = one.IsOver() ? other : one;
    return {only.Force(), only.Normal, only.Weight * only.Stiffness, only.Hand};
  }
  const Vector3 out = one.Weight * one.Push * one.Normal + other.Weight * other.Push * other.Normal;
  return {one.Force() + other.Force(), out.normalized(),
          one.Weight * one.Stiffness + other.Weight * other.Stiffness, other.Hand};
}

Vector3 FadingContact::Advance(const Vector3& hand, double passed) noexcept
{
  if (this->IsOver())
  {
    return Vector3::Zero();
  }
  this->Weight = 1.0 - this->Progress.Advance(passed);
  this->Push += this->Stiffness * this->Normal.dot(this->Hand - hand);
  this->Hand = hand;
  if (this->IsOver() || !this->Progress.IsRamping())
  {
    this->Push = 0.0;
  }
  return this->Force();
}
} // namespace palpate
