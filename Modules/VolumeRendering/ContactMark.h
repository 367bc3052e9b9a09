#pragma once

#include "Vector3.h"

#include <algorithm>

namespace palpate
{
/// A place of the scene round which surfaces have another colour, such as where a tool touches.
struct ContactMark
{
  Vector3 PlaceWorld = Vector3::Zero(); ///< mm, in the scene
  double Radius = 0.0;                  ///< mm; 0 marks nothing
  double Strength = 1.0;                ///< of the colour where it is strongest, 0..1
  Vector3 Color = Vector3::Zero();      ///< 0..1

  bool IsSeen() const noexcept { return this->Radius > 0.0 && this->Strength > 0.0; }
  /// How much of the colour a point of a surface has, 0..1: Strength up to half the radius, then
  /// smoothly less up to the radius.
  double ShareAt(const Vector3& pointWorld) const noexcept
  {
    const double way = (pointWorld - this->PlaceWorld).norm() / this->Radius;
    const double outer = std::clamp(2.0 * way - 1.0, 0.0, 1.0);
    return this->Strength * (1.0 - outer * outer * (3.0 - 2.0 * outer));
  }
};

inline bool operator==(const ContactMark& a, const ContactMark& b)
{
  return a.PlaceWorld == b.PlaceWorld && a.Radius == b.Radius && a.Strength == b.Strength &&
         a.Color == b.Color;
}
} // namespace palpate
