#pragma once

#include "ForceEffect.h"

namespace palpate
{
/// Viscosity inside a structure: F = -c v (N), for a viscosity c (N s/mm) and the hand's velocity v
/// (mm/s), while the tool's centre is inside. Meant for structures that are not stiff: others do
/// not let it in. It never generates energy in continuous time; held from tick to tick it is a
/// damping like a contact's own, and has the same bound (StiffnessAdvice).
class VolumeViscosity final : public ForceEffect
{
public:
  explicit VolumeViscosity(double viscosity) : Viscosity(viscosity) {}

  Vector3 Force(const EffectTouch& touch) const noexcept override;
  double Damping() const noexcept override { return this->Viscosity; }
  Status Check() const override;

private:
  double Viscosity; // N s/mm
};
} // namespace palpate
