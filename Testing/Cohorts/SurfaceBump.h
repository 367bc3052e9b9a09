#pragma once

#include "RadialModel.h"
#include "Vector3.h"

namespace palpate::test
{
/// A bump of the mean shape: at the distance d from its place (mm, straight) the surface lies
/// height cos^2(pi d / extent) further out along the normal, up to half the extent. Bodies get it
/// along their radii, at equal directions from their centres, so that it is one linear effect.
class SurfaceBump
{
public:
  /// `mean` has its centre at the origin; `place` is a unit vector; height and extent are in mm.
  SurfaceBump(RadialModel mean, const Vector3& place, double height, double extent);

  const Vector3& Place() const { return this->Direction; }
  double Height() const { return this->Peak; }
  /// Whether the bump reaches this direction, also if its height is 0.
  bool Covers(const Vector3& direction) const;
  double AlongNormal(const Vector3& direction) const; ///< of the mean, mm
  double AlongRadius(const Vector3& direction) const; ///< mm

private:
  double DistanceOf(const Vector3& direction) const;

  RadialModel Mean;
  Vector3 Direction;
  Vector3 PlacePoint;
  double Peak;
  double Width;
};
} // namespace palpate::test
