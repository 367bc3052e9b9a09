#pragma once

#include "SmoothStep.h"
#include "Vector3.h"

#include <algorithm>

namespace palpate
{
/// A place in the scene around which surfaces are coloured differently, such as a tool's contact.
struct ContactMark
{
  Vector3 PlaceWorld = Vector3::Zero(); ///< mm, in the scene
  double Radius = 0.0;                  ///< mm; 0 marks nothing
  double Strength = 1.0;                ///< maximum share of the colour, 0..1
  Vector3 Color = Vector3::Zero();      ///< 0..1

  bool IsSeen() const noexcept { return this->Radius > 0.0 && this->Strength > 0.0; }
  /// Share of the colour at a surface point, 0..1: Strength up to half the radius, then decreasing
  /// smoothly to 0 at the radius.
  double ShareAt(const Vector3& pointWorld) const noexcept
  {
    const double distance = (pointWorld - this->PlaceWorld).norm() / this->Radius;
    const double outer = std::clamp(2.0 * distance - 1.0, 0.0, 1.0);
    return this->Strength * (1.0 - SmoothStep(outer));
  }
};

inline bool operator==(const ContactMark& a, const ContactMark& b)
{
  return a.PlaceWorld == b.PlaceWorld && a.Radius == b.Radius && a.Strength == b.Strength &&
         a.Color == b.Color;
}
} // namespace palpate
