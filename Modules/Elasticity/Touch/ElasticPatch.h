#pragma once

#include "BallContact.h"
#include "ComplianceAtlas.h"
#include "ElasticForce.h"
#include "SurfaceCurvature.h"
#include "Vector3.h"

namespace palpate
{
class RadialModel;

/// One place of an elastic organ into which a ball is pressed.
class ElasticPatch
{
public:
  ElasticPatch() = default;
  /// At the nearest point of the model's surface to the ball's centre, in the unit vector
  /// `direction` from the model's; `depth` (mm) of the ball there. Does not allocate.
  ElasticPatch(const ComplianceAtlas& atlas, const RadialModel& model, const Vector3& direction,
               double depth, double ballRadius) noexcept;

  /// Solves the contact at a depth (mm), which is less than the ball's where another patch has
  /// moved the place. `start` as in BallContact.
  void Press(double depth, double start) noexcept;
  const BallContact& Contact() const noexcept { return this->Pressed; }

  /// The force on a ball that this place alone holds: along the normal, and minus the slope of the
  /// energy along the surface, on which the place moves with the ball.
  ElasticForce Force() const noexcept;
  /// The force on a ball that does not move along the surface, since other places hold it too.
  ElasticForce ForceOfHeldBall() const noexcept;

  /// Slope (N) of the energy by the patch's place on the surface at the same depth, tangent. Fades
  /// out where the ball is about as round as the hollow.
  Vector3 EnergySlope() const noexcept;
  /// Of Softness, mm/N.
  Vector3 SoftnessSlope(double radius) const noexcept;
  /// How a vector of the tangent plane changes the normal: by the shape operator, 1/mm.
  Vector3 Bent(const Vector3& tangent) const noexcept;
  /// How far (mm) the nearest point moves for a motion of a place at this distance (mm) from it.
  Vector3 Followed(const Vector3& motion, double distance) const noexcept;

  double Depth() const noexcept { return this->Deep; }
  const Vector3& Point() const noexcept { return this->Foot; } ///< mm, from the model's centre
  const Vector3& Normal() const noexcept { return this->Outward; }
  /// a c(a) (mm^2/N) for a patch of this radius (mm) or the largest.
  double Softness(double radius) const noexcept;

private:
  Vector3 OnSurface(const Vector3& slope) const noexcept;
  double Openness() const noexcept;

  ComplianceAtlas::Place Place{};
  SurfaceCurvature Curvature{};
  Vector3 Direction = Vector3::UnitZ();
  Vector3 Foot = Vector3::Zero();
  Vector3 Outward = Vector3::UnitZ();
  double Deep = 0.0;          // mm
  double Ball = 0.0;          // its radius, mm
  double SurfaceRadius = 0.0; // of the organ there, mm
  double Bend = 0.0;          // mean curvature that the contact has, 1/mm
  BallContact Pressed{};
};
} // namespace palpate
