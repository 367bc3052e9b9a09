#pragma once

#include "HeldFit.h"

#include <Eigen/Geometry>

namespace palpate
{
/// The pose of a surface that hangs on a pointing hand by a spring, so that it stays behind where
/// it does not want to go, and turns only as it is turned. Allocates nothing after it was made.
class HeldPose
{
public:
  /// Keeps the address. `spring` (N/mm, above 0) is between the hand and the surface.
  HeldPose(const HeldFit& fit, double spring, const Eigen::Affine3d& pose) noexcept
      : Fit(fit), Spring(spring), Now(pose), Hand(pose)
  {
  }

  const Eigen::Affine3d& Pose() const noexcept { return this->Now; }
  /// The pose that the hand asks for.
  const Eigen::Affine3d& Asked() const noexcept { return this->Hand; }
  /// The hand moves by `motion` (mm).
  void Move(const Vector3& motion) noexcept { this->Hand.pretranslate(motion); }
  /// The hand turns the surface about its pivot, by a vector of rotation (rad).
  void Turn(const Vector3& rotation) noexcept;
  /// The surface moves towards the balance of both forces, so that the sum of its energy and the
  /// spring's never rises (a step of the gradient, which the largest curvature bounds). Returns how
  /// far, mm.
  double Step() noexcept;
  /// N mm: the surface's energy and the spring's.
  double Energy() const noexcept;

private:
  Vector3 Stretch() const noexcept { return this->Now.translation() - this->Hand.translation(); }

  const HeldFit& Fit;
  double Spring;
  Eigen::Affine3d Now;
  Eigen::Affine3d Hand;
};

/// A pose that goes from one to another about a pivot, without a jump of its speed. Both turn, and
/// may grow, but do not shear.
class PoseRamp
{
public:
  /// `pivot` (mm) is a point of what is moved, before it is; `duration` (s) is above 0.
  PoseRamp(const Eigen::Affine3d& from, const Eigen::Affine3d& to, const Vector3& pivot,
           double duration) noexcept
      : From(from), To(to), Pivot(pivot), Duration(duration)
  {
  }

  /// At a time since the beginning (s).
  Eigen::Affine3d At(double time) const noexcept;
  bool IsOverAt(double time) const noexcept { return time >= this->Duration; }

private:
  Eigen::Affine3d From;
  Eigen::Affine3d To;
  Vector3 Pivot;
  double Duration;
};
} // namespace palpate
