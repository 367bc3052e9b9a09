#pragma once

#include "SceneEffect.h"

namespace palpate
{
/// Adhesion: a touched structure pulls the tool towards it with a constant force (N).
class SampleEffect final : public ForceEffect
{
public:
  explicit SampleEffect(double pull) : Pull(pull) {}

  /// Its kind, for registration.
  static SceneEffectKind Kind();

  Vector3 Force(const EffectTouch& touch) const noexcept override
  {
    return touch.Contact.IsTouching ? Vector3(-this->Pull * touch.Contact.Normal) : Vector3::Zero();
  }

private:
  double Pull; // N
};
} // namespace palpate
